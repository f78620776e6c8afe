// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/mend_slivers.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "meniscus/threads.h"
#include "remesh/patch.h"
#include "remesh/self_intersections.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace meniscus::testing {
namespace {

// Onto the nearest of some concentric spheres; every second one is the wall of a cavity.
SurfaceProjector onto_spheres(const Vec3& centre, const std::vector<double>& radii) {
    return [centre, radii](std::span<SurfacePoint> points) {
        for (SurfacePoint& point : points) {
            const double distance = norm(point.position - centre);
            const auto off = [&](double radius) { return std::abs(distance - radius); };
            const auto nearest =
                std::min_element(radii.begin(), radii.end(), [&](double a, double b) { return off(a) < off(b); });
            const Vec3 out = normalised(point.position - centre);
            point.position = centre + *nearest * out;
            point.normal = (nearest - radii.begin()) % 2 == 0 ? out : -1.0 * out;
        }
    };
}

SurfaceProjector onto_sphere(const Sphere& sphere) { return onto_spheres(sphere.centre, {sphere.radius}); }

double shortest_edge_of(const Mesh& mesh) {
    double shortest = 1e9;
    for (const auto& [a, b, c] : mesh.triangles)
        shortest = std::min({shortest, norm(mesh.vertices[a] - mesh.vertices[b]),
                             norm(mesh.vertices[b] - mesh.vertices[c]), norm(mesh.vertices[c] - mesh.vertices[a])});
    return shortest;
}

double smallest_angle_of(const Mesh& mesh) {
    double tangent = 2.0;
    for (const auto& [a, b, c] : mesh.triangles)
        tangent = std::min(tangent, tangent_of_smallest_angle(mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]));
    return std::atan(tangent) * 180.0 / std::acos(-1.0);
}

void expect_mended(const Mesh& mesh) {
    expect_closed_manifold(mesh);
    EXPECT_GE(smallest_angle_of(mesh), 5.0);
    EXPECT_GE(shortest_edge_of(mesh), kShortestEdge);
    EXPECT_TRUE(places_of_self_intersections(mesh).empty());
    for (const Triangle& t : mesh.triangles) {
        const Vec3 area = cross(mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]]);
        EXPECT_TRUE(dot(area, mesh.normals[t[0]]) > 0.0 || dot(area, mesh.normals[t[1]]) > 0.0 ||
                    dot(area, mesh.normals[t[2]]) > 0.0);
    }
}

// An octahedron with corners at distance 1.
Patch octahedron() {
    Patch patch;
    for (const Vec3& v : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{-1, 0, 0}, Vec3{0, -1, 0}, Vec3{0, 0, 1}, Vec3{0, 0, -1}})
        patch.points.push_back({v, v, 1.0});
    for (VertexId v = 0; v < 4; ++v) {
        patch.triangles.push_back({v, (v + 1) % 4, 4});
        patch.triangles.push_back({(v + 1) % 4, v, 5});
    }
    return patch;
}

constexpr double kSpacing = 0.4;
const Sphere kSphere{{0.1, -0.2, 0.05}, 3.0};

TEST(MendSlivers, LeaveNoneOnASphereThatIsFullOfThem) {
    // Vertices next to nodes: some hundred angles below five degrees.
    Mesh mesh = projected_sphere(kSphere, kSpacing);
    const double area = area_of(mesh);
    ASSERT_LT(smallest_angle_of(mesh), 2.0);
    ASSERT_LT(shortest_edge_of(mesh), kShortestEdge);
    const MeshChanges changes = mend_slivers(mesh, {.edge = kSpacing}, onto_sphere(kSphere));
    EXPECT_TRUE(changes.any());
    expect_mended(mesh);
    EXPECT_EQ(euler_characteristic_of(mesh), 2);
    EXPECT_NEAR(area_of(mesh) / area, 1.0, 2e-3);
    for (const Vec3& v : mesh.vertices) EXPECT_NEAR(kSphere(v), 0.0, 1e-9);
}

TEST(MendSlivers, WhatNeedsMoreRoomGetsIt) {
    // Edges are five times as long as it is told: at first there is no triangle that may change.
    Mesh mesh = projected_sphere(kSphere, kSpacing);
    mend_slivers(mesh, {.edge = kSpacing / 5.0, .longest_edge = 2.0 * kSpacing}, onto_sphere(kSphere));
    expect_mended(mesh);
}

TEST(MendSlivers, TellWhichTrianglesHaveChanged) {
    Mesh mesh = projected_sphere(kSphere, kSpacing);
    mend_slivers(mesh, {.edge = kSpacing}, onto_sphere(kSphere));
    const Triangle& one = mesh.triangles[mesh.triangles.size() / 2];  // becomes a sliver
    mesh.vertices[one[0]] = kSphere.centre + kSphere.radius * normalised(0.03 * mesh.vertices[one[0]] +
                                                                         0.97 * mesh.vertices[one[1]] - kSphere.centre);
    const Mesh before = mesh;
    const MeshChanges changes = mend_slivers(mesh, {.edge = kSpacing}, onto_sphere(kSphere));
    EXPECT_TRUE(changes.any());
    EXPECT_FALSE(changes.dropped_components);
    EXPECT_TRUE(std::is_sorted(changes.triangles.begin(), changes.triangles.end()));
    std::size_t same = 0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        if (std::binary_search(changes.triangles.begin(), changes.triangles.end(), t)) continue;
        ++same;
        ASSERT_LT(t, before.triangles.size());
        for (std::size_t k = 0; k < 3; ++k)
            EXPECT_EQ(mesh.vertices[mesh.triangles[t][k]], before.vertices[before.triangles[t][k]]);
    }
    EXPECT_GT(same, 100U);
}

TEST(MendSlivers, LeaveACrumpledMeshAlone) {
    Mesh mesh = projected_sphere(kSphere, kSpacing);
    mend_slivers(mesh, {.edge = kSpacing}, onto_sphere(kSphere));
    // Vertices near the pole come close to it: needles all round.
    const Vec3 pole = kSphere.centre + Vec3{0.0, 0.0, kSphere.radius};
    std::size_t moved = 0;
    for (Vec3& v : mesh.vertices)
        if (norm(v - pole) < 1.0) {
            v = kSphere.centre + kSphere.radius * normalised(v + 0.9 * (pole - v) - kSphere.centre);
            ++moved;
        }
    ASSERT_GT(moved, 4U);
    const Mesh before = mesh;
    SliverOptions options{.edge = kSpacing, .longest_edge = 2.0};
    options.most_bad = 3;
    const MeshChanges left = mend_slivers(mesh, options, onto_sphere(kSphere));
    EXPECT_FALSE(left.any());
    EXPECT_GT(left.crumpled.size(), 3U);
    for (const Vec3& place : left.crumpled) EXPECT_LT(norm(place - pole), 2.0);
    EXPECT_EQ(mesh.vertices, before.vertices);
    EXPECT_EQ(mesh.triangles, before.triangles);
    options.most_bad = left.crumpled.size();
    EXPECT_TRUE(mend_slivers(mesh, options, onto_sphere(kSphere)).crumpled.empty());
    expect_mended(mesh);
}

TEST(MendSlivers, LeaveAGoodMeshAlone) {
    Mesh mesh = projected_sphere(kSphere, kSpacing);
    mend_slivers(mesh, {.edge = kSpacing}, onto_sphere(kSphere));
    const Mesh before = mesh;
    EXPECT_FALSE(mend_slivers(mesh, {.edge = kSpacing}, onto_sphere(kSphere)).any());
    EXPECT_EQ(mesh.vertices, before.vertices);
    EXPECT_EQ(mesh.triangles, before.triangles);
}

TEST(MendSlivers, TellWhatBecameOfEveryVertex) {
    Mesh mesh = projected_sphere(kSphere, kSpacing);
    std::vector<Vec3> places = mesh.vertices;
    const MeshChanges changes = mend_slivers(mesh, {.edge = kSpacing}, onto_sphere(kSphere));
    EXPECT_FALSE(changes.refilled.empty());
    EXPECT_LT(changes.left, places.size());
    renumber_entries(changes, places);
    ASSERT_EQ(places.size(), mesh.vertices.size());
    std::vector<VertexId> moved;
    for (VertexId v = 0; v < places.size(); ++v)
        if (!(places[v] == mesh.vertices[v])) moved.push_back(v);
    EXPECT_EQ(moved, changes.moved);
}

TEST(MendSlivers, KeepTheSmallestPieces) {
    // An octahedron on a small sphere, with corners on the equator so near to each other in pairs.
    for (const double degrees : {1.0, 4.0, 8.0}) {
        const Sphere sphere{{1.0, 2.0, 3.0}, 0.3};
        Mesh mesh;
        std::vector<Vec3> directions;
        for (const double azimuth : {0.0, degrees, 180.0, 180.0 + degrees})
            directions.push_back(
                {std::cos(azimuth * std::acos(-1.0) / 180.0), std::sin(azimuth * std::acos(-1.0) / 180.0), 0.0});
        directions.push_back({0.0, 0.0, 1.0});
        directions.push_back({0.0, 0.0, -1.0});
        for (const Vec3& n : directions) {
            mesh.normals.push_back(to_small(n));
            mesh.vertices.push_back(sphere.centre + sphere.radius * n);
        }
        mesh.triangles = octahedron().triangles;
        expect_closed_manifold(mesh);
        ASSERT_LT(smallest_angle_of(mesh), degrees);
        mend_slivers(mesh, {.edge = 0.5}, onto_sphere(sphere));
        expect_mended(mesh);
        EXPECT_EQ(euler_characteristic_of(mesh), 2);
        EXPECT_GT(volume_of(mesh), 0.0);
    }
}

// A needle of four triangles whose corners have nowhere else to go, among pieces that are whole.
Mesh spheres_and_a_needle() {
    Mesh mesh;
    for (const double x : {-6.0, 0.0, 6.0}) {
        const auto first = static_cast<VertexId>(mesh.vertices.size());
        const auto number = static_cast<std::uint32_t>(x / 6.0 + 1.0);
        const bool is_needle = number == 1;
        const std::vector<Vec3> needle{{0, 0, 0}, {0.3, 0.01, 0.01}, {0.3, -0.01, 0.01}, {0.3, 0.0, -0.01}};
        const Patch whole = octahedron();
        for (std::size_t v = 0; v < (is_needle ? 4U : 6U); ++v) {
            mesh.vertices.push_back(is_needle ? needle[v] : whole.at(static_cast<VertexId>(v)) + Vec3{x, 0, 0});
            mesh.normals.push_back(to_small(is_needle ? Vec3{1, 0, 0} : whole.at(static_cast<VertexId>(v))));
            mesh.components.push_back(number);
        }
        const std::vector<Triangle> of_needle{{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}};
        for (const auto& [a, b, c] : is_needle ? of_needle : whole.triangles)
            mesh.triangles.push_back({first + a, first + b, first + c});
    }
    return mesh;
}

const SurfaceProjector kNowhereElse = [](std::span<SurfacePoint>) {};

TEST(MendSlivers, DropTinyComponentsThatCannotBeMended) {
    Mesh mesh = spheres_and_a_needle();
    expect_closed_manifold(mesh);
    ASSERT_LT(smallest_angle_of(mesh), 5.0);
    const MeshChanges changes = mend_slivers(mesh, {.edge = 0.5, .tiny_component = 8}, kNowhereElse);
    EXPECT_EQ(changes.left, 12U);
    expect_closed_manifold(mesh);
    EXPECT_GE(smallest_angle_of(mesh), 5.0);
    EXPECT_EQ(euler_characteristic_of(mesh), 4);
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v)
        EXPECT_EQ(mesh.components[v], mesh.vertices[v].x < 0 ? 0U : 1U);
}

TEST(MendSlivers, TellOfATinyComponentAtTheEnd) {
    Mesh mesh = spheres_and_a_needle();
    mesh.vertices.resize(10);
    mesh.normals.resize(10);
    mesh.components.resize(10);
    mesh.triangles.resize(12);
    const MeshChanges changes = mend_slivers(mesh, {.edge = 0.5, .tiny_component = 8}, kNowhereElse);
    EXPECT_TRUE(changes.any());
    EXPECT_EQ(changes.left, 6U);
    EXPECT_TRUE(changes.refilled.empty());
    expect_closed_manifold(mesh);
}

TEST(MendSlivers, KeepTinyComponentsUnlessAsked) {
    Mesh mesh = spheres_and_a_needle();
    mend_slivers(mesh, {.edge = 0.5}, kNowhereElse);
    EXPECT_EQ(euler_characteristic_of(mesh), 6);
    Mesh with_three = spheres_and_a_needle();
    mend_slivers(with_three, {.edge = 0.5, .tiny_component = 3}, kNowhereElse);
    EXPECT_EQ(euler_characteristic_of(with_three), 6);
}

// A mesh that is nothing but a tiny component is what there is of the molecule.
TEST(MendSlivers, KeepTheLastComponent) {
    Mesh mesh;
    const Mesh three = spheres_and_a_needle();
    mesh.vertices.assign(three.vertices.begin() + 6, three.vertices.begin() + 10);
    mesh.normals.assign(three.normals.begin() + 6, three.normals.begin() + 10);
    for (std::size_t t = 8; t < 12; ++t) {
        const auto& [a, b, c] = three.triangles[t];
        mesh.triangles.push_back({a - 6, b - 6, c - 6});
    }
    expect_closed_manifold(mesh);
    mend_slivers(mesh, {.edge = 0.5, .tiny_component = 8}, kNowhereElse);
    EXPECT_EQ(mesh.triangles.size(), 4U);
}

TEST(MendSlivers, UnfoldWhatFacesTheWrongWay) {
    Mesh mesh = projected_sphere(kSphere, kSpacing);
    mend_slivers(mesh, {.edge = kSpacing}, onto_sphere(kSphere));
    // A corner goes beyond the side opposite to it.
    const Triangle t = mesh.triangles[mesh.triangles.size() / 2];
    const Vec3 middle = 0.5 * (mesh.vertices[t[1]] + mesh.vertices[t[2]]);
    const Vec3 beyond = mesh.vertices[t[0]] + 1.6 * (middle - mesh.vertices[t[0]]);
    const Vec3 normal = normalised(beyond - kSphere.centre);
    mesh.normals[t[0]] = to_small(normal);
    mesh.vertices[t[0]] = kSphere.centre + kSphere.radius * normal;
    mend_slivers(mesh, {.edge = kSpacing}, onto_sphere(kSphere));
    expect_mended(mesh);
}

TEST(MendSlivers, DoNotPassThinWallsThroughThemselves) {
    // Triangles with longer sides would reach through the wall.
    const Vec3 centre{0.07, 0.11, -0.05};
    for (const double thickness : {0.009, 0.012, 0.015}) {
        const std::vector<double> radii{2.0, 2.0 - thickness};
        Mesh mesh = projected_sphere({centre, radii[0]}, 0.2);
        const Mesh inner = turned_inside_out(projected_sphere({centre, radii[1]}, 0.2));
        append(mesh, inner);
        for (const SmallVec3& normal : inner.normals) mesh.normals.push_back(-normal);
        ASSERT_TRUE(places_of_self_intersections(mesh).empty()) << thickness;
        mend_slivers(mesh, {.edge = 0.2}, onto_spheres(centre, radii));
        expect_mended(mesh);
        EXPECT_EQ(euler_characteristic_of(mesh), 4);
    }
}

TEST(MendSlivers, PartWallsThatPassThroughEachOtherIfEverywhereIsSearched) {
    // A wall thinner than the triangles are far from their sphere.
    const Vec3 centre{0.07, 0.11, -0.05};
    const std::vector<double> radii{2.0, 1.975};
    Mesh tangled = projected_sphere({centre, radii[0]}, 0.4);
    const Mesh inner = turned_inside_out(projected_sphere({centre, radii[1]}, 0.3));
    append(tangled, inner);
    for (const SmallVec3& normal : inner.normals) tangled.normals.push_back(-normal);
    EXPECT_GT(self_intersecting_triangles(tangled).size(), 20U);
    Mesh mesh = tangled;
    EXPECT_FALSE(mend_slivers(mesh, {.edge = 0.4}, onto_spheres(centre, radii)).was_tangled);
    mesh = tangled;
    EXPECT_TRUE(mend_slivers(mesh, {.edge = 0.4, .search_everywhere = true}, onto_spheres(centre, radii)).was_tangled);
    expect_mended(mesh);
    EXPECT_EQ(euler_characteristic_of(mesh), 4);
}

TEST(MendSlivers, NewVerticesBelongToThePieceTheyLieOn) {
    Mesh mesh = projected_sphere(kSphere, kSpacing);
    Mesh other = projected_sphere({{20.0, 0.0, 0.0}, 3.0}, kSpacing);
    mesh.components.assign(mesh.vertices.size(), 0);
    mesh.components.resize(mesh.vertices.size() + other.vertices.size(), 1);
    append(mesh, other);
    mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
    mend_slivers(mesh,
                 {.needed_angle_deg = 30.0, .smallest_angle_deg = 30.0, .mended_angle_deg = 31.0, .edge = kSpacing},
                 [](std::span<SurfacePoint> points) {
                     for (SurfacePoint& point : points) {
                         const Vec3 to = point.position.x > 10.0 ? Vec3{20.0, 0.0, 0.0} : kSphere.centre;
                         point.normal = normalised(point.position - to);
                         point.position = to + 3.0 * point.normal;
                     }
                 });
    ASSERT_EQ(mesh.components.size(), mesh.vertices.size());
    for (VertexId v = 0; v < mesh.vertices.size(); ++v)
        EXPECT_EQ(mesh.components[v], mesh.vertices[v].x > 10.0 ? 1U : 0U);
}

TEST(MendSlivers, HeldVerticesStay) {
    Mesh mesh = projected_sphere(kSphere, kSpacing);
    const std::vector<Vec3> before = mesh.vertices;
    std::vector<bool> held(before.size());
    for (std::size_t v = 0; v < held.size(); ++v) held[v] = before[v].z > kSphere.centre.z;
    const MeshChanges changes = mend_slivers(mesh, {.edge = kSpacing, .held = held}, onto_sphere(kSphere));
    EXPECT_TRUE(changes.any());
    for (std::size_t v = 0; v < before.size(); ++v) {
        const bool stays = std::find(mesh.vertices.begin(), mesh.vertices.end(), before[v]) != mesh.vertices.end();
        EXPECT_TRUE(stays || !held[v]);
    }
}

TEST(MendSlivers, GiveTheSameForAnyNumberOfThreads) {
    const auto with = [](int threads) {
        const ThreadLimit limit(threads);
        Mesh mesh = projected_sphere(kSphere, kSpacing);
        mend_slivers(mesh, {.edge = kSpacing}, onto_sphere(kSphere));
        return mesh;
    };
    const Mesh one = with(1);
    const Mesh two = with(2);
    EXPECT_EQ(one.vertices, two.vertices);
    EXPECT_EQ(one.triangles, two.triangles);
}

Mesh mesh_of(const Patch& patch) {
    Mesh mesh;
    std::vector<VertexId> number(patch.points.size());
    for (VertexId v = 0; v < patch.points.size(); ++v) {
        if (patch.star(v).empty()) continue;
        number[v] = static_cast<VertexId>(mesh.vertices.size());
        mesh.vertices.push_back(patch.at(v));
    }
    for (std::size_t t = 0; t < patch.triangles.size(); ++t) {
        const auto& [a, b, c] = patch.triangles[t];
        if (patch.has(t)) mesh.triangles.push_back({number[a], number[b], number[c]});
    }
    return mesh;
}

TEST(Patch, FlipsAndCollapsesLeaveAManifold) {
    Patch patch = octahedron();
    EXPECT_TRUE(patch.flip(0, 4));
    expect_closed_manifold(mesh_of(patch));
    EXPECT_FALSE(patch.sides(0, 4));
    EXPECT_TRUE(patch.sides(1, 3));
    patch = octahedron();
    EXPECT_TRUE(patch.collapse(0, 1));
    expect_closed_manifold(mesh_of(patch));
    EXPECT_EQ(mesh_of(patch).triangles.size(), 6U);
}

TEST(Patch, SplitAddsAVertexAndTwoTriangles) {
    Patch patch = octahedron();
    const double volume = volume_of(mesh_of(patch));
    EXPECT_TRUE(patch.split(0, 4));
    EXPECT_FALSE(patch.sides(0, 4));
    EXPECT_TRUE(patch.sides(0, 6));
    EXPECT_EQ(patch.star(6).size(), 4U);
    const Mesh mesh = mesh_of(patch);
    expect_closed_manifold(mesh);
    EXPECT_EQ(mesh.vertices.size(), 7U);
    EXPECT_EQ(mesh.triangles.size(), 10U);
    EXPECT_NEAR(volume_of(mesh), volume, 1e-12);
    EXPECT_EQ(changed_triangles(octahedron(), patch).size(), 4U);
    EXPECT_FALSE(patch.split(0, 2));
}

TEST(Patch, RefusesWhatWouldBreakTheManifold) {
    Patch patch = octahedron();
    EXPECT_FALSE(patch.flip(0, 2));  // no edge
    ASSERT_TRUE(patch.collapse(0, 1));
    // A double tetrahedron is left: 2, 4, 5 are one triangle without a face, 1 and 3 its tips.
    for (const auto& [a, b] : {std::pair<VertexId, VertexId>{2, 4}, {4, 5}, {5, 2}}) {
        Patch copy = patch;
        if (copy.collapse(a, b)) expect_closed_manifold(mesh_of(copy));
    }
    Patch tetrahedron;
    for (const Vec3& v : meniscus::testing::tetrahedron().vertices)
        tetrahedron.points.push_back({v, normalised(v), 0.0});
    tetrahedron.triangles = meniscus::testing::tetrahedron().triangles;
    EXPECT_FALSE(tetrahedron.flip(0, 1));
    EXPECT_FALSE(tetrahedron.collapse(0, 1));
}

TEST(Patch, AnglesAreThoseOfClosedForms) {
    const Vec3 a{0, 0, 0};
    EXPECT_NEAR(tangent_of_smallest_angle(a, {1, 0, 0}, {0.5, std::sqrt(0.75), 0}), std::sqrt(3.0), 1e-12);
    EXPECT_NEAR(tangent_of_smallest_angle(a, {10, 0, 0}, {10, 1, 0}), 0.1, 1e-12);
    EXPECT_NEAR(tangent_of_smallest_angle(a, {10, 0, 0}, {5, 1, 0}), 0.2, 1e-12);
    EXPECT_EQ(tangent_of_smallest_angle(a, {1, 0, 0}, {2, 0, 0}), 0.0);
    EXPECT_EQ(tangent_of_smallest_angle(a, a, a), 0.0);
}

TEST(Patch, CrossingsAreCountedOnce) {
    Patch patch;
    for (const Vec3& v :
         {Vec3{0, 0, 0}, Vec3{2, 0, 0}, Vec3{0, 2, 0}, Vec3{0.4, 0.4, -1}, Vec3{0.6, 0.5, 1}, Vec3{0.5, 0.7, 1}})
        patch.points.push_back({v, {0, 0, 1}, 0.0});
    patch.triangles = {{0, 1, 2}, {3, 4, 5}};
    const std::array<std::size_t, 2> both{0, 1};
    EXPECT_EQ(count_crossings(patch, both), 1U);
    EXPECT_EQ(count_crossings(patch, std::span(both).first(1)), 1U);
    patch.points[3].position.z = 0.5;
    EXPECT_EQ(count_crossings(patch, both), 0U);
}

}  // namespace
}  // namespace meniscus::testing
