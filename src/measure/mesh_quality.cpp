// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/mesh_quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/parallel.h"
#include "geometry/local_features.h"
#include "geometry/triangle_tree.h"
#include "measure/triangle_parts.h"
#include "measure/weighted_distances.h"

namespace meniscus {
namespace {

constexpr std::size_t kChunk = 256;  // triangles per task

// Values that so many parts of all are below. Changes the order.
Percentiles percentiles(std::vector<double> values) {
    if (values.empty()) return {};
    const auto at = [&values](double part) {
        const double place = part * static_cast<double>(values.size() - 1);
        return values.begin() + static_cast<std::ptrdiff_t>(std::lround(place));
    };
    const auto low = at(0.05);
    const auto middle = at(0.5);
    const auto high = at(0.95);
    std::nth_element(values.begin(), middle, values.end());
    if (low < middle) std::nth_element(values.begin(), low, middle);
    if (high > middle) std::nth_element(middle + 1, high, values.end());
    return {*std::min_element(values.begin(), low + 1), *low, *middle, *high, *std::max_element(high, values.end())};
}

// Between the sides a and b of a triangle, opposite c.
double cosine_of_angle(double a, double b, double c) {
    return std::clamp((a * a + b * b - c * c) / (2.0 * a * b), -1.0, 1.0);
}

double degrees(double cosine) { return std::acos(cosine) * (180.0 / std::numbers::pi); }

// R / 2 r of sides a, b, c: a b c / ((b + c - a) (c + a - b) (a + b - c)).
double aspect_ratio(double a, double b, double c) {
    const double product = (b + c - a) * (c + a - b) * (a + b - c);
    return product > 0.0 ? a * b * c / product : std::numeric_limits<double>::infinity();
}

constexpr std::size_t kDivisions = 2;
constexpr std::size_t kSamples = kDivisions * kDivisions;  // points that stand for equal parts of a triangle

// Corners by their angles, see MeshQuality.
struct AngleCounts {
    decltype(MeshQuality::angles) of{};
    AngleCounts& operator+=(const AngleCounts& other) {
        for (std::size_t i = 0; i < of.size(); ++i) of[i] += other.of[i];
        return *this;
    }
};

}  // namespace

MeshQuality measure_quality(const Mesh& mesh) {
    const std::size_t count = mesh.triangles.size();
    std::vector<double> smallest(count);
    std::vector<double> ratios(count);
    std::vector<double> lengths(3 * count);  // of a closed mesh every edge is there twice
    const auto angles = parallel_sum<AngleCounts>(count, kChunk, [&](std::size_t begin, std::size_t end) {
        AngleCounts counts;
        for (std::size_t t = begin; t < end; ++t) {
            const auto& [i, j, k] = mesh.triangles[t];
            const double a = norm(mesh.vertices[k] - mesh.vertices[j]);
            const double b = norm(mesh.vertices[i] - mesh.vertices[k]);
            const double c = norm(mesh.vertices[j] - mesh.vertices[i]);
            smallest[t] = 180.0;
            for (const double cosine : {cosine_of_angle(b, c, a), cosine_of_angle(c, a, b), cosine_of_angle(a, b, c)}) {
                const double angle = degrees(cosine);
                smallest[t] = std::min(smallest[t], angle);
                ++counts.of[std::min(counts.of.size() - 1, static_cast<std::size_t>(angle / 10.0))];
            }
            ratios[t] = aspect_ratio(a, b, c);
            lengths[3 * t] = a;
            lengths[3 * t + 1] = b;
            lengths[3 * t + 2] = c;
        }
        return counts;
    });
    MeshQuality quality;
    quality.angles = angles.of;
    parallel_both([&] { quality.edges = percentiles(std::move(lengths)); },
                  [&] {
                      quality.smallest_angles = percentiles(std::move(smallest));
                      quality.aspect_ratios = percentiles(std::move(ratios));
                  });
    return quality;
}

TwoSidedDistance measure_distance(const Mesh& mesh, const AccessibleSurface& surface) {
    const TriangleTree triangles(mesh);
    WeightedDistances to_exact(kSamples * mesh.triangles.size());
    WeightedDistances from_exact(kSamples * mesh.triangles.size());
    parallel_chunks(mesh.triangles.size(), kChunk, [&](std::size_t begin, std::size_t end) {
        std::vector<Vec3> points;
        for (std::size_t t = begin; t < end; ++t)
            for_each_part(mesh, mesh.triangles[t], kDivisions, [&](const Vec3& point) { points.push_back(point); });
        const std::vector<NearestFeature> features = nearest_features(surface, points);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const double area = area_of(mesh, mesh.triangles[begin + i / kSamples]);
            const std::size_t sample = kSamples * begin + i;
            const double distance = features[i].signed_distance;
            to_exact.set(sample, std::abs(distance), area);
            from_exact.set(sample, triangles.distance(mesh, points[i] - distance * features[i].normal), area);
        }
    });
    return {std::move(to_exact).summarise(), std::move(from_exact).summarise()};
}

}  // namespace meniscus
