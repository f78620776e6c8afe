// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How the triangles of a mesh hang together.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "meniscus/mesh.h"

namespace meniscus {

/// See MeshMeasures for `closed` and `manifold`.
struct MeshTopology {
    bool closed = true;
    bool manifold = true;
    std::size_t edges = 0;  ///< pairs of different vertices with at least one triangle
};

/// Examines the triangles round every vertex. A triangle with a repeated vertex is neither closed nor manifold; a
/// vertex without triangles is not manifold. A mesh of nothing is both.
///
/// Precondition: every corner is below vertex_count.
/// cost     O(n) for a mesh of bounded vertex degree, O(n log n) else; a byte of scratch memory per triangle
MeshTopology examine_topology(std::size_t vertex_count, std::span<const Triangle> triangles);

/// What tells whether as many triangles run along every edge in one direction as in the other: then the sum over all
/// of them is 0. A surface for which that holds covers every place of a plane as often with one side as with the other,
/// wherever its vertices are sent; so the signed areas there sum to nothing. Vertices are sent by a hash, and the sum
/// is taken modulo 2^64: it does not vanish by chance in the life of the program.
///
/// cost     O(n), a twentieth of examine_topology
std::uint64_t signed_areas(std::span<const Triangle> some);

/// The same as examine_topology of what is a manifold by the way it was made, open or closed, with every vertex in use:
/// where such a mesh is balanced nothing else is left to examine.
///
/// areas_of_all   signed_areas of all triangles
MeshTopology topology_of_manifold(std::size_t vertex_count, std::span<const Triangle> triangles,
                                  std::uint64_t areas_of_all);

}  // namespace meniscus
