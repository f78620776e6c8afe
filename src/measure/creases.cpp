// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/creases.h"

#include <array>
#include <bit>
#include <cstddef>

#include "core/bits.h"
#include "measure/corrected.h"

namespace meniscus {

bool knows_creases(const Mesh& mesh) {
    const std::size_t n = mesh.vertices.size();
    return mesh.normals.size() == n && mesh.mean_curvatures.size() == n && mesh.gaussian_curvatures.size() == n;
}

void follow_creases(const Mesh& mesh, std::span<const Triangle> triangles, std::uint64_t looked_at,
                    TriangleLanes& lanes) {
    CreasedLanes some;
    std::array<std::size_t, CreasedLanes::kCount> lane_of{};
    while (looked_at != 0) {
        std::size_t count = 0;
        for (; looked_at != 0 && count < CreasedLanes::kCount; looked_at &= looked_at - 1, ++count) {
            const auto lane = static_cast<std::size_t>(std::countr_zero(looked_at));
            lane_of[count] = lane;
            for (std::size_t k = 0; k < 3; ++k) {
                const VertexId v = triangles[lane][k];
                CreasedLanes::Corner& corner = some.corners[k];
                corner.point.set(count, lanes.points[k].at(lane));
                corner.normal.set(count, lanes.normals[k].at(lane));
                corner.mean_curvature[count] = mesh.mean_curvatures[v];
                corner.gaussian_curvature[count] = mesh.gaussian_curvatures[v];
            }
        }
        for_each_bit(triangle_kernels().measure_over_creases(some, count), [&](std::size_t i) {
            const std::size_t lane = lane_of[i];
            lanes.parts_two_areas[lane] = static_cast<float>(parts_of(lanes.two_areas[lane], some.two_areas[i]));
            lanes.parts_six_volumes[lane] = parts_of(lanes.six_volumes[lane], some.six_volumes[i]);
        });
    }
}

}  // namespace meniscus
