// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/spherical_region.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "geometry/random_caps.h"

namespace meniscus::testing {
namespace {

constexpr double kPi = std::numbers::pi;

struct Built {
    std::vector<Cap> caps;
    ContourBuilder builder;
    SphericalRegions regions;

    explicit Built(std::vector<Cap> given) : caps(std::move(given)) {
        EXPECT_TRUE(builder.build(columns_of(caps)));
        regions.measure(builder.kept_caps(), builder.arcs());
    }
    double solid_angle() const {
        double sum = 0.0;
        for (const SphericalRegion& region : regions.regions()) sum += region.solid_angle;
        return sum;
    }
    Vec3 vector_area() const {
        Vec3 sum;
        for (const SphericalRegion& region : regions.regions()) sum += region.vector_area;
        return sum;
    }
    bool exposed(const Vec3& n) const {
        return std::none_of(caps.begin(), caps.end(), [&](const Cap& cap) { return dot(cap.axis, n) > cap.t; });
    }
};

TEST(SphericalRegions, AWholeSphereHasFourPi) {
    const Built whole({});
    ASSERT_EQ(whole.regions.regions().size(), 1U);
    EXPECT_NEAR(whole.solid_angle(), 4 * kPi, 1e-14);
}

TEST(SphericalRegions, OneCapLeavesItsComplement) {
    for (const double t : {-0.9, -0.2, 0.0, 0.4, 0.99}) {
        const Built one({{normalised({1, 2, 3}), t, 0}});
        ASSERT_EQ(one.regions.regions().size(), 1U);
        EXPECT_NEAR(one.solid_angle(), 2 * kPi * (1 + t), 1e-13);
        // The integral of n over the complement of a cap: -π(1 - t²) along its axis.
        EXPECT_NEAR(dot(one.vector_area(), normalised({1, 2, 3})), -kPi * (1 - t * t), 1e-13);
    }
}

TEST(SphericalRegions, TwoCapsApartLeaveOneRegionBetweenThem) {
    const Built two({{{0, 0, 1}, 0.5, 0}, {{0, 0, -1}, 0.7, 1}});
    ASSERT_EQ(two.regions.regions().size(), 1U);
    EXPECT_NEAR(two.solid_angle(), 2 * kPi * (0.5 + 0.7), 1e-13);
}

TEST(SphericalRegions, AnOctantHasAnEighthOfTheSphere) {
    const Built octant({{{-1, 0, 0}, 0.0, 0}, {{0, -1, 0}, 0.0, 1}, {{0, 0, -1}, 0.0, 2}});
    ASSERT_EQ(octant.regions.regions().size(), 1U);
    EXPECT_NEAR(octant.solid_angle(), kPi / 2, 1e-13);
    EXPECT_NEAR(octant.vector_area().x, kPi / 4, 1e-13);
    EXPECT_NEAR(octant.vector_area().z, kPi / 4, 1e-13);
}

// A closed belt of caps around the equator leaves two regions, north and south.
std::vector<Cap> belt(int count, double t) {
    std::vector<Cap> caps;
    for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(count); ++k) {
        const double angle = 2 * kPi * (k + 0.123) / count;
        caps.push_back({{std::cos(angle), std::sin(angle), 0.0}, t, k});
    }
    return caps;
}

TEST(SphericalRegions, ABeltOfCapsLeavesTwoRegions) {
    const Built two(belt(8, 0.85));
    ASSERT_EQ(two.regions.regions().size(), 2U);
    EXPECT_NEAR(two.regions.regions()[0].solid_angle, two.regions.regions()[1].solid_angle, 1e-12);
    EXPECT_NE(two.regions.region_of({0, 0, 1}), two.regions.region_of({0, 0, -1}));
}

TEST(SphericalRegions, ACapBesideABeltJoinsTheRightRegion) {
    std::vector<Cap> caps = belt(8, 0.85);
    caps.push_back({normalised({0.1, 0.05, 1.0}), 0.97, 8});   // an island in the north
    caps.push_back({normalised({-0.3, 0.2, 1.0}), 0.99, 9});   // and another
    caps.push_back({normalised({0.1, 0.1, -1.0}), 0.95, 10});  // and one in the south
    const Built parts(caps);
    ASSERT_EQ(parts.regions.regions().size(), 2U);
    const std::uint32_t north = parts.regions.region_of(normalised({0.3, -0.3, 1.0}));
    const std::uint32_t south = parts.regions.region_of(normalised({-0.3, -0.3, -1.0}));
    ASSERT_NE(north, south);
    const double side = 0.5 * Built(belt(8, 0.85)).solid_angle();
    EXPECT_NEAR(parts.regions.regions()[north].solid_angle, side - 2 * kPi * (0.03 + 0.01), 1e-12);
    EXPECT_NEAR(parts.regions.regions()[south].solid_angle, side - 2 * kPi * 0.05, 1e-12);
}

TEST(SphericalRegions, RandomCapsAgreeWithSampling) {
    std::mt19937_64 random(4);
    for (std::uint64_t seed = 0; seed < 40; ++seed) {
        const Built built(random_caps(seed, 12, 0.2, 0.95));
        int hits = 0;
        Vec3 sum;
        std::vector<int> region_hits(built.regions.regions().size() + 1, 0);
        constexpr int kSamples = 20000;
        for (int s = 0; s < kSamples; ++s) {
            const Vec3 n = random_direction(random);
            if (!built.exposed(n)) continue;
            ++hits;
            sum += n;
            ++region_hits[built.regions.region_of(n)];
        }
        const double scale = 4 * kPi / kSamples;
        EXPECT_NEAR(built.solid_angle(), scale * hits, 0.25);
        EXPECT_NEAR(norm(built.vector_area() - scale * sum), 0.0, 0.25);
        for (std::size_t r = 0; r < built.regions.regions().size(); ++r)
            EXPECT_NEAR(built.regions.regions()[r].solid_angle, scale * region_hits[r], 0.25);
    }
}

}  // namespace
}  // namespace meniscus::testing
