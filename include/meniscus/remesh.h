// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Remeshing: even triangles of a chosen size instead of those of the grid.
#pragma once

#include <cmath>
#include <cstdint>

namespace meniscus {

/// Where the vertices of even triangles lie. Normals, curvatures and labels are those of the surface next to a vertex.
enum class Corners : std::uint8_t {
    /// As near to the surface as keeps the triangles within kDistancePerSquareEdge edge² of the exact surface on
    /// average over the area: on molecules a third as far off as Balanced, and as far only if nothing nearer will do.
    /// Creases of the SAS and of van der Waals surfaces may be farther. The same as OnSurface with keep_ridges or
    /// Method::Gaussian.
    Near,
    OnSurface,  ///< on the surface: the mean distance of triangles is 0.036 edge² Å on molecules (edge in Å)
    Balanced,   ///< off the surface, so that triangles lie on both sides of it, half as far away as with OnSurface
};

/// Largest mean distance of triangles from the surface, divided by edge², that Corners::Near allows, Å⁻¹.
inline constexpr double kDistancePerSquareEdge = 0.03;

/// Even triangles of a chosen size (isotropic remeshing) instead of those of marching cubes.
struct RemeshOptions {
    /// Length of edges, Å; 0 leaves the mesh of the grid. Nearly all edges are 0.6 to 1.5 times as long, on average 0.8
    /// times.
    double edge = 0.0;
    bool adaptive = false;     ///< shorter edges where the surface bends more, longer where it is flat
    bool keep_ridges = false;  ///< edges of the mesh run along creases of the surface
    Corners corners = Corners::Near;
    /// Handles narrower than an edge are cut, tunnels closed, and smaller pieces dropped, except the largest outer one.
    /// Otherwise the topology is that of the mesh of the grid.
    bool simplify_topology = false;

    /// A surface whose corrected area is more than 0.5 % off the exact area is computed again with half the spacing
    /// and, if need be, a quarter, unless its flow does not converge, it would cover more than 150,000 squares of that
    /// grid, or simplify_topology is set.
    bool finer_grid = false;

    /// Whether triangles are made even.
    bool is_on() const { return edge > 0.0; }
};

/// Largest grid spacing with which triangles can be made even, Å: coarser grids do not resolve the surface well enough.
inline constexpr double kCoarsestForRemeshing = 0.5;

/// Number of vertices of a mesh of even triangles, divided by area / edge².
inline constexpr double kVerticesPerSquareEdge = 1.82;

/// The RemeshOptions::edge, Å, that gives a number of vertices per Å² of the surface (> 0).
inline double edge_of_density(double vertices_per_square_angstrom) {
    return std::sqrt(kVerticesPerSquareEdge / vertices_per_square_angstrom);
}

}  // namespace meniscus
