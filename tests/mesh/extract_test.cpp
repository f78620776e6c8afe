// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/extract.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/parallel.h"
#include "meniscus/threads.h"
#include "mesh/cut_edges.h"
#include "support/inside_bits.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace meniscus {
namespace {

using testing::SampledField;
using testing::Sphere;
using testing::Torus;

constexpr double kPi = std::numbers::pi;

Mesh extract(const SampledField& field) { return extract_zero_set(field.grid, field.values); }

TEST(Extract, NothingFromAnEmptyGrid) {
    const Mesh mesh = extract_zero_set(BlockGrid(1.0, {}, {}), {});
    EXPECT_TRUE(mesh.vertices.empty());
    EXPECT_TRUE(mesh.triangles.empty());
}

TEST(Extract, NothingWhereAllSignsAgree) {
    for (const float value : {-1.0F, 0.0F, 1.0F}) {
        const SampledField field =
            testing::sample(BlockGrid(1.0, {}, testing::box_of_blocks({}, {.z = 1, .y = 1, .x = 1})),
                            [&](const Vec3&) { return value; });
        EXPECT_TRUE(extract(field).vertices.empty());
    }
}

TEST(Extract, OneInsideNodeGivesAnOctahedron) {
    // At the corner of eight blocks, so that every neighbour takes part.
    const SampledField field =
        testing::sample_box(0.5, {-1, -1, -1}, {1, 1, 1}, [](const Vec3& p) { return norm(p) - 0.25; });
    const Mesh mesh = extract(field);
    testing::expect_closed_manifold(mesh);
    ASSERT_EQ(mesh.vertices.size(), 6U);
    EXPECT_EQ(mesh.triangles.size(), 8U);
    for (const Vec3& v : mesh.vertices) EXPECT_NEAR(norm(v), 0.25, 1e-12);
    EXPECT_NEAR(testing::volume_of(mesh), 4.0 / 3.0 * 0.25 * 0.25 * 0.25, 1e-12);
}

TEST(Extract, SphereIsClosedAndConvergesWithSecondOrder) {
    const Sphere sphere{.centre = {0.123, -0.217, 0.331}, .radius = 2.0};
    double previous = 1.0;
    for (const double spacing : {0.4, 0.2, 0.1}) {
        const Mesh mesh = testing::extracted_sphere(sphere, spacing);
        testing::expect_closed_manifold(mesh);
        EXPECT_EQ(testing::euler_characteristic_of(mesh), 2);
        const double error = std::abs(testing::volume_of(mesh) / (4.0 / 3.0 * kPi * 8.0) - 1.0);
        EXPECT_LT(error, 0.5 * spacing * spacing);
        EXPECT_GT(previous / error, std::pow(2.0, 1.8));
        previous = error;
    }
}

TEST(Extract, SurfaceThroughNodesHasNoDegenerateTriangles) {
    // A radius that is a multiple of the spacing, and Pythagorean triples: many nodes have the value 0 exactly.
    for (const double radius : {1.0, 1.25, 2.5, 3.25}) {
        const Mesh mesh = testing::extracted_sphere({.centre = {}, .radius = radius}, 0.25);
        testing::expect_closed_manifold(mesh);
        EXPECT_EQ(testing::euler_characteristic_of(mesh), 2);
        EXPECT_GT(testing::smallest_area_of(mesh), 1e-4 * 0.25 * 0.25);
    }
}

TEST(Extract, ProjectionKeepsVerticesApart) {
    for (const double radius : {1.0, 1.25, 2.5, 3.25}) {
        const Mesh mesh = testing::projected_sphere({.centre = {}, .radius = radius}, 0.25);
        EXPECT_GT(testing::smallest_area_of(mesh), 1e-5 * 0.25 * 0.25);
    }
}

TEST(Extract, VerticesKeepAsFarFromNodesAsAskedFor) {
    const Sphere sphere{.centre = {0.01, 0.02, 0.03}, .radius = 1.9};
    const SampledField field = testing::sample_box(0.25, {-2, -2, -2}, {2, 2, 2}, sphere);
    const auto least_fraction = [&](double nearest) {
        double least = 1.0;
        for (const Vec3& v : extract_zero_set(field.grid, field.values, nearest).vertices) {
            const Vec3 at = 4.0 * (v - field.grid.corner(BlockId{0}));
            double off = 0.0;  // of the one coordinate that is not a node's
            for (const double x : {at.x, at.y, at.z}) off = std::max(off, std::abs(x - std::round(x)));
            least = std::min(least, off);
        }
        return least;
    };
    EXPECT_NEAR(least_fraction(kMinEdgeFraction), kMinEdgeFraction, 0.01);
    EXPECT_NEAR(least_fraction(kSpreadFraction), kSpreadFraction, 1e-9);
}

std::vector<InsideBits> inside_bits(const SampledField& field) {
    std::vector<InsideBits> inside(field.grid.block_count());
    for (std::size_t i = 0; i < field.values.size(); ++i) {
        if (field.values[i] >= 0.0F) continue;
        const auto node = static_cast<int>(i % kBlockNodes);
        testing::set_inside(inside[i / kBlockNodes], node % kBlockEdge, node / kBlockEdge % kBlockEdge,
                            node / (kBlockEdge * kBlockEdge));
    }
    return inside;
}

// Which nodes are inside tells the triangles; vertices lie in the middle of the edges.
TEST(Extract, BetweenNodesOfTwoSidesAreTheTrianglesOfTheZeroSet) {
    const Sphere sphere{.centre = {0.01, 0.02, 0.03}, .radius = 1.9};
    const SampledField field = testing::sample_box(0.25, {-2, -2, -2}, {2, 2, 2}, sphere);
    const Mesh mesh = extract_between(field.grid, inside_bits(field));
    const Mesh zero_set = extract_zero_set(field.grid, field.values, 0.5);
    EXPECT_EQ(mesh.triangles, zero_set.triangles);
    EXPECT_EQ(mesh.vertices, zero_set.vertices);
    EXPECT_GT(mesh.vertices.size(), 1000U);
}

TEST(Extract, SpreadVerticesLeaveHardlyASliverOnTheSurface) {
    for (const double radius : {1.0, 1.25, 1.9, 2.5, 3.25}) {
        const Sphere sphere{.centre = {0.01, 0.02, 0.03}, .radius = radius};
        const Vec3 r{radius, radius, radius};
        const SampledField field = testing::sample_box(0.25, -1.2 * r, 1.2 * r, sphere);
        Mesh mesh = extract_zero_set(field.grid, field.values, kSpreadFraction);
        testing::expect_closed_manifold(mesh);
        double smallest_sine = 1.0;
        for (Vec3& v : mesh.vertices) v = sphere.centre + radius * normalised(v - sphere.centre);
        for (const Triangle& t : mesh.triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3 a = mesh.vertices[t[(k + 1) % 3]] - mesh.vertices[t[k]];
                const Vec3 b = mesh.vertices[t[(k + 2) % 3]] - mesh.vertices[t[k]];
                smallest_sine = std::min(smallest_sine, norm(cross(a, b)) / (norm(a) * norm(b)));
            }
        EXPECT_GT(smallest_sine, std::sin(10.0 * kPi / 180.0)) << radius;
    }
}

TEST(Extract, PlanesThroughNodesCutBySphereAreClosed) {
    for (const Vec3& normal : {Vec3{0, 0, 1}, Vec3{0, 1, -1}, Vec3{1, 1, 1}}) {
        const SampledField field = testing::sample_box(
            0.25, {-2, -2, -2}, {2, 2, 2}, [&](const Vec3& p) { return std::max(dot(p, normal), norm(p) - 1.75); });
        const Mesh mesh = extract(field);
        testing::expect_closed_manifold(mesh);
        EXPECT_GT(testing::smallest_area_of(mesh), 1e-4 * 0.25 * 0.25);
    }
}

TEST(Extract, TouchingSpheresStayAManifold) {
    // They touch in a node, in the middle of an edge and in the middle of a cell.
    for (const Vec3& shift : {Vec3{}, Vec3{0.125, 0, 0}, Vec3{0.125, 0.125, 0.125}}) {
        const Sphere left{.centre = shift - Vec3{1, 0, 0}, .radius = 1.0};
        const Sphere right{.centre = shift + Vec3{1, 0, 0}, .radius = 1.0};
        const SampledField field = testing::sample_box(0.25, {-2.5, -1.5, -1.5}, {2.5, 1.5, 1.5},
                                                       [&](const Vec3& p) { return std::min(left(p), right(p)); });
        testing::expect_closed_manifold(extract(field));
    }
}

TEST(Extract, TorusHasOneHandle) {
    const SampledField field = testing::sample_box(0.2, {-3, -3, -1}, {3, 3, 1}, Torus{.major = 2.0, .minor = 0.8});
    const Mesh mesh = extract(field);
    testing::expect_closed_manifold(mesh);
    EXPECT_EQ(testing::euler_characteristic_of(mesh), 0);
    EXPECT_NEAR(testing::volume_of(mesh) / (2.0 * kPi * kPi * 2.0 * 0.64), 1.0, 0.02);
}

TEST(Extract, CavityWallFacesInwards) {
    const SampledField field = testing::sample_box(
        0.25, {-2, -2, -2}, {2, 2, 2}, [](const Vec3& p) { return std::max(norm(p) - 2.0, 1.0 - norm(p)); });
    const Mesh mesh = extract(field);
    testing::expect_closed_manifold(mesh);
    EXPECT_EQ(testing::euler_characteristic_of(mesh), 4);
    EXPECT_NEAR(testing::volume_of(mesh) / (4.0 / 3.0 * kPi * 7.0), 1.0, 0.05);
}

TEST(Extract, NarrowBandGivesTheSameMeshAsTheFullBox) {
    const SampledField box =
        testing::sample_box(0.1, {-3, -3, -3}, {3, 3, 3}, Sphere{.centre = {0.01, 0.02, 0.03}, .radius = 2.7});
    const SampledField band = testing::narrow_band(box, 0.15);
    ASSERT_LT(band.grid.block_count(), box.grid.block_count());
    const Mesh a = extract(box);
    const Mesh b = extract(band);
    testing::expect_closed_manifold(b);
    EXPECT_EQ(a.vertices, b.vertices);
    EXPECT_EQ(a.triangles, b.triangles);
}

TEST(Extract, SameBitsForAnyNumberOfThreads) {
    const SampledField field =
        testing::sample_box(0.1, {-2, -2, -2}, {2, 2, 2}, Sphere{.centre = {0.01, 0.02, 0.03}, .radius = 1.9});
    const auto with_threads = [&](int threads) {
        const ThreadLimit limit(threads);
        return extract(field);
    };
    const Mesh one = with_threads(1);
    const Mesh four = with_threads(4);
    EXPECT_EQ(one.vertices, four.vertices);
    EXPECT_EQ(one.triangles, four.triangles);
}

TEST(Extract, FarFromTheOriginAndInAnyOctant) {
    for (const Vec3& centre : {Vec3{9000.3, -9000.1, 5.0}, Vec3{-50.1, -60.2, -70.3}}) {
        const Mesh mesh = testing::extracted_sphere({.centre = centre, .radius = 1.6}, 0.3);
        testing::expect_closed_manifold(mesh);
        for (const Vec3& v : mesh.vertices) EXPECT_NEAR(norm(v - centre), 1.6, 0.03);
    }
}

}  // namespace
}  // namespace meniscus
