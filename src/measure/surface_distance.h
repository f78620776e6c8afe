// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The signed distance of points to a mesh, or to an exact surface; points spread over a mesh.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "geometry/accessible_surface.h"
#include "meniscus/mesh.h"
#include "space/triangle_tree.h"

namespace meniscus {

/// A mesh, or the SES behind it if there is one. Both must outlive this.
class SurfaceDistance {
public:
    SurfaceDistance(const Mesh& mesh, const AccessibleSurface* exact);

    /// Å, positive outside; in the order of the points. Parallel.
    std::vector<double> operator()(std::span<const Vec3> points) const;

private:
    const Mesh& mesh_;
    const AccessibleSurface* exact_;
    TriangleTree triangles_;
};

/// Points, each with the area that it stands for, Å².
struct WeightedPoints {
    std::vector<Vec3> points;
    std::vector<double> areas;
};

/// The centroids of equal parts of every triangle, `density` per Å² at least and no fewer than four.
/// throws   LimitError for more than fit into memory
WeightedPoints spread_over_triangles(const Mesh& mesh, double density);

/// Moves points to the nearest ones of a SES.
void move_onto(const AccessibleSurface& surface, std::vector<Vec3>& points);

}  // namespace meniscus
