// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "meniscus/errors.h"
#include "meniscus/tunnels.h"
#include "support/test_data.h"
#include "tunnels/clearance.h"
#include "tunnels/drilled_block.h"

namespace meniscus {
namespace {

std::vector<Tunnel> tunnels_of(const Atoms& atoms, const Vec3& start, const TunnelOptions& options = {},
                               int threads = 0) {
    return find_tunnels(ExactSurface(atoms), std::span(&start, 1), options, {.threads = threads});
}

// A chamber of radius 5 round the origin in a block, with straight holes of radius 3.5 upwards that begin at given
// places in the plane z = 0.
Atoms chamber(const std::vector<Vec3>& holes) {
    return testing::block({12.0, 9.0, 9.0}, [&](const Vec3& p) {
        if (norm(p) < 6.0) return false;
        return std::none_of(holes.begin(), holes.end(), [&](const Vec3& hole) {
            return p.z > 0.0 && std::hypot(p.x - hole.x, p.y - hole.y) < 4.5;
        });
    });
}

TEST(Tunnels, PassARingByItsFreeRadius) {
    Atoms atoms = chamber({{0, 0, 0}});
    testing::add_ring(atoms, {0.2, -0.1, 7.0}, 2.2);
    const std::vector<Tunnel> found = tunnels_of(atoms, {0.5, 0.3, 0.0});
    ASSERT_FALSE(found.empty());
    const Bottleneck& bottleneck = found[0].path.bottleneck;
    EXPECT_NEAR(bottleneck.radius, 2.2, testing::kExact);
    EXPECT_NEAR(norm(bottleneck.position - Vec3{0.2, -0.1, 7.0}), 0.0, testing::kExact);
    EXPECT_NEAR(found[0].path.certified_radius, 2.2, testing::kExact);
    EXPECT_FALSE(bottleneck.at_end);
    EXPECT_EQ(found[0].path.points[bottleneck.point].position, bottleneck.position);
}

TEST(Tunnels, HaveTheNarrowestRingOfAFunnelAsBottleneck) {
    Atoms atoms = chamber({{0, 0, 0}});
    for (int i = 0; i < 4; ++i) testing::add_ring(atoms, {0.0, 0.0, 5.5 + i}, 1.3 + 0.4 * i);
    const std::vector<Tunnel> found = tunnels_of(atoms, {0.5, 0.3, 0.0});
    ASSERT_FALSE(found.empty());
    EXPECT_NEAR(found[0].path.bottleneck.radius, 1.3, testing::kExact);
    EXPECT_NEAR(found[0].path.bottleneck.position.z, 5.5, testing::kExact);
    EXPECT_NEAR(found[0].path.certified_radius, 1.3, testing::kExact);
}

TEST(Tunnels, ThroughACylinderOfRingsAreStraight) {
    Atoms atoms = chamber({{0, 0, 0}});
    for (int i = 0; i < 6; ++i) testing::add_ring(atoms, {0.0, 0.0, 5.0 + i}, 1.8);
    const std::vector<Tunnel> found = tunnels_of(atoms, {0.0, 0.0, 0.0});
    ASSERT_FALSE(found.empty());
    EXPECT_NEAR(found[0].path.bottleneck.radius, 1.8, testing::kExact);
    EXPECT_NEAR(found[0].path.certified_radius, 1.8, testing::kExact);
    EXPECT_LT(found[0].path.curvature, 1.05);
    for (const PathPoint& point : found[0].path.points) {
        if (point.position.z < 5.5 || point.position.z > 9.5) continue;
        EXPECT_NEAR(std::hypot(point.position.x, point.position.y), 0.0, 0.2);
    }
}

// From the plane of a ring, ways up lead to its middle, which is a saddle.
TEST(Tunnels, LeaveThePlaneOfARing) {
    Atoms atoms = chamber({{0, 0, 0}});
    testing::add_ring(atoms, {0.0, 0.0, 7.0}, 2.2);
    testing::add_ring(atoms, {0.0, 0.0, 4.0}, 2.6);
    const std::vector<Tunnel> found = tunnels_of(atoms, {0.4, 0.3, 4.0});
    ASSERT_FALSE(found.empty());
    EXPECT_NEAR(found[0].path.bottleneck.radius, 2.2, testing::kExact);
    EXPECT_NEAR(found[0].path.certified_radius, 2.2, testing::kExact);
}

TEST(Tunnels, OfTwoHolesComeWiderFirst) {
    Atoms atoms = chamber({{-6, 0, 0}, {6, 0, 0}});
    testing::add_ring(atoms, {-6.0, 0.0, 7.0}, 1.5);
    testing::add_ring(atoms, {6.0, 0.0, 7.0}, 1.9);
    const std::vector<Tunnel> found = tunnels_of(atoms, {0.0, 0.0, -1.0}, {.count = 5});
    ASSERT_EQ(found.size(), 2U);
    EXPECT_NEAR(found[0].path.bottleneck.radius, 1.9, testing::kExact);
    EXPECT_NEAR(found[1].path.bottleneck.radius, 1.5, testing::kExact);
    EXPECT_EQ(found[0].rank, 1U);
    EXPECT_EQ(found[1].rank, 2U);
    EXPECT_GT(found[0].path.points.back().position.x, 0.0);
    EXPECT_LT(found[1].path.points.back().position.x, 0.0);
}

TEST(Tunnels, PassBeadsOfDifferentRadiiByTheirTangentBall) {
    // Three large beads that leave a gap in the hole; the rest of the hole is filled by smaller ones, which the ball
    // between the three touches nowhere.
    const std::array<double, 3> radii{3.2, 2.7, 2.3};
    const Vec3 gap{0.1, 0.2, 7.0};
    constexpr double kGap = 1.7;
    Atoms atoms = chamber({{0, 0, 0}});
    std::vector<std::uint32_t> large;
    for (int i = 0; i < 3; ++i) {
        const double angle = 2.1 * i + 0.2;
        large.push_back(static_cast<std::uint32_t>(atoms.size()));
        testing::add_bead(atoms, gap + (kGap + radii[i]) * Vec3{std::cos(angle), std::sin(angle), 0.0}, radii[i]);
    }
    const std::vector<Tunnel> found = tunnels_of(atoms, {0.5, 0.3, 0.0});
    ASSERT_FALSE(found.empty());
    EXPECT_NEAR(found[0].path.bottleneck.radius, kGap, testing::kExact);
    EXPECT_NEAR(norm(found[0].path.bottleneck.position - gap), 0.0, testing::kExact);
    EXPECT_EQ(found[0].path.bottleneck.atoms, (std::array<std::uint32_t, 3>{large[0], large[1], large[2]}));
}

TEST(Tunnels, AreNoneFromAClosedChamberNorFromTheBulk) {
    const Atoms atoms = chamber({});
    EXPECT_TRUE(tunnels_of(atoms, {0.0, 0.0, 0.0}).empty());
    EXPECT_TRUE(tunnels_of(atoms, {0.0, 0.0, 40.0}).empty());
    EXPECT_TRUE(find_tunnels(ExactSurface(atoms), {}).empty());
}

TEST(Tunnels, EndOnTheSurfaceOfTheLargeProbe) {
    Atoms atoms = chamber({{0, 0, 0}});
    testing::add_ring(atoms, {0.0, 0.0, 7.0}, 2.2);
    const std::vector<Tunnel> found = tunnels_of(atoms, {0.5, 0.3, 0.0});
    ASSERT_FALSE(found.empty());
    const ExactSurface bulk(atoms, {.probe = 10.0});
    const Vec3 end = found[0].path.points.back().position;
    EXPECT_NEAR(bulk.signed_distance(std::span(&end, 1)).front(), 0.0, 1e-6);
}

TEST(Tunnels, HaveAProfileThatIsTrue) {
    Atoms atoms = chamber({{0, 0, 0}});
    testing::add_ring(atoms, {0.0, 0.0, 7.0}, 2.2);
    const Clearance clearance(atoms);
    const std::vector<Tunnel> found = tunnels_of(atoms, {0.5, 0.3, 0.0});
    ASSERT_FALSE(found.empty());
    const TunnelPath& path = found[0].path;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        EXPECT_DOUBLE_EQ(path.points[i].radius, clearance.at(path.points[i].position));
        if (i == 0) continue;
        const double step = norm(path.points[i].position - path.points[i - 1].position);
        EXPECT_LE(step, 0.25 + 1e-12);
        EXPECT_NEAR(path.points[i].distance - path.points[i - 1].distance, step, 1e-12);
    }
    EXPECT_DOUBLE_EQ(path.length, path.points.back().distance);
    EXPECT_NEAR(path.curvature * norm(path.points.back().position - path.points.front().position), path.length, 1e-9);
}

TEST(Tunnels, BeginAtAMaximumNearTheStart) {
    Atoms atoms = chamber({{0, 0, 0}});
    testing::add_ring(atoms, {0.0, 0.0, 7.0}, 2.2);
    const Clearance clearance(atoms);
    const Vec3 start{2.0, 1.5, -2.0};
    const std::vector<Tunnel> moved = tunnels_of(atoms, start);
    ASSERT_FALSE(moved.empty());
    EXPECT_GT(moved[0].path.points.front().radius, clearance.at(start) + 0.5);
    EXPECT_LE(norm(moved[0].path.points.front().position - start), 3.0);
    const std::vector<Tunnel> unmoved = tunnels_of(atoms, start, {.start_radius = 0.0});
    ASSERT_FALSE(unmoved.empty());
    EXPECT_EQ(unmoved[0].path.points.front().position, start);
}

TEST(Tunnels, HaveTheirStartAsBottleneckWhereItIsNarrowest) {
    Atoms atoms = chamber({{0, 0, 0}});
    testing::add_ring(atoms, {0.0, 0.0, 7.0}, 2.2);
    const Vec3 start{0.0, 0.0, -3.6};
    const std::vector<Tunnel> found = tunnels_of(atoms, start, {.start_radius = 0.0});
    ASSERT_FALSE(found.empty());
    EXPECT_TRUE(found[0].path.bottleneck.at_end);
    EXPECT_EQ(found[0].path.bottleneck.point, 0U);
    EXPECT_DOUBLE_EQ(found[0].path.bottleneck.radius, Clearance(atoms).at(start));
}

// Rotated by a matrix of Pythagorean quadruples and moved.
Vec3 turned(const Vec3& p) {
    return Vec3{(2 * p.x - p.y + 2 * p.z) / 3, (2 * p.x + 2 * p.y - p.z) / 3, (-p.x + 2 * p.y + 2 * p.z) / 3} +
           Vec3{17.3, -4.1, 9.9};
}

Atoms protein() { return testing::read_spheres(*testing::test_data() / "reference/xyzr/1fss.xyzr"); }

// Between the rings of tryptophan 84 and phenylalanine 330, at the bottom of the gorge of acetylcholinesterase.
constexpr Vec3 kGorge{13.7, 31.0, 15.5};

TEST(Tunnels, TurnWithTheMolecule) {
    MENISCUS_NEED_TEST_DATA();
    const Atoms atoms = protein();
    Atoms other = atoms;
    for (Vec3& centre : other.centres) centre = turned(centre);
    const std::vector<Tunnel> a = tunnels_of(atoms, kGorge);
    const std::vector<Tunnel> b = tunnels_of(other, turned(kGorge));
    ASSERT_FALSE(a.empty());
    ASSERT_EQ(a.size(), b.size());
    for (std::size_t i = 0; i < a.size(); ++i) {
        EXPECT_NEAR(a[i].path.bottleneck.radius, b[i].path.bottleneck.radius, testing::kExact);
        EXPECT_NEAR(norm(turned(a[i].path.bottleneck.position) - b[i].path.bottleneck.position), 0.0, 1e-7);
        EXPECT_EQ(a[i].path.bottleneck.atoms, b[i].path.bottleneck.atoms);
        EXPECT_NEAR(a[i].path.length, b[i].path.length, 0.05);
        EXPECT_NEAR(a[i].path.certified_radius, a[i].path.bottleneck.radius, testing::kExact);
    }
}

TEST(Tunnels, HaveTheSameBitsForAnyThreadsAndOrder) {
    MENISCUS_NEED_TEST_DATA();
    const Atoms atoms = protein();
    const auto n = static_cast<std::uint32_t>(atoms.size());
    Atoms reversed = atoms;
    std::reverse(reversed.centres.begin(), reversed.centres.end());
    std::reverse(reversed.radii.begin(), reversed.radii.end());
    const std::vector<Tunnel> one = tunnels_of(atoms, kGorge, {}, 1);
    const std::vector<Tunnel> more = tunnels_of(atoms, kGorge, {}, 3);
    const std::vector<Tunnel> other = tunnels_of(reversed, kGorge, {}, 1);
    ASSERT_FALSE(one.empty());
    ASSERT_EQ(one.size(), more.size());
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        const TunnelPath& path = one[i].path;
        for (const TunnelPath* same : {&more[i].path, &other[i].path}) {
            EXPECT_EQ(path.bottleneck.radius, same->bottleneck.radius);
            EXPECT_EQ(path.length, same->length);
            ASSERT_EQ(path.points.size(), same->points.size());
            for (std::size_t k = 0; k < path.points.size(); ++k)
                EXPECT_EQ(path.points[k].position, same->points[k].position);
        }
        std::array<std::uint32_t, 3> mirrored = other[i].path.bottleneck.atoms;
        for (std::uint32_t& atom : mirrored) atom = n - 1 - atom;
        std::sort(mirrored.begin(), mirrored.end());
        EXPECT_EQ(path.bottleneck.atoms, mirrored);
    }
}

TEST(Tunnels, RefuseOptionsOutOfRange) {
    const Atoms atoms = testing::random_beads(1, 30, 10.0);
    EXPECT_THROW(tunnels_of(atoms, {}, {.min_radius = 0.0}), UsageError);
    EXPECT_THROW(tunnels_of(atoms, {}, {.large_probe = -1.0}), UsageError);
    EXPECT_THROW(tunnels_of(atoms, {}, {.start_radius = -1.0}), UsageError);
    EXPECT_THROW(tunnels_of(atoms, {}, {.separation = NAN}), UsageError);
    EXPECT_THROW(tunnels_of(atoms, {NAN, 0.0, 0.0}), UsageError);
}

}  // namespace
}  // namespace meniscus
