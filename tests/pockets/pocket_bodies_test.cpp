// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "../support/mesh_checks.h"
#include "meniscus/mesh_part.h"
#include "meniscus/pockets.h"

namespace meniscus::testing {
namespace {

// Voxels at whole numbers as a pocket's, where share(position) is above zero.
template <class Share>
void add_pocket(Pockets& pockets, int reach, const Share& share) {
    Pocket pocket;
    pocket.rank = pockets.pockets.size() + 1;
    for (int z = -reach; z <= reach; ++z)
        for (int y = -reach; y <= reach; ++y)
            for (int x = -reach; x <= reach; ++x) {
                const Vec3 p{double(x), double(y), double(z)};
                const double part = std::clamp(share(p), 0.0, 1.0);
                if (part <= 0.0) continue;
                pocket.voxels.push_back(static_cast<std::uint32_t>(pockets.voxels.size()));
                pockets.voxels.push_back({.position = p,
                                          .share = static_cast<float>(part),
                                          .pocket = static_cast<std::uint32_t>(pockets.pockets.size())});
                pocket.volume += part;
            }
    pockets.pockets.push_back(pocket);
}

// By the divergence theorem.
double volume_of(const Mesh& mesh) {
    double volume = 0.0;
    for (const auto& [a, b, c] : mesh.triangles)
        volume += dot(mesh.vertices[a], cross(mesh.vertices[b], mesh.vertices[c])) / 6.0;
    return volume;
}

TEST(PocketBodies, ABallOfVoxelsIsABall) {
    constexpr double kRadius = 6.0;
    Pockets pockets;
    add_pocket(pockets, 8, [](const Vec3& p) { return kRadius + 0.5 - norm(p); });
    pockets.pockets[0].volume = 4.0 / 3.0 * std::numbers::pi * kRadius * kRadius * kRadius;
    const Mesh body = pocket_bodies(pockets);
    expect_closed_manifold(body);
    EXPECT_NEAR(volume_of(body), pockets.pockets[0].volume, 0.02 * pockets.pockets[0].volume);
    for (std::size_t v = 0; v < body.vertices.size(); ++v) {
        EXPECT_NEAR(norm(body.vertices[v]), kRadius, 0.15);
        EXPECT_GT(dot(body.normals[v], normalised(body.vertices[v])), 0.97);
    }
}

TEST(PocketBodies, ThoseOfNeighboursHaveTheirNumbersAndVolumesAndHardlyOverlap) {
    Pockets pockets;
    const auto ball = [](const Vec3& p) { return 6.5 - norm(p); };
    add_pocket(pockets, 8, [&](const Vec3& p) { return p.x < 0.0 ? ball(p) : 0.0; });
    add_pocket(pockets, 8, [&](const Vec3& p) { return p.x < 0.0 ? 0.0 : ball(p); });
    const Mesh bodies = pocket_bodies(pockets);
    expect_closed_manifold(bodies);
    ASSERT_EQ(bodies.values.size(), 1U);
    EXPECT_EQ(bodies.values[0].name, "pocket");
    for (std::uint32_t p = 0; p < 2; ++p) {
        const double volume = pockets.pockets[p].volume;
        EXPECT_NEAR(volume_of(part_of_component(bodies, p).mesh), volume, 0.05 * volume);
    }
    for (std::size_t v = 0; v < bodies.vertices.size(); ++v) {
        const bool is_first = bodies.components[v] == 0;
        EXPECT_EQ(bodies.values[0].values[v], is_first ? 1.0F : 2.0F);
        EXPECT_GT((is_first ? -1.0 : 1.0) * (bodies.vertices[v].x + 0.5), -0.25);
    }
}

TEST(PocketBodies, APocketOfOneHalfFullVoxelHasABodyAndOneOfNoneHasNot) {
    Pockets pockets;
    add_pocket(pockets, 0, [](const Vec3&) { return 0.4; });
    add_pocket(pockets, 0, [](const Vec3&) { return 0.0; });
    const Mesh bodies = pocket_bodies(pockets);
    expect_closed_manifold(bodies);
    EXPECT_GT(volume_of(bodies), 0.1);
    EXPECT_LT(volume_of(bodies), 1.0);
    EXPECT_EQ(std::count(bodies.components.begin(), bodies.components.end(), 1U), 0);
    EXPECT_TRUE(pocket_bodies({}).vertices.empty());
}

TEST(PocketValues, VerticesKnowThePocketBesideThem) {
    Pockets pockets;
    const auto ball = [](const Vec3& p) { return 6.5 - norm(p); };
    add_pocket(pockets, 8, [&](const Vec3& p) { return p.x < 0.0 ? ball(p) : 0.0; });
    add_pocket(pockets, 8, [&](const Vec3& p) { return p.x < 0.0 ? 0.0 : ball(p); });
    Mesh wall;  // of the molecule, whose outside is the ball
    for (const Vec3& place : {Vec3{-6, 0, 0}, Vec3{6, 0, 0}, Vec3{0, -6, 0}, Vec3{-12, 0, 0}}) {
        wall.vertices.push_back(place);
        wall.normals.push_back(to_small(-normalised(place)));
    }
    const VertexValues ranks = pocket_values(pockets, wall);
    EXPECT_EQ(ranks.values[0], 1.0F);
    EXPECT_EQ(ranks.values[1], 2.0F);
    EXPECT_EQ(ranks.values[2], 2.0F);
    EXPECT_TRUE(std::isnan(ranks.values[3]));
}

TEST(PocketBodies, ACavityOfAShellIsFilled) {
    Atoms atoms;
    constexpr int kBeads = 200;
    for (int i = 0; i < kBeads; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / kBeads;
        const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0)) * i;
        const double r = std::sqrt(1.0 - z * z);
        atoms.centres.push_back(7.0 * Vec3{r * std::cos(turn), r * std::sin(turn), z});
        atoms.radii.push_back(1.7);
    }
    const ExactSurface exact(atoms);
    const Pockets pockets = find_pockets(exact, {});
    const Mesh bodies = pocket_bodies(pockets);
    expect_closed_manifold(bodies);
    for (std::uint32_t p = 0; p < pockets.pockets.size(); ++p) {
        if (!pockets.pockets[p].cavity) continue;
        const Mesh body = part_of_component(bodies, p).mesh;
        EXPECT_NEAR(volume_of(body), pockets.pockets[p].volume, 0.02 * pockets.pockets[p].volume);
        for (const double distance : exact.signed_distance(body.vertices)) EXPECT_NEAR(distance, 0.0, 0.4);
    }
}

}  // namespace
}  // namespace meniscus::testing
