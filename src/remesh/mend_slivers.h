// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The few bad triangles of a mesh, each with its neighbourhood alone: the rest of the mesh stays as it is.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "meniscus/mesh.h"
#include "remesh/first_look.h"
#include "remesh/mesh_changes.h"
#include "remesh/remesher.h"

namespace meniscus {

/// Mended meshes have no shorter edges, Å: coordinates with three decimals, or in single precision, stay apart. Where
/// usual edges are so short that many would be shorter, the limit is this part of a usual edge.
inline constexpr double kShortestEdge = 0.02;
inline constexpr double kShortestPart = 0.1;

struct SliverOptions {
    double needed_angle_deg = 5.0;    ///< below this, many changes are tried together where one is not enough
    double smallest_angle_deg = 5.0;  ///< triangles with a smaller one are mended
    double mended_angle_deg = 6.0;    ///< of a mended triangle, at least
    double edge = 0.5;                ///< usual length of edges, Å
    double longest_edge = 1.0;        ///< of new edges, Å
    bool search_everywhere = false;   ///< for places where the mesh passes through itself, not beside folds alone
    /// Triangles of a cube of four usual edges that may be bad, and that may pass through others: where there are more,
    /// the mesh is crumpled there and nothing is mended at all.
    std::size_t most_bad = std::numeric_limits<std::size_t>::max();
    std::size_t most_tangled = std::numeric_limits<std::size_t>::max();
    /// Where more triangles than these are crumpled, it is not tested whether they pass through each other: it takes
    /// long.
    std::size_t most_crumpled = std::numeric_limits<std::size_t>::max();
    /// Tries of many changes together, some milliseconds each, after which mending ends with what is mended.
    std::size_t most_hard_tries = std::numeric_limits<std::size_t>::max();
    /// Components of so many triangles at most are dropped where a triangle of theirs cannot be mended: the grid makes
    /// such tiny ones where two sheets all but touch.
    std::size_t tiny_component = 0;
    std::vector<bool> held{};  ///< per vertex, or empty: stays, and edges to others of its kind

    /// Å: triangles with shorter ones are mended, and none is made.
    double shortest_edge() const { return std::min(kShortestEdge, kShortestPart * edge); }
};

/// Mends triangles with small angles, with edges that are too short, such that face the wrong way and such that
/// pass through each other: flips, collapses and splits edges and moves vertices on the surface, where that keeps the
/// topology and passes the mesh through itself nowhere else. What cannot be mended stays, after a second try with more
/// round it, or is dropped with its component if that is tiny; the components that are left keep their order.
///
/// mesh      closed oriented 2-manifold with normals, its vertices on the surface. Positions, normals, components and
///           triangles are changed; other vertex arrays are the caller's to renumber
/// cost      a pass over the triangles, and about a millisecond for every triangle mended
MeshChanges mend_slivers(Mesh& mesh, const SliverOptions& options, const SurfaceProjector& project);

/// The same after a look at all triangles.
///
/// look   for the smallest angle and the shortest edge of the options
MeshChanges mend_slivers(Mesh& mesh, const SliverOptions& options, const SurfaceProjector& project, FirstLook look);

}  // namespace meniscus
