// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/side_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "core/bits.h"
#include "support/arrangements.h"

namespace meniscus::testing {
namespace {

constexpr std::size_t kEdge = 4;
constexpr double kStep = 0.3;                            // Å
constexpr double kHalfEdge = 0.5 * (kEdge - 1) * kStep;  // Å
constexpr double kReach = 1.7321 * kHalfEdge;            // Å
constexpr double kLongest = 2.0 * kReach + 2.0 * 4.0;    // Å: the balls are smaller than 4 Å

// A cube of points somewhere in a cluster.
struct Place {
    AccessibleSurface surface;
    SideCaps caps;
    Vec3 middle;
    LocalFeatures local;
    SideFeaturesOfBox near;
    LanePoints<float> points;  // from the middle

    Place(std::uint64_t seed, double probe, double radius)
        : surface(random_cluster(seed, 40, 8.0), probe), caps(surface.data()), local(surface, radius + 1e-3) {
        middle = surface.data().atoms.centres[0] + Vec3{1.0, 0.5, 1.0};
        const Vec3 half{kHalfEdge, kHalfEdge, kHalfEdge};
        const Box box{middle - half, middle + half};
        local.gather(box);
        SideGatherer().gather(local, box, local.margin(), near);
        const auto along = [](std::size_t place) { return kStep * static_cast<double>(place) - kHalfEdge; };
        for (std::size_t i = 0; i < kBatchLanes; ++i)
            set_point(points, i, {along(i % kEdge), along(i / kEdge % kEdge), along(i / (kEdge * kEdge))});
    }
    double distance(const Vec3& from_middle) const { return surface.nearest(middle + from_middle).signed_distance; }
    double distance(std::size_t i) const { return distance(get_point(points, i)); }
    KnownSides settle(const SideFeatures& features, const SideLimits& limits) const {
        return settle(side_kernels(), features, limits);
    }
    KnownSides settle(const SideKernels& kernels, const SideFeatures& features, const SideLimits& limits) const {
        SideWork work;
        return kernels.settle(caps, features, limits, points, kBatchLanes, work);
    }
};

std::size_t deepest_in(const SideFeatures& features, const Vec3& point) {
    std::size_t deepest = 0;
    double most = -1e9;
    for (std::size_t b = 0; b < features.balls.size(); ++b) {
        const Vec3 centre{features.balls[0][b], features.balls[1][b], features.balls[2][b]};
        const double depth = features.balls[3][b] - norm(centre - point);
        if (depth > most) deepest = b;
        most = std::max(most, depth);
    }
    return deepest;
}

// Clusters with the probe and the radius around each point.
template <class Visit>
void for_each_place(const Visit& visit) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
        for (const double radius : {0.0, 0.4}) {
            SCOPED_TRACE(seed);
            const double probe = 0.35 * static_cast<double>(seed % 5);
            Place place(seed, probe, radius);
            if (place.near.features.balls.size() == 0) continue;
            visit(place, SideLimits(probe, radius, kReach, kLongest), radius);
        }
}

TEST(SideKernels, SettleNearlyAllPointsAndNoneWrongly) {
    std::size_t open = 0;
    std::size_t total = 0;
    for_each_place([&](const Place& place, const SideLimits& limits, double radius) {
        const KnownSides sides = place.settle(place.near.features, limits);
        EXPECT_EQ(sides.inside & ~sides.settled, 0U);
        for (std::size_t i = 0; i < kBatchLanes; ++i) {
            const double s = place.distance(i);
            const bool settled = (sides.settled >> i & 1U) != 0;
            if (settled) {
                EXPECT_EQ((sides.inside >> i & 1U) != 0, s < 0.0) << s;
                EXPECT_GT(std::abs(s), radius) << i;
            }
            open += std::abs(s) > radius + 0.01 && !settled ? 1 : 0;
            ++total;
        }
    });
    EXPECT_GT(total, 2000U);
    EXPECT_LT(open, total / 500);
}

TEST(SideKernels, AreTheSameForAllSetsOfInstructions) {
    for_each_place([](const Place& place, const SideLimits& limits, double) {
        const std::vector<SideKernels> all = supported_side_kernels();
        const KnownSides plain = place.settle(all.front(), place.near.features, limits);
        for (const SideKernels& kernels : all) {
            const KnownSides sides = place.settle(kernels, place.near.features, limits);
            EXPECT_EQ(sides.inside, plain.inside) << kernels.instructions;
            EXPECT_EQ(sides.settled, plain.settled) << kernels.instructions;
        }
    });
}

TEST(SideKernels, SettleTheSameWithWhatTheyChoose) {
    std::size_t lost = 0;
    std::size_t total = 0;
    for_each_place([&](const Place& place, const SideLimits& limits, double) {
        for (const SideKernels& kernels : supported_side_kernels()) {
            SideFeatures chosen;
            const SideCube cube{{}, static_cast<float>(kHalfEdge)};
            const std::size_t deepest = deepest_in(place.near.features, cube.middle);
            kernels.choose(place.near, cube, limits, deepest, chosen);
            const KnownSides few = place.settle(kernels, chosen, limits);
            const KnownSides all = place.settle(kernels, place.near.features, limits);
            EXPECT_EQ(few.inside & all.settled, all.inside & few.settled);
            lost += static_cast<std::size_t>(std::popcount(all.settled & ~few.settled));
            total += static_cast<std::size_t>(std::popcount(all.settled));
        }
    });
    EXPECT_GT(total, 2000U);
    EXPECT_LT(lost, total / 1000);
}

// Eight points around the middle of each eighth of the cube, with what is chosen for it.
TEST(SideKernels, SettleFewPointsBesideTheMiddle) {
    constexpr double kSmallStep = kHalfEdge / 3.0;
    constexpr std::size_t kCorners = 8;
    const auto corner = [](std::size_t i, double length) {
        return Vec3{(i & 1U) != 0 ? length : -length, (i & 2U) != 0 ? length : -length,
                    (i & 4U) != 0 ? length : -length};
    };
    LanePoints<float> points;
    for (std::size_t i = 0; i < kCorners; ++i) set_point(points, i, corner(i, kSmallStep));
    std::size_t open = 0;
    std::size_t total = 0;
    std::size_t left_out = 0;
    for_each_place([&](const Place& place, const SideLimits&, double radius) {
        const SideLimits limits(place.surface.data().probe, radius, 1.7321 * kSmallStep, kLongest);
        for (const SideKernels& kernels : supported_side_kernels())
            for (std::size_t at = 0; at < kCorners; ++at) {
                const SideCube cube{to_small(corner(at, 1.5 * kSmallStep)), static_cast<float>(kSmallStep)};
                SideFeatures chosen;
                kernels.choose(place.near, cube, limits, deepest_in(place.near.features, cube.middle), chosen);
                left_out += place.near.features.balls.size() - chosen.balls.size();
                SideWork work;
                const KnownSides sides = kernels.settle(place.caps, chosen, limits, points, kCorners, work);
                EXPECT_EQ(sides.settled & ~first_bits(kCorners), 0U);
                EXPECT_EQ(sides.inside & ~sides.settled, 0U);
                for (std::size_t i = 0; i < kCorners; ++i) {
                    const double s = place.distance(corner(at, 1.5 * kSmallStep) + corner(i, kSmallStep));
                    const bool settled = (sides.settled >> i & 1U) != 0;
                    if (settled) {
                        EXPECT_EQ((sides.inside >> i & 1U) != 0, s < 0.0) << s;
                        EXPECT_GT(std::abs(s), radius) << i;
                    }
                    open += std::abs(s) > radius + 0.01 && !settled ? 1 : 0;
                    ++total;
                }
            }
    });
    EXPECT_GT(total, 2000U);
    EXPECT_LT(open, total / 500);
    EXPECT_GT(left_out, 0U);
}

}  // namespace
}  // namespace meniscus::testing
