// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/mesh_distance.h"

#include <cmath>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "measure/triangle_parts.h"
#include "measure/weighted_distances.h"
#include "nearest/local_features.h"
#include "space/triangle_tree.h"

namespace meniscus {
namespace {

constexpr std::size_t kTrianglesPerTask = 256;  // triangles per task
constexpr std::size_t kDivisions = 2;
constexpr std::size_t kSamples = kDivisions * kDivisions;  // points that stand for equal parts of a triangle

// The triangles begin · step, (begin + 1) · step and so on up to end · step, without the last one.
struct SomeTriangles {
    std::size_t step;
    std::size_t begin;
    std::size_t end;
};

// Calls visit(sample, triangle, point, nearest feature) for kSamples points of each triangle, in order.
template <class Visit>
void look_at_parts(const Mesh& mesh, const SomeTriangles& some, const AccessibleSurface& surface, const Visit& visit) {
    const auto [step, begin, end] = some;
    std::vector<Vec3> points;
    for (std::size_t k = begin; k < end; ++k)
        for_each_part(mesh, mesh.triangles[k * step], kDivisions, [&](const Vec3& p) { points.push_back(p); });
    const std::vector<NearestFeature> features = nearest_features(surface, points);
    for (std::size_t i = 0; i < points.size(); ++i)
        visit(kSamples * begin + i, (begin + i / kSamples) * step, points[i], features[i]);
}

struct DistanceSums {
    double distance = 0.0;  // times area
    double area = 0.0;

    DistanceSums& operator+=(const DistanceSums& other) {
        distance += other.distance;
        area += other.area;
        return *this;
    }
};

}  // namespace

TwoSidedDistance measure_distance(const Mesh& mesh, const ExactSurface& exact) {
    const AccessibleSurface& surface = exact.accessible();
    const TriangleTree triangles(mesh);
    WeightedDistances to_exact(kSamples * mesh.triangles.size());
    WeightedDistances from_exact(kSamples * mesh.triangles.size());
    parallel_chunks(mesh.triangles.size(), kTrianglesPerTask, [&](std::size_t begin, std::size_t end) {
        look_at_parts(mesh, {1, begin, end}, surface,
                      [&](std::size_t sample, std::size_t triangle, const Vec3& point, const NearestFeature& nearest) {
                          const double area = area_of(mesh, mesh.triangles[triangle]);
                          const Vec3 foot = point - nearest.signed_distance * nearest.normal;
                          to_exact.set(sample, std::abs(nearest.signed_distance), area);
                          from_exact.set(sample, triangles.distance(mesh, foot, static_cast<std::uint32_t>(triangle)),
                                         area);
                      });
    });
    return {std::move(to_exact).summarise(), std::move(from_exact).summarise()};
}

double mean_distance_to_exact(const Mesh& mesh, const AccessibleSurface& surface, std::size_t step) {
    const std::size_t count = (mesh.triangles.size() + step - 1) / step;
    const auto sums = parallel_sum<DistanceSums>(count, kTrianglesPerTask, [&](std::size_t begin, std::size_t end) {
        DistanceSums part;
        look_at_parts(mesh, {step, begin, end}, surface,
                      [&](std::size_t, std::size_t triangle, const Vec3&, const NearestFeature& nearest) {
                          const double area = area_of(mesh, mesh.triangles[triangle]);
                          part += {area * std::abs(nearest.signed_distance), area};
                      });
        return part;
    });
    return sums.area > 0.0 ? sums.distance / sums.area : 0.0;
}

}  // namespace meniscus
