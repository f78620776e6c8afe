// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What triangles measure, many side by side, for several instruction sets.
//
// Every set gives the same bits: vectors hold different triangles, whose numbers never meet.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>
#include <vector>

#include "measure/lanes.h"
#include "meniscus/mesh.h"

namespace meniscus {

/// kLanes triangles, and what a kernel finds out about each.
struct TriangleLanes {
    std::array<VectorLanes, 3> points;   ///< corners, from an origin nearby
    std::array<VectorLanes, 3> normals;  ///< of the surface there; only for measure_with_parts

    Lanes two_areas{};
    Lanes six_volumes{};  ///< over the origin
    /// Square of the tangent of the smallest corner, as a fraction of two finite numbers; 0 for a point.
    Lanes opposite{};
    Lanes adjacent{};
    /// Of the four parts of each, split at the middles of the arcs over its sides (measure/corrected.h).
    Lanes parts_two_areas{};
    Lanes parts_six_volumes{};
    /// Positive where the surface turns so fast along a side that it may have a crease there (measure/creases.h).
    Lanes creased{};

    void set_points(std::size_t lane, const Mesh& mesh, const Triangle& triangle, const Vec3& origin) {
        for (std::size_t corner = 0; corner < 3; ++corner)
            points[corner].set(lane, mesh.vertices[triangle[corner]] - origin);
    }
    void set_normals(std::size_t lane, const Mesh& mesh, const Triangle& triangle) {
        for (std::size_t corner = 0; corner < 3; ++corner) normals[corner].set(lane, mesh.normals[triangle[corner]]);
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
