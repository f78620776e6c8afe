// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/side_kernels.h"

#include <gtest/gtest.h>

#include <cmath>

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
    Vec3 middle;
    LocalFeatures local;
    SideFeaturesOfBox near;
    LanePoints<float> points;  // from the middle

    Place(std::uint64_t seed, double probe, double radius)
        : surface(random_cluster(seed, 40, 8.0), probe), local(surface, radius + 1e-3) {
        middle = surface.data().atoms.centres[0] + Vec3{1.0, 0.5, 1.0};
        const Vec3 half{kHalfEdge, kHalfEdge, kHalfEdge};
        const Box box{middle - half, middle + half};
        local.gather(box);
        near.gather(local, box, local.margin());
        const auto along = [](std::size_t place) {
            return static_cast<float>(kStep * static_cast<double>(place) - kHalfEdge);
        };
        for (std::size_t i = 0; i < kBatchLanes; ++i) {
            points.x[i] = along(i % kEdge);
            points.y[i] = along(i / kEdge % kEdge);
            points.z[i] = along(i / (kEdge * kEdge));
        }
    }
    double distance(std::size_t i) const {
        return surface.nearest(middle + Vec3(SmallVec3{points.x[i], points.y[i], points.z[i]})).signed_distance;
    }
};

// Clusters with the probe and the radius around each point.
template <class Visit>
void for_each_place(const Visit& visit) {
    for (std::uint64_t seed = 1; seed <= 40; ++seed)
        for (const double radius : {0.0, 0.4}) {
            SCOPED_TRACE(seed);
            const double probe = 0.35 * static_cast<double>(seed % 5);
            Place place(seed, probe, radius);
            if (place.near.features().balls.empty()) continue;
            visit(place, SideLimits(probe, radius, kReach, kLongest), radius);
        }
}

TEST(SideKernels, SettleNearlyAllPointsAndNoneWrongly) {
    std::size_t open = 0;
    std::size_t total = 0;
    for_each_place([&](const Place& place, const SideLimits& limits, double radius) {
        SideWork work;
        const KnownSides sides =
            side_kernels().settle(place.surface.data(), place.near.features(), limits, place.points, kBatchLanes, work);
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
        const auto settle = [&](const SideKernels& kernels) {
            SideWork work;
            return kernels.settle(place.surface.data(), place.near.features(), limits, place.points, kBatchLanes, work);
        };
        const std::vector<SideKernels> all = supported_side_kernels();
        const KnownSides plain = settle(all.front());
        for (const SideKernels& kernels : all) {
            EXPECT_EQ(settle(kernels).inside, plain.inside) << kernels.instructions;
            EXPECT_EQ(settle(kernels).settled, plain.settled) << kernels.instructions;
        }
    });
}

TEST(SideKernels, SettleTheSameWithWhatTheyChoose) {
    for_each_place([](const Place& place, const SideLimits& limits, double) {
        for (const SideKernels& kernels : supported_side_kernels()) {
            SideFeatures chosen;
            const SideCube cube{{}, static_cast<float>(kHalfEdge)};
            kernels.choose(place.near, cube, limits, 0, chosen);
            EXPECT_LE(chosen.balls.size(), place.near.features().balls.size());
            SideWork work;
            const KnownSides few =
                kernels.settle(place.surface.data(), chosen, limits, place.points, kBatchLanes, work);
            const KnownSides all =
                kernels.settle(place.surface.data(), place.near.features(), limits, place.points, kBatchLanes, work);
            EXPECT_EQ(few.inside & all.settled, all.inside & few.settled);
        }
    });
}

}  // namespace
}  // namespace meniscus::testing
