// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A small part of a mesh with all that lies near it: small enough to be copied for every change that is tried.
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "meniscus/mesh.h"
#include "mesh/corner_numbers.h"
#include "remesh/remesher.h"

namespace meniscus {

/// Tangent of a triangle's smallest angle: √3 for an equilateral one, 0 for one without area.
double tangent_of_smallest_angle(const Vec3& a, const Vec3& b, const Vec3& c);

double tangent_of_degrees(double degrees);

/// Tangent of a triangle's smallest angle; less where an edge is shorter than `shortest`, below 0 where it faces away
/// from the surface at all its corners.
double goodness_of(const SurfacePoint& a, const SurfacePoint& b, const SurfacePoint& c, double shortest);

struct Patch {
    std::vector<SurfacePoint> points;
    std::vector<Triangle> triangles;  ///< a removed one has the same corner three times

    const Vec3& at(VertexId v) const { return points[v].position; }
    bool has(std::size_t triangle) const {
        return triangle < triangles.size() && triangles[triangle][0] != triangles[triangle][1];
    }

    /// Calls visit(triangle, which of its corners) for the triangles round a vertex.
    template <class Visit>
    void for_each_corner(VertexId v, const Visit& visit) const {
        for_each_equal(all_corners(triangles), v, [&](std::size_t corner) {
            if (has(corner / 3)) visit(corner / 3, corner % 3);
        });
    }

    /// The triangles round a vertex; all of them, if the vertex lies within the patch.
    std::vector<std::size_t> star(VertexId v) const;

    /// goodness_of
    double goodness(const Triangle& triangle, double shortest) const;

    /// The triangles on both sides of an edge and their other corners.
    struct Sides {
        std::size_t left = 0;  ///< runs from the edge's first end to the second
        std::size_t right = 0;
        VertexId left_corner = 0;
        VertexId right_corner = 0;
    };
    std::optional<Sides> sides(VertexId a, VertexId b) const;

    /// Turns an edge within its two triangles; all four corners must lie within the patch. Returns whether that left a
    /// manifold; if not, nothing changed.
    bool flip(VertexId a, VertexId b);
    /// Moves a vertex into its neighbour b. As flip.
    bool collapse(VertexId a, VertexId b);
    /// Puts a vertex, and with it two triangles, at the end of the lists: into the middle of an edge. As flip.
    bool split(VertexId a, VertexId b);
};

/// What may not become worse when triangles change.
struct PatchShape {
    double least_goodness = 0.0;
    double facing = 1.0;   ///< least cosine between a triangle's normal and the surface's at its corners
    double turn = 1.0;     ///< least cosine between the surface's normals at both ends of an edge
    double longest = 0.0;  ///< squared length of the longest edge, Å²
    double shortest = std::numeric_limits<double>::infinity();  ///< of the shortest, Å²
};
PatchShape shape_of(const Patch& patch, std::span<const std::size_t> triangles, double shortest);

/// Triangles that are not the same, or not in the same place, in two states of a patch. Of those told to the other
/// functions a state may lack some: they are left out.
std::vector<std::size_t> changed_triangles(const Patch& before, const Patch& after);

/// The first pair of triangles that pass through each other and have a corner in common with the marked vertices.
std::optional<std::pair<std::size_t, std::size_t>> first_crossing(const Patch& patch, const std::vector<bool>& marked);

/// How often the given triangles pass through each other or through others of the patch.
std::size_t count_crossings(const Patch& patch, std::span<const std::size_t> triangles);

}  // namespace meniscus
