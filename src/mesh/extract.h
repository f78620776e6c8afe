// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Marching cubes on the block-sparse grid: the zero set of sampled values as a closed triangle mesh.
#pragma once

#include <span>
#include <vector>

#include "grid/block_grid.h"
#include "grid/inside_bits.h"
#include "meniscus/mesh.h"

namespace meniscus {

/// Closest that a vertex comes to a node, as a fraction of the grid spacing.
///
/// Keeps vertices apart where the surface runs through nodes: all cut edges that meet in a node would have their vertex
/// there. At this distance every triangle has an area above 1e-4 h², and the vertex is off by at most 0.02 h, less than
/// the error of linear interpolation; a projection afterwards starts from distinct points and moves them so little that
/// they stay distinct.
inline constexpr double kMinEdgeFraction = 0.02;

/// The same for meshes whose vertices are put onto the surface afterwards: near the middle of the edges, which leaves
/// hardly a sliver.
inline constexpr double kSpreadFraction = 0.35;

/// Triangles of the zero set of a sampled function; only `vertices` and `triangles` of the mesh are filled.
///
/// values   one per node of the grid, finite, negative inside; 0 counts as outside
/// nearest  how near vertices may come to nodes, as a fraction of the spacing
/// returns  vertices on the grid edges between an inside and an outside node, where linear interpolation vanishes (but
///          see `nearest`), each used by at least one triangle; triangles counter-clockwise seen from outside.
///          Always an oriented 2-manifold whose boundary, if any, runs where blocks are missing: closed if every node
///          of every cell with both signs exists. Order and bits do not depend on the number of threads.
/// throws   LimitError where triangles might be more than 2^32 - 1
/// cost     O(nodes), with about 2.5 bytes of scratch memory per node
/// source   Lorensen & Cline 1987, with the cases of mesh/cell_cases.h
Mesh extract_zero_set(const BlockGrid& grid, std::span<const float> values, double nearest = kMinEdgeFraction);

/// The same where nothing but the sides of the nodes is known: vertices in the middle of the edges, for whoever puts
/// them onto the surface.
///
/// inside   of each block of the grid
Mesh extract_between(const BlockGrid& grid, std::vector<InsideBits> inside);

}  // namespace meniscus
