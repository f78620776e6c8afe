// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/sky_light.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/shapes.h"

namespace meniscus {
namespace {

TEST(SkyLight, NothingHidesTheSkyFromASphere) {
    const Mesh mesh = testing::projected_sphere({.centre = {}, .radius = 3.0}, 0.4);
    const RayScene scene(mesh);
    const SkyLight sky({scene, mesh, 10.0});
    for (VertexId v = 0; v < mesh.vertices.size(); ++v) EXPECT_GT(sky.at(v), 0.99F) << v;
}

TEST(SkyLight, InsideASphereItIsDark) {
    Mesh mesh = testing::turned_inside_out(testing::projected_sphere({.centre = {}, .radius = 1.0}, 0.2));
    for (SmallVec3& normal : mesh.normals) normal = -normal;
    const RayScene scene(mesh);
    const SkyLight sky({scene, mesh, 1e3});
    for (VertexId v = 0; v < mesh.vertices.size(); ++v) EXPECT_LT(sky.at(v), 0.01F) << v;
}

TEST(SkyLight, WhatIsCutOffDarkensNothing) {
    Mesh mesh = testing::turned_inside_out(testing::projected_sphere({.centre = {}, .radius = 1.0}, 0.2));
    for (SmallVec3& normal : mesh.normals) normal = -normal;
    const RayScene scene = RayScene(mesh).cut({.point = {}, .normal = {0, 0, 1}});
    const SkyLight sky({scene, mesh, 1e3});
    for (VertexId v = 0; v < mesh.vertices.size(); ++v) {
        if (mesh.vertices[v].z > -0.99) continue;
        EXPECT_NEAR(sky.at(v), 0.5, 0.05) << "the opening is 45 degrees around the zenith";
    }
}

TEST(SkyRays, WhatFacesNowhereSeesAllOfIt) {
    Mesh mesh = testing::projected_sphere({.centre = {}, .radius = 1.0}, 0.3);
    mesh.normals[0] = {};
    const RayScene scene(mesh);
    EXPECT_EQ(SkyRays(scene, mesh, 10.0).open_share(0, 8), 1.0F);
}

TEST(SkyLight, IsThatOfManyRaysFromEachVertex) {
    // Two balls, of which each hides much of the other's sky where they are near.
    Mesh mesh = testing::projected_sphere({.centre = {}, .radius = 3.0}, 0.4);
    const Mesh other = testing::projected_sphere({.centre = {6.5, 0, 0}, .radius = 3.0}, 0.4);
    testing::append(mesh, other);
    mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
    const RayScene scene(mesh);
    const SkyRays rays(scene, mesh, 10.0);
    const SkyLight sky(rays);
    double squared = 0.0;
    for (VertexId v = 0; v < mesh.vertices.size(); ++v) {
        const double error = double{sky.at(v)} - double{rays.open_share(v, 1000)};
        EXPECT_LT(std::abs(error), 0.12) << v;
        squared += error * error;
    }
    EXPECT_LT(std::sqrt(squared / static_cast<double>(mesh.vertices.size())), 0.02);
}

TEST(SkyLight, EachSideHasItsOwnSky) {
    const Mesh mesh = testing::turned_inside_out(testing::projected_sphere({.centre = {}, .radius = 1.0}, 0.2));
    const RayScene scene(mesh);
    const SkyLight inner({scene, mesh, 1e3, SkyRays::Side::Molecule});
    for (VertexId v = 0; v < mesh.vertices.size(); ++v) EXPECT_LT(inner.at(v), 0.01F) << v;
}

TEST(SkyLight, WhatIsOutOfReachHidesNothing) {
    Mesh mesh = testing::projected_sphere({.centre = {}, .radius = 1.0}, 0.3);
    const std::size_t of_one = mesh.vertices.size();
    Mesh lid = testing::projected_sphere({.centre = {0, 0, 9}, .radius = 3.0}, 0.5);
    testing::append(mesh, lid);
    mesh.normals.insert(mesh.normals.end(), lid.normals.begin(), lid.normals.end());
    const auto top =
        std::max_element(mesh.vertices.begin(), mesh.vertices.begin() + static_cast<std::ptrdiff_t>(of_one),
                         [](const Vec3& a, const Vec3& b) { return a.z < b.z; });
    const auto vertex = static_cast<VertexId>(top - mesh.vertices.begin());
    const RayScene scene(mesh);
    EXPECT_GT(SkyLight({scene, mesh, 4.0}).at(vertex), 0.99F);
    // A ball seen under the angle a above hides sin²(a) of a sky that is weighted by the cosine.
    const double hidden = 9.0 / 64.0;
    EXPECT_NEAR(SkyLight({scene, mesh, 1e6}).at(vertex), 1.0 - hidden, 0.03);
}

}  // namespace
}  // namespace meniscus
