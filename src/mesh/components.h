// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Connected pieces of a mesh: outer surfaces and the walls of cavities.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// The number of each vertex's piece, in the order of their first vertices.
///
/// cost     O(n) for n vertices and triangles
std::vector<std::uint32_t> pieces_by_first_vertex(const Mesh& mesh);

/// By falling absolute volume, but with the largest outer piece (positive volume) first, if there is one; equals stay
/// in order. Returns which piece becomes the first, the second and so on.
std::vector<std::uint32_t> final_order(const std::vector<MeshComponent>& pieces);

/// The connected pieces of a mesh.
struct Components {
    std::vector<std::uint32_t> of_vertex;  ///< number of each vertex's piece
    std::vector<MeshComponent> pieces;     ///< with area and signed volume
};

/// Finds the connected pieces of a mesh.
///
/// Pieces are numbered in their final_order, outer pieces and cavities in one row; ties by the smallest vertex number.
/// A vertex without triangles is a piece of its own.
///
/// cost     O(n) for n vertices and triangles
Components find_components(const Mesh& mesh);

/// Puts the pieces of a labelling into their final order, in which it numbers them anew.
void renumber(std::vector<MeshComponent>& pieces, std::vector<std::uint32_t>& of_vertex);

/// find_components, kept in mesh.components.
std::vector<MeshComponent> label_components(Mesh& mesh);

/// Drops the pieces that `keep`, one entry per number in mesh.components, says no to. The mesh must have no other
/// vertex array yet; the pieces that stay are numbered anew.
void keep_components(Mesh& mesh, const std::vector<bool>& keep);

/// How many vertices each piece of a labelling has, and which comes first.
struct PieceVertices {
    std::vector<std::size_t> counts;
    std::vector<VertexId> first;
};
/// throws   UsageError for a number that is not smaller than there are vertices
PieceVertices vertices_of_pieces(std::span<const std::uint32_t> of_vertex);

/// Size, area and signed volume of the pieces that a labelling of the vertices tells apart.
/// Sums run in the order of the triangles; volumes are taken from a vertex of each piece, so that they do not lose
/// digits far from the origin.
std::vector<MeshComponent> measure_components(const Mesh& mesh, std::span<const std::uint32_t> of_vertex);

}  // namespace meniscus
