// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/remesher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "core/parallel.h"
#include "remesh/self_intersections.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace meniscus::testing {
namespace {

// Points to the nearest one of a shape, by its signed distance.
template <class Shape>
SurfaceProjector onto(const Shape& shape, double curvature) {
    return [shape, curvature](std::span<SurfacePoint> points) {
        constexpr double kStep = 1e-5;
        for (SurfacePoint& point : points) {
            for (int i = 0; i < 2; ++i) {
                const auto slope = [&](const Vec3& along) {
                    return shape(point.position + kStep * along) - shape(point.position - kStep * along);
                };
                point.normal = normalised(Vec3{slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})});
                point.position = point.position - shape(point.position) * point.normal;
            }
            point.curvature = curvature;
        }
    };
}

template <class Shape>
Mesh extracted(const Shape& shape, double reach) {
    const SampledField field = sample_box(0.4, {-reach, -reach, -reach}, {reach, reach, reach}, shape);
    return extract_zero_set(field.grid, field.values);
}

std::vector<double> edge_lengths(const Mesh& mesh) {
    std::vector<double> lengths;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            if (t[k] < t[(k + 1) % 3]) lengths.push_back(norm(mesh.vertices[t[(k + 1) % 3]] - mesh.vertices[t[k]]));
    std::sort(lengths.begin(), lengths.end());
    return lengths;
}

void expect_even(const Mesh& mesh, double edge) {
    expect_closed_manifold(mesh);
    const std::vector<double> lengths = edge_lengths(mesh);
    const auto within = std::count_if(lengths.begin(), lengths.end(),
                                      [&](double length) { return length > 0.6 * edge && length < 1.5 * edge; });
    EXPECT_GT(static_cast<double>(within), 0.95 * static_cast<double>(lengths.size()));
    EXPECT_GT(measure_mesh(mesh).smallest_angle_deg, 28.0);
    EXPECT_TRUE(places_of_self_intersections(mesh).empty());
}

TEST(Remesher, MakesASphereEven) {
    const Sphere sphere{{0.1, -0.2, 0.05}, 3.0};
    const Mesh mesh = extracted_sphere(sphere, 0.4);
    for (const double edge : {0.3, 0.6, 1.0, 2.0}) {
        const Mesh even = remesh(mesh, {.edge = edge}, onto(sphere, 1.0 / sphere.radius));
        expect_even(even, edge);
        for (const Vec3& v : even.vertices) EXPECT_NEAR(sphere(v), 0.0, 1e-6);
    }
}

TEST(Remesher, KeepsTheHoleOfATorus) {
    const Torus torus{3.0, 1.2};
    const Mesh mesh = extracted(torus, 5.0);
    const Mesh even = remesh(mesh, {.edge = 0.8}, onto(torus, 1.0 / torus.minor));
    expect_even(even, 0.8);
    EXPECT_EQ(measure_mesh(even).euler_characteristic, 0);
}

TEST(Remesher, DensityCountsVertices) {
    const Sphere sphere{{}, 4.0};
    const Mesh mesh = extracted_sphere(sphere, 0.4);
    const double area = 4.0 * std::numbers::pi * 16.0;
    for (const double density : {1.0, 3.0}) {
        const Mesh even = remesh(mesh, {.edge = edge_of_density(density)}, onto(sphere, 0.25));
        EXPECT_NEAR(static_cast<double>(even.vertices.size()), density * area, 0.08 * density * area);
    }
}

TEST(Remesher, AdaptsToCurvature) {
    const Torus torus{3.0, 1.2};
    const Mesh mesh = extracted(torus, 5.0);
    const auto count = [&](double curvature) {
        return remesh(mesh, {.edge = 0.8, .adaptive = true}, onto(torus, curvature)).vertices.size();
    };
    EXPECT_GT(count(2.0), 2 * count(0.5));
}

// A lens: two caps that meet in a sharp circle.
struct Lens {
    Sphere upper{{0, 0, -2.0}, 3.0};
    Sphere lower{{0, 0, 2.0}, 3.0};
    double rim() const { return std::sqrt(9.0 - 4.0); }
};

SurfaceProjector onto(const Lens& lens) {
    return [lens](std::span<SurfacePoint> points) {
        for (SurfacePoint& point : points) {
            const Vec3 q = point.position;
            const double across = std::hypot(q.x, q.y);
            const Sphere& cap = q.z >= 0.0 ? lens.upper : lens.lower;
            const Vec3 radial = normalised(q - cap.centre);
            const Vec3 foot = cap.centre + cap.radius * radial;
            const bool beyond = across > 0.0 && (foot.z >= 0.0) != (q.z >= 0.0);
            const double scale = across > 0.0 ? lens.rim() / across : 0.0;
            point = {beyond ? Vec3{scale * q.x, scale * q.y, 0.0} : foot, radial, 1.0 / cap.radius};
        }
    };
}

TEST(Remesher, KeepsRidgesIfAsked) {
    const Lens lens;
    const auto distance = [&](const Vec3& p) { return std::max(lens.upper(p), lens.lower(p)); };
    const Mesh mesh = extracted(distance, 3.0);
    const Mesh even = remesh(mesh, {.edge = 0.5, .keep_ridges = true}, onto(lens));
    expect_closed_manifold(even);
    std::size_t on_rim = 0;
    std::size_t across = 0;
    for (const Triangle& t : even.triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& a = even.vertices[t[k]];
            const Vec3& b = even.vertices[t[(k + 1) % 3]];
            across += a.z * b.z < -1e-3 ? 1 : 0;
            on_rim += std::abs(a.z) < 0.02 && std::abs(b.z) < 0.02 ? 1 : 0;
        }
    EXPECT_GT(on_rim, 2 * 20u);
    EXPECT_LE(across, 2u);
    const Mesh round = remesh(mesh, {.edge = 0.5}, onto(lens));
    EXPECT_GT(measure_mesh(even).volume, measure_mesh(round).volume);
}

TEST(Remesher, GivesTheSameForAnyNumberOfThreads) {
    const Torus torus{3.0, 1.2};
    const Mesh mesh = extracted(torus, 5.0);
    const auto with = [&](int threads) {
        const ThreadLimit limit(threads);
        return remesh(mesh, {.edge = 0.6}, onto(torus, 1.0));
    };
    const Mesh one = with(1);
    const Mesh two = with(2);
    EXPECT_EQ(one.vertices, two.vertices);
    EXPECT_EQ(one.triangles, two.triangles);
}

}  // namespace
}  // namespace meniscus::testing
