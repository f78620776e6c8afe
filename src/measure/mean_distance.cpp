// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/mean_distance.h"

#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "geometry/local_features.h"
#include "measure/triangle_parts.h"

namespace meniscus {
namespace {

constexpr std::size_t kChunk = 256;  // triangles looked at per task

struct Sums {
    double distance = 0.0;  // times area
    double area = 0.0;

    Sums& operator+=(const Sums& other) {
        distance += other.distance;
        area += other.area;
        return *this;
    }
};

}  // namespace

double mean_distance_to_exact(const Mesh& mesh, const AccessibleSurface& surface, std::size_t step) {
    const std::size_t count = (mesh.triangles.size() + step - 1) / step;
    const auto sums = parallel_sum<Sums>(count, kChunk, [&](std::size_t begin, std::size_t end) {
        std::vector<Vec3> points;
        for (std::size_t k = begin; k < end; ++k)
            for_each_part(mesh, mesh.triangles[k * step], kDivisions, [&](const Vec3& p) { points.push_back(p); });
        const std::vector<NearestFeature> features = nearest_features(surface, points);
        Sums part;
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double area = area_of(mesh, mesh.triangles[(begin + i / kSamples) * step]);
            part += {area * std::abs(features[i].signed_distance), area};
        }
        return part;
    });
    return sums.area > 0.0 ? sums.distance / sums.area : 0.0;
}

}  // namespace meniscus
