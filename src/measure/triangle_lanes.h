// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What triangles measure, many side by side, for several instruction sets.
//
// Every set gives the same bits: vectors hold different triangles, whose numbers never meet.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <string_view>
#include <vector>

#include "measure/lanes.h"
#include "meniscus/mesh.h"

namespace meniscus {

/// kLanes triangles, and what a kernel finds out about each.
struct TriangleLanes {
    std::array<VectorLanes, 3> points;   ///< corners, from an origin nearby
    std::array<VectorLanes, 3> normals;  ///< of the surface there; only for measure_with_parts, as are its curvatures,
                                         ///< without which it may turn as fast as it likes
    std::array<Lanes, 3> mean_curvatures{};
    std::array<Lanes, 3> gaussian_curvatures = unbounded();

    Lanes two_areas{};
    Lanes six_volumes{};  ///< over the origin
    /// Square of the tangent of the smallest corner, as a fraction of two finite numbers; 0 for a point.
    Lanes opposite{};
    Lanes adjacent{};
    /// Of the four parts of each, split at the middles of the arcs over its sides (measure/corrected.h). Of a triangle
    /// over a crease, which its parts follow: such that extrapolate gives what they measure.
    Lanes parts_two_areas{};
    Lanes parts_six_volumes{};

    void set_points(std::size_t lane, const Mesh& mesh, const Triangle& triangle, const Vec3& origin) {
        for (std::size_t corner = 0; corner < 3; ++corner)
            points[corner].set(lane, mesh.vertices[triangle[corner]] - origin);
    }
    void set_normals(std::size_t lane, const Mesh& mesh, const Triangle& triangle) {
        for (std::size_t corner = 0; corner < 3; ++corner) normals[corner].set(lane, mesh.normals[triangle[corner]]);
    }
    void set_curvatures(std::size_t lane, const Mesh& mesh, const Triangle& triangle) {
        for (std::size_t corner = 0; corner < 3; ++corner) {
            mean_curvatures[corner][lane] = mesh.mean_curvatures[triangle[corner]];
            gaussian_curvatures[corner][lane] = mesh.gaussian_curvatures[triangle[corner]];
        }
    }

private:
    static std::array<Lanes, 3> unbounded() {
        std::array<Lanes, 3> curvatures;
        for (Lanes& of_corner : curvatures) of_corner.fill(-std::numeric_limits<double>::infinity());
        return curvatures;
    }
};

struct TriangleKernels {
    std::string_view instructions;  ///< "plain", "avx2" or "avx512"

    /// All but the parts.
    void (*measure)(TriangleLanes& lanes);
    void (*measure_with_parts)(TriangleLanes& lanes);
};

/// Those that this machine can run, the plainest first.
std::vector<TriangleKernels> supported_triangle_kernels();

/// Those that MENISCUS_INSTRUCTIONS names, else the last of them (core/instructions.h); the same from the first call to
/// the end of the program.
const TriangleKernels& triangle_kernels();

}  // namespace meniscus
