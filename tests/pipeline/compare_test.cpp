// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/compare.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

#include "meniscus/errors.h"
#include "support/shapes.h"

namespace meniscus::testing {
namespace {

ComparedSurface sphere(double radius) { return mesh_to_compare(projected_sphere({{}, radius}, 0.2)); }

// A cube whose faces are so far from the origin, as twelve triangles.
Mesh cube(double half) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back(
            {(i & 1) != 0 ? half : -half, (i & 2) != 0 ? half : -half, (i & 4) != 0 ? half : -half});
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

Mesh square(double z) {
    Mesh mesh;
    mesh.vertices = {{0, 0, z}, {9, 0, z}, {9, 9, z}, {0, 9, z}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    return mesh;
}

TEST(Compare, ConcentricSpheresAreTheDifferenceOfTheirRadii) {
    const Comparison found = compare_surfaces(sphere(3.0), sphere(3.5));
    for (const OneWayDistance& way : {found.a_to_b, found.b_to_a})
        for (const double distance : {way.mean, way.p99, way.max}) EXPECT_NEAR(distance, 0.5, 0.01);
    EXPECT_NEAR(found.a_to_b.signed_mean, -0.5, 0.01);  // A lies inside B
    EXPECT_NEAR(found.b_to_a.signed_mean, 0.5, 0.01);
    for (const float d : found.distances) EXPECT_NEAR(d, -0.5F, 0.01F);
}

TEST(Compare, ExchangingTheSurfacesExchangesTheWays) {
    const Comparison there = compare_surfaces(sphere(3.0), sphere(3.5));
    const Comparison back = compare_surfaces(sphere(3.5), sphere(3.0));
    EXPECT_EQ(there.a_to_b.mean, back.b_to_a.mean);
    EXPECT_EQ(there.b_to_a.p99, back.a_to_b.p99);
    EXPECT_EQ(there.hausdorff(), back.hausdorff());
}

TEST(Compare, AMeshIsNowhereFromItself) {
    const Comparison found = compare_surfaces(sphere(3.0), sphere(3.0));
    EXPECT_LT(found.hausdorff(), 1e-12);
    EXPECT_LT(std::abs(found.a_to_b.signed_mean), 1e-12);
}

TEST(Compare, AShiftedPlaneIsTheShift) {
    const Comparison found = compare_surfaces(mesh_to_compare(square(1.25)), mesh_to_compare(square(0.5)));
    EXPECT_NEAR(found.a_to_b.mean, 0.75, 1e-12);
    EXPECT_NEAR(found.a_to_b.max, 0.75, 1e-12);
    EXPECT_NEAR(found.a_to_b.signed_mean, 0.75, 1e-12);
    EXPECT_NEAR(found.b_to_a.signed_mean, -0.75, 1e-12);
    EXPECT_GE(found.a_to_b.points, 810U);  // 81 Å²
}

TEST(Compare, ALargerCubeIsFarthestOffAtItsCorners) {
    constexpr double kGap = 0.3;
    const Comparison found = compare_surfaces(mesh_to_compare(cube(1.0 + kGap)), mesh_to_compare(cube(1.0)));
    EXPECT_NEAR(found.a_to_b.max, kGap * std::numbers::sqrt3, 1e-12);
    EXPECT_NEAR(found.b_to_a.max, kGap, 1e-12);
    EXPECT_NEAR(found.b_to_a.signed_mean, -kGap, 1e-12);
    EXPECT_NEAR(found.a_to_b.signed_mean, found.a_to_b.mean, 1e-12);
    for (const float d : found.distances) EXPECT_NEAR(d, kGap * std::numbers::sqrt3, 1e-6);
}

TEST(Compare, WhatOneSurfaceLacksIsFoundTheOtherWay) {
    Mesh hollow = projected_sphere({{}, 4.0}, 0.2);
    append(hollow, turned_inside_out(projected_sphere({{}, 1.0}, 0.2)));
    hollow.normals.clear();
    const ComparedSurface with_cavity = mesh_to_compare(hollow);
    EXPECT_EQ(with_cavity.outer_pieces, 1U);
    EXPECT_EQ(with_cavity.cavities, 1U);
    const Comparison found = compare_surfaces(sphere(4.0), with_cavity);
    EXPECT_LT(found.a_to_b.max, 1e-9);
    EXPECT_NEAR(found.b_to_a.max, 3.0, 0.02);
}

TEST(Compare, AnExactSurfaceIsTheReferenceBothWays) {
    const Atoms atom{{{}}, {3.0}};
    const ComparedSurface exact = structure_to_compare(atom);
    EXPECT_NEAR(exact.area, 36.0 * std::numbers::pi, 1e-4);
    EXPECT_EQ(exact.outer_pieces, 1U);
    const Comparison found = compare_surfaces(sphere(3.2), exact);
    EXPECT_NEAR(found.a_to_b.mean, 0.2, 0.004);
    EXPECT_NEAR(found.a_to_b.max, 0.2, 1e-9);  // vertices are on the sphere
    EXPECT_NEAR(found.b_to_a.mean, 0.2, 0.004);
    EXPECT_NEAR(found.b_to_a.signed_mean, -0.2, 0.004);
    const Comparison two = compare_surfaces(structure_to_compare({{{}}, {3.1}}), exact);
    EXPECT_NEAR(two.a_to_b.mean, 0.1, 1e-9);
    EXPECT_NEAR(two.b_to_a.max, 0.1, 1e-6);
}

TEST(Compare, AnExactSurfaceOfAnyKindIsTaken) {
    const Atoms atom{{{}}, {3.0}};
    const ComparedSurface traced = exact_to_compare(ExactSurface(atom, {SurfaceKind::Sas, 1.5}), {.probe = 9.0});
    EXPECT_NEAR(traced.area, 4.0 * std::numbers::pi * 4.5 * 4.5, 1e-4);
    const Comparison found = compare_surfaces(traced, structure_to_compare(atom));
    EXPECT_NEAR(found.a_to_b.mean, 1.5, 1e-9);
    EXPECT_NEAR(found.b_to_a.signed_mean, -1.5, 1e-9);
}

TEST(Compare, TrianglesWithCornersOfTheirOwnAreJoined) {
    const Mesh whole = projected_sphere({{}, 3.0}, 0.4);
    Mesh soup;
    for (const Triangle& t : whole.triangles) {
        const auto first = static_cast<VertexId>(soup.vertices.size());
        for (const VertexId v : t) soup.vertices.push_back(whole.vertices[v]);
        soup.triangles.push_back({first, first + 1, first + 2});
    }
    const ComparedSurface joined = mesh_to_compare(soup);
    EXPECT_TRUE(joined.closed);
    EXPECT_EQ(joined.outer_pieces, 1U);
    EXPECT_EQ(joined.merged_vertices, soup.vertices.size() - whole.vertices.size());
    EXPECT_EQ(mesh_to_compare(whole).merged_vertices, 0U);
    EXPECT_EQ(mesh_to_compare(whole).mesh.normals.size(), whole.normals.size());
}

TEST(Compare, ThreadsChangeNothing) {
    const ComparedSurface exact = structure_to_compare({{{}, {3, 0, 0}}, {2.0, 1.5}});
    const Comparison one = compare_surfaces(sphere(2.0), exact, {.threads = 1});
    const Comparison all = compare_surfaces(sphere(2.0), exact);
    EXPECT_EQ(one.a_to_b.mean, all.a_to_b.mean);
    EXPECT_EQ(one.b_to_a.signed_mean, all.b_to_a.signed_mean);
    EXPECT_EQ(one.distances, all.distances);
}

TEST(Compare, RefusesWhatCannotBeCompared) {
    EXPECT_THROW(compare_surfaces(sphere(1.0), mesh_to_compare({})), UsageError);
    EXPECT_THROW(compare_surfaces(sphere(1.0), sphere(1.0), {.density = 0.0}), UsageError);
    EXPECT_THROW(compare_surfaces(sphere(1.0), sphere(1.0), {.threads = -1}), UsageError);
    EXPECT_THROW(mesh_to_compare(square(1e300)), UsageError);
    EXPECT_THROW(mesh_to_compare(square(std::numeric_limits<double>::quiet_NaN())), UsageError);
    ComparedSurface moved = sphere(1.0);
    moved.mesh.vertices.front().x = 1e300;
    EXPECT_THROW(compare_surfaces(sphere(1.0), moved), UsageError);
    EXPECT_THROW(structure_to_compare({}), std::invalid_argument);
}

}  // namespace
}  // namespace meniscus::testing
