// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>

#include "meniscus/errors.h"
#include "meniscus/tunnels.h"
#include "support/arrangements.h"
#include "tunnels/drilled_block.h"

namespace meniscus {
namespace {

std::optional<TunnelPath> pore_of(const Atoms& atoms, const Vec3& point, const Vec3& direction,
                                  const PoreOptions& options = {}) {
    const ExactSurface exact(atoms);
    return find_pore(exact, ends_along(exact, point, direction), options);
}

// A wide channel along z in a block, 24 Å across: wider than any probe.
Atoms channel(double free) {
    return testing::block({18.0, 18.0, 12.0}, [&](const Vec3& p) { return std::hypot(p.x, p.y) > free + 1.0; });
}

TEST(EndsAlong, AreWhereTheSlabOfAllAtomsEnds) {
    const ExactSurface exact({{{0, 0, -3}, {0, 0, 5}}, {1.0, 2.0}});
    const PoreEnds ends = ends_along(exact, {4, 5, 6}, {0, 0, -2});
    EXPECT_NEAR(norm(ends.from - Vec3{4, 5, 7}), 0.0, 1e-12);
    EXPECT_NEAR(norm(ends.to - Vec3{4, 5, -4}), 0.0, 1e-12);
    EXPECT_THROW(ends_along(exact, {}, {0, 0, 0}), UsageError);
    EXPECT_THROW(ends_along(exact, {}, {0, NAN, 0}), UsageError);
}

TEST(Pore, OfARingIsItsFreeRadius) {
    const std::optional<TunnelPath> pore = pore_of(testing::ring(30, 7.0, 1.5), {0.3, 0.1, 0.0}, {0, 0, 1});
    ASSERT_TRUE(pore);
    EXPECT_NEAR(pore->bottleneck.radius, 5.5, testing::kExact);
    EXPECT_NEAR(norm(pore->bottleneck.position), 0.0, testing::kExact);
    EXPECT_NEAR(pore->certified_radius, 5.5, testing::kExact);
    EXPECT_NEAR(pore->points.front().position.z, -1.5, testing::kExact);
    EXPECT_NEAR(pore->points.back().position.z, 1.5, testing::kExact);
    EXPECT_NEAR(pore->length, 3.0, 1e-6);
}

TEST(Pore, LeadsFromItsFirstEndToItsSecond) {
    const Atoms atoms = testing::ring(30, 7.0, 1.5);
    const std::optional<TunnelPath> up = pore_of(atoms, {}, {0, 0, 1});
    const std::optional<TunnelPath> down = pore_of(atoms, {}, {0, 0, -1});
    ASSERT_TRUE(up && down);
    EXPECT_LT(up->points.front().position.z, up->points.back().position.z);
    EXPECT_GT(down->points.front().position.z, down->points.back().position.z);
}

TEST(Pore, MayBeWiderThanTheLargeProbe) {
    Atoms atoms = channel(12.0);
    testing::add_ring(atoms, {0.4, 0.0, 1.0}, 11.0);
    const std::optional<TunnelPath> pore = pore_of(atoms, {}, {0, 0, 1});
    ASSERT_TRUE(pore);
    EXPECT_NEAR(pore->bottleneck.radius, 11.0, testing::kExact);
    EXPECT_NEAR(norm(pore->bottleneck.position - Vec3{0.4, 0.0, 1.0}), 0.0, testing::kExact);
    EXPECT_NEAR(pore->certified_radius, 11.0, testing::kExact);
}

TEST(Pore, DoesNotLeadRoundTheMolecule) {
    // Closed in the middle: the only way from end to end is outside.
    const Atoms atoms = testing::block({9.0, 9.0, 9.0},
                                       [](const Vec3& p) { return std::hypot(p.x, p.y) > 4.0 || std::abs(p.z) < 2.0; });
    EXPECT_FALSE(pore_of(atoms, {}, {0, 0, 1}, {.reach = 8.0}));
}

TEST(Pore, JoinsPointsInside) {
    Atoms atoms = channel(3.0);
    testing::add_ring(atoms, {0.0, 0.0, 8.0}, 1.2);  // beyond the second end
    testing::add_ring(atoms, {0.0, 0.0, 0.0}, 1.9);
    const ExactSurface exact(atoms);
    const std::optional<TunnelPath> pore = find_pore(exact, {{0.5, 0.0, -4.0}, {0.0, 0.4, 4.0}}, {.start_radius = 0.0});
    ASSERT_TRUE(pore);
    EXPECT_NEAR(pore->bottleneck.radius, 1.9, testing::kExact);
    EXPECT_EQ(pore->points.front().position, (Vec3{0.5, 0.0, -4.0}));
    EXPECT_EQ(pore->points.back().position, (Vec3{0.0, 0.4, 4.0}));
    const std::optional<TunnelPath> whole = find_pore(exact, ends_along(exact, {}, {0, 0, 1}));
    ASSERT_TRUE(whole);
    EXPECT_NEAR(whole->bottleneck.radius, 1.2, testing::kExact);
}

TEST(Pore, RefusesOptionsOutOfRange) {
    const ExactSurface exact(testing::ring(30, 7.0, 1.5));
    EXPECT_THROW(find_pore(exact, {{0, 0, 1}, {0, 0, 1}}), UsageError);
    EXPECT_THROW(find_pore(exact, {{0, 0, 1}, {0, 0, NAN}}), UsageError);
    EXPECT_THROW(find_pore(exact, {{0, 0, 1}, {1e300, 0, 2}}), UsageError);
    EXPECT_THROW(find_pore(exact, {{0, 0, 1}, {0, 0, 2}}, {.min_radius = 0.0}), UsageError);
    EXPECT_THROW(find_pore(exact, {{0, 0, 1}, {0, 0, 2}}, {.reach = 0.0}), UsageError);
}

}  // namespace
}  // namespace meniscus
