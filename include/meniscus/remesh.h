// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How the mesh of a surface is made even.
#pragma once

#include <cmath>
#include <cstdint>

namespace meniscus {

/// Where the corners of even triangles lie. Normals, curvatures and labels are those of the surface next to a corner.
enum class Corners : std::uint8_t {
    /// Off the surface by as little as keeps the triangles within kDistancePerSquareEdge edge² of the exact surface, by
    /// area: on molecules a third of what Balanced takes, and all of it where less does not do. Creases of the SAS
    /// and of van der Waals surfaces may still be farther. With keep_ridges and Method::Gaussian it becomes OnSurface.
    Near,
    OnSurface,  ///< all of them: on molecules triangles are 0.036 edge² from the surface in the mean (Å, edge in Å)
    Balanced,   ///< so far off the surface that triangles lie on both sides of it, half as far away as by OnSurface
};

/// What Corners::Near keeps to, Å⁻¹.
inline constexpr double kDistancePerSquareEdge = 0.03;

/// Even triangles of a chosen size instead of those that marching cubes cuts out of the grid.
struct RemeshOptions {
    /// Length to be kept to, Å; 0 leaves the mesh of the grid. Nearly all edges are from 0.6 to 1.5 times as long, 0.8
    /// times on average.
    double edge = 0.0;
    bool adaptive = false;     ///< shorter where the surface bends more, longer where it is flat
    bool keep_ridges = false;  ///< edges of the mesh run along creases of the surface
    Corners corners = Corners::Near;
    /// Handles and tunnels narrower than an edge are cut and capped, pieces smaller than one vanish, but never the
    /// largest outer one. Without this the topology is that of the mesh of the grid.
    bool simplify_topology = false;

    /// A surface whose corrected area is more than 0.5 % from the exact one is computed again on a grid of half the
    /// spacing, and if need be of a quarter, where that covers no more than 150,000 squares of the grid. Not if its
    /// flow has not converged.
    bool finer_grid = false;

    bool is_on() const { return edge > 0.0; }
};

/// Widest spacing of a grid whose mesh can be made even, Å: wider ones do not know the surface well enough.
inline constexpr double kCoarsestForRemeshing = 0.5;

/// Vertices of an even mesh per area / edge².
inline constexpr double kVerticesPerSquareEdge = 1.82;

/// The RemeshOptions::edge that gives so many vertices per Å² of the surface.
inline double edge_of_density(double vertices_per_square_angstrom) {
    return std::sqrt(kVerticesPerSquareEdge / vertices_per_square_angstrom);
}

}  // namespace meniscus
