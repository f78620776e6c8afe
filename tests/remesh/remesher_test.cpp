// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/remesher.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <numbers>
#include <set>
#include <vector>

#include "core/parallel.h"
#include "meniscus/threads.h"
#include "remesh/ridges.h"
#include "remesh/self_intersections.h"
#include "remesh/working_mesh.h"
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
Mesh coarse_mesh_of(const Shape& shape, double reach) {
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
    const Mesh mesh = coarse_mesh_of(torus, 5.0);
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
    const Mesh mesh = coarse_mesh_of(torus, 5.0);
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
    const Mesh mesh = coarse_mesh_of(distance, 3.0);
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

// Splitting an edge gives half-edges of its neighbours, which are still to be split, other edges.
TEST(Ridges, GoIntoTheEdgesThatCrossThem) {
    const Lens lens;
    const Vec3 shift{0.05, 0.12, 0.17};  // no node lies in the plane of the rim
    const auto distance = [&](const Vec3& p) { return std::max(lens.upper(p - shift), lens.lower(p - shift)); };
    Mesh shifted = coarse_mesh_of(distance, 3.2);
    for (Vec3& v : shifted.vertices) v = v - shift;
    WorkingMesh mesh(shifted, 0.5);
    const SurfaceProjector project = onto(lens);
    project(mesh.points);
    const auto count_crossing = [&] {
        std::size_t count = 0;
        mesh.for_each_edge([&](HalfEdge h) {
            const double from = mesh.at(mesh.edges.origin(h)).z;
            const double to = mesh.at(mesh.edges.target(h)).z;
            count += from * to < 0.0 && std::min(std::abs(from), std::abs(to)) > 0.02 ? 1 : 0;
        });
        return count;
    };
    ASSERT_GT(count_crossing(), 30u);
    insert_ridges(mesh, project, {{}, 0.0});
    EXPECT_EQ(count_crossing(), 0u);
    EXPECT_GT(std::count(mesh.holds.begin(), mesh.holds.end(), Hold::Ridge), 30);
}

TEST(Remesher, RidgesLeadThroughNothing) {
    const Lens lens;
    const auto distance = [&](const Vec3& p) { return std::max(lens.upper(p), lens.lower(p)); };
    const Mesh mesh = coarse_mesh_of(distance, 3.0);
    for (const double edge : {0.3, 0.5, 1.0}) {
        const Mesh even = remesh(mesh, {.edge = edge, .keep_ridges = true}, onto(lens));
        expect_closed_manifold(even);
        EXPECT_TRUE(places_of_self_intersections(even).empty()) << edge;
        EXPECT_GT(measure_mesh(even).smallest_angle_deg, 15.0) << edge;
    }
}

TEST(Remesher, SmallPiecesHaveNoShortEdges) {
    for (const double radius : {1.3, 1.4, 1.5, 1.6, 1.7, 2.0, 2.5}) {
        const Sphere sphere{{0.1, -0.2, 0.05}, radius};
        expect_even(remesh(extracted_sphere(sphere, 0.4), {.edge = 2.0}, onto(sphere, 1.0 / radius)), 2.0);
    }
}

// What is near a call's points is gathered once for all of them.
TEST(Remesher, ProjectsNeighboursTogether) {
    const Sphere sphere{{}, 12.0};
    const SurfaceProjector project = onto(sphere, 1.0 / sphere.radius);
    std::atomic<std::size_t> cells{0};
    std::atomic<std::size_t> points{0};
    const auto counting = [&](std::span<SurfacePoint> chunk) {
        std::set<std::array<int, 3>> seen;
        const auto cell = [](double x) { return static_cast<int>(std::floor(x / 6.0)); };
        for (const SurfacePoint& point : chunk)
            seen.insert({cell(point.position.x), cell(point.position.y), cell(point.position.z)});
        cells += seen.size();
        points += chunk.size();
        project(chunk);
    };
    const Mesh mesh = extracted_sphere(sphere, 0.8);
    remesh(mesh, {.edge = 0.6}, counting);
    EXPECT_GT(points, 10 * mesh.vertices.size());
    EXPECT_LT(50 * cells, points);
}

TEST(Remesher, GivesTheSameForAnyNumberOfThreads) {
    const Torus torus{3.0, 1.2};
    const Mesh mesh = coarse_mesh_of(torus, 5.0);
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
