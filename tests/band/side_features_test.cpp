// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/side_features.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "support/arrangements.h"

namespace meniscus::testing {
namespace {

// The cap with a number, which may be one that buries nothing.
void expect_cap(std::span<const EightCaps> caps, std::size_t number, const SmallVec3& axis, float t) {
    const EightCaps& eight = caps[number / EightCaps::kCount];
    const std::size_t k = number % EightCaps::kCount;
    EXPECT_EQ((SmallVec3{eight.x[k], eight.y[k], eight.z[k]}), axis) << number;
    EXPECT_EQ(eight.t[k], t) << number;
}

void expect_caps(const AccessibleSurface::Data& data, const SideCaps& caps, std::uint32_t atom) {
    const std::span<const CapPlane> wanted = data.caps_of(atom);
    const std::span<const EightCaps> eights = caps.of(atom);
    ASSERT_EQ(eights.size(), (wanted.size() + EightCaps::kCount - 1) / EightCaps::kCount);
    for (std::size_t c = 0; c < wanted.size(); ++c)
        expect_cap(eights, c, to_small(wanted[c].axis), static_cast<float>(wanted[c].t));
    for (std::size_t c = wanted.size(); c < EightCaps::kCount * eights.size(); ++c)
        expect_cap(eights, c, {}, EightCaps::kNothing);
}

TEST(SideCaps, AreThoseOfExposedBallsEightByEight) {
    std::size_t most = 0;
    std::size_t filled_up = 0;
    std::size_t buried = 0;
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        SCOPED_TRACE(seed);
        const AccessibleSurface surface(random_cluster(seed, 60, 8.0), 0.5);
        const AccessibleSurface::Data& data = surface.data();
        const SideCaps caps(data);
        for (std::uint32_t i = 0; i < data.atoms.size(); ++i) {
            ASSERT_EQ(caps.is_exposed(i), data.exposed[i] != 0) << i;
            if (!caps.is_exposed(i)) {
                EXPECT_TRUE(caps.of(i).empty()) << i;
                ++buried;
                continue;
            }
            expect_caps(data, caps, i);
            most = std::max(most, data.caps_of(i).size());
            filled_up += data.caps_of(i).size() % EightCaps::kCount != 0 ? 1 : 0;
        }
    }
    EXPECT_GT(most, EightCaps::kCount);
    EXPECT_GT(filled_up, 0U);
    EXPECT_GT(buried, 0U);
}

TEST(SideCaps, OfABallAloneAreNone) {
    const AccessibleSurface surface(equal_spheres({{1, 2, 3}}, 1.7), 1.4);
    const SideCaps caps(surface.data());
    ASSERT_TRUE(caps.is_exposed(0));
    EXPECT_TRUE(caps.of(0).empty());
}

TEST(SideGatherer, TakesFeaturesRelativeToTheMiddleOfABox) {
    const AccessibleSurface surface(random_cluster(3, 60, 8.0), 1.4);
    const AccessibleSurface::Data& data = surface.data();
    const Vec3 middle = data.atoms.centres[0] + Vec3{1.0, 0.5, 1.0};
    const Box box{middle - Vec3{1.0, 1.0, 1.0}, middle + Vec3{1.0, 1.0, 1.0}};
    LocalFeatures around(surface, 0.4);
    around.gather({box.low - Vec3{1.0, 1.0, 1.0}, box.high + Vec3{1.0, 1.0, 1.0}});
    LocalFeatures local(surface, 0.4);
    local.gather_from(around, box);
    SideFeaturesOfBox near;
    SideGatherer().gather(around, box, around.margin(), near);

    const SideFeatures& features = near.features;
    ASSERT_EQ(features.balls.size(), local.balls().size());
    ASSERT_GT(features.balls.size(), 0U);
    for (std::size_t i = 0; i < features.balls.size(); ++i) {
        const std::uint32_t atom = features.atoms[i];
        EXPECT_EQ(position_in(features.balls, i), to_small(data.atoms.centres[atom] - middle)) << i;
        EXPECT_EQ(features.balls[3][i], static_cast<float>(data.rho[atom])) << i;
    }
    ASSERT_EQ(features.vertices.size(), local.vertices().size());
    ASSERT_GT(features.vertices.size(), 0U);
    for (std::size_t i = 0; i < features.vertices.size(); ++i)
        EXPECT_EQ(position_in(features.vertices, i), to_small(position_in(local.vertices(), i) - middle)) << i;
    ASSERT_EQ(features.arcs.size(), local.arcs().size());
    ASSERT_EQ(near.cells.size(), local.arcs().size());
    ASSERT_GT(features.arcs.size(), 0U);
    for (std::size_t i = 0; i < features.arcs.size(); ++i) {
        const SasArc& arc = data.arcs[local.arcs().index(i)];
        EXPECT_EQ(features.arcs[i].centre, to_small(arc.centre - middle)) << i;
        EXPECT_EQ(features.arcs[i].radius, static_cast<float>(arc.radius)) << i;
    }
}

}  // namespace
}  // namespace meniscus::testing
