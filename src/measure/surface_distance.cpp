// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/surface_distance.h"

#include <algorithm>
#include <cmath>

#include "core/number_text.h"
#include "core/parallel.h"
#include "measure/triangle_parts.h"
#include "meniscus/errors.h"
#include "nearest/local_features.h"
#include "platform/memory.h"

namespace meniscus {
namespace {

constexpr std::size_t kPointsPerTask = 1024;  // points or triangles per task

// A point, its area, and what is found out about it.
constexpr double kBytesPerPoint = 96.0;

std::size_t divisions_of(double area, double density) {
    return static_cast<std::size_t>(std::max(2.0, std::ceil(std::sqrt(density * area))));
}

// How many points the triangles before each have, and all.
std::vector<std::size_t> numbers_of_points(const Mesh& mesh, double density) {
    std::vector<std::size_t> sums{0};
    sums.reserve(mesh.triangles.size() + 1);
    double total = 0.0;
    const double most = static_cast<double>(available_memory()) / kBytesPerPoint;
    for (const Triangle& t : mesh.triangles) {
        const double area = area_of(mesh, t);
        const auto n = static_cast<double>(divisions_of(area, density));
        total += n * n;
        if (!(total < most))
            throw LimitError(joined(in_short(density, 3), " points per Å² would not fit into memory; choose fewer"));
        sums.push_back(static_cast<std::size_t>(total));
    }
    return sums;
}

}  // namespace

SurfaceDistance::SurfaceDistance(const Mesh& mesh, const AccessibleSurface* exact)
    : mesh_(mesh), exact_(exact), triangles_(exact == nullptr ? mesh : Mesh{}) {}

std::vector<double> SurfaceDistance::operator()(std::span<const Vec3> points) const {
    std::vector<double> result(points.size());
    parallel_chunks(points.size(), kPointsPerTask, [&](std::size_t begin, std::size_t end) {
        if (exact_ == nullptr) {
            std::uint32_t near = 0;  // points that follow each other are mostly neighbours
            for (std::size_t i = begin; i < end; ++i) {
                const NearestOnMesh nearest = triangles_.nearest(mesh_, points[i], near);
                result[i] = nearest.signed_distance;
                near = nearest.triangle;
            }
            return;
        }
        const auto features = nearest_features(*exact_, points.subspan(begin, end - begin));
        for (std::size_t i = begin; i < end; ++i) result[i] = features[i - begin].signed_distance;
    });
    return result;
}

WeightedPoints spread_over_triangles(const Mesh& mesh, double density) {
    const std::vector<std::size_t> begins = numbers_of_points(mesh, density);
    WeightedPoints spread{std::vector<Vec3>(begins.back()), std::vector<double>(begins.back())};
    parallel_for(mesh.triangles.size(), kPointsPerTask, [&](std::size_t t) {
        const double area = area_of(mesh, mesh.triangles[t]);
        const std::size_t count = begins[t + 1] - begins[t];
        std::size_t next = begins[t];
        for_each_part(mesh, mesh.triangles[t], divisions_of(area, density), [&](const Vec3& point) {
            spread.points[next] = point;
            spread.areas[next++] = area / static_cast<double>(count);
        });
    });
    return spread;
}

void move_onto(const AccessibleSurface& surface, std::vector<Vec3>& points) {
    parallel_chunks(points.size(), kPointsPerTask, [&](std::size_t begin, std::size_t end) {
        const auto features = nearest_features(surface, std::span(points).subspan(begin, end - begin));
        for (std::size_t i = begin; i < end; ++i)
            points[i] = points[i] - features[i - begin].signed_distance * features[i - begin].normal;
    });
}

}  // namespace meniscus
