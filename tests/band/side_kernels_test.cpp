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

// A cube of points somewhere in a cluster. Those within `radius` of the surface may stay open, Å.
struct Place {
    double radius;
    AccessibleSurface surface;
    SideCaps caps;
    Vec3 middle;
    LocalFeatures local;
    SideFeaturesOfBox near;
    LanePoints<float> points;  // from the middle

    Place(std::uint64_t seed, double probe, double radius_of_points)
        : radius(radius_of_points),
          surface(random_cluster(seed, 40, 8.0), probe),
          caps(surface.data()),
          local(surface, radius + 1e-3) {
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
    SideLimits limits(double reach) const { return {surface.data().probe, radius, reach, kLongest}; }
    KnownSides settle(const SideFeatures& features, const SideLimits& limits,
                      const SideKernels& kernels = side_kernels()) const {
        SideWork work;
        return kernels.settle(caps, features, limits, points, kBatchLanes, work);
    }
};

// How many points there were, and how many stayed open that need not.
struct Tally {
    std::size_t open = 0;
    std::size_t total = 0;

    // Expects that what is settled of the first `count` points is true. from: what they are relative to, from the
    // place's middle.
    void add(const Place& place, const KnownSides& sides, const LanePoints<float>& points, std::size_t count,
             const Vec3& from) {
        EXPECT_EQ(sides.settled & ~first_bits(count), 0U);
        EXPECT_EQ(sides.inside & ~sides.settled, 0U);
        for (std::size_t i = 0; i < count; ++i) {
            const double s = place.distance(from + get_point(points, i));
            const bool settled = (sides.settled >> i & 1U) != 0;
            if (settled) {
                EXPECT_EQ((sides.inside >> i & 1U) != 0, s < 0.0) << s;
                EXPECT_GT(std::abs(s), place.radius) << i;
            }
            open += std::abs(s) > place.radius + 0.01 && !settled ? 1 : 0;
            ++total;
        }
    }
    void expect_few_open() const {
        EXPECT_GT(total, 2000U);
        EXPECT_LT(open, total / 500);
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
            const Place place(seed, 0.35 * static_cast<double>(seed % 5), radius);
            if (place.near.features.balls.size() > 0) visit(place, place.limits(kReach));
        }
}

TEST(SideKernels, SettleNearlyAllPointsAndNoneWrongly) {
    Tally tally;
    for_each_place([&](const Place& place, const SideLimits& limits) {
        tally.add(place, place.settle(place.near.features, limits), place.points, kBatchLanes, {});
    });
    tally.expect_few_open();
}

TEST(SideKernels, AreTheSameForAllSetsOfInstructions) {
    for_each_place([](const Place& place, const SideLimits& limits) {
        const std::vector<SideKernels> all = supported_side_kernels();
        const KnownSides plain = place.settle(place.near.features, limits, all.front());
        for (const SideKernels& kernels : all) {
            const KnownSides sides = place.settle(place.near.features, limits, kernels);
            EXPECT_EQ(sides.inside, plain.inside) << kernels.instructions;
            EXPECT_EQ(sides.settled, plain.settled) << kernels.instructions;
        }
    });
}

// Whatever ball they choose by; by the deepest one they choose fewer than by the first.
TEST(SideKernels, SettleTheSameWithWhatTheyChoose) {
    constexpr SideCube kCube{{}, static_cast<float>(kHalfEdge)};
    std::size_t total = 0;
    std::size_t by_deepest = 0;
    std::size_t by_first = 0;
    for_each_place([&](const Place& place, const SideLimits& limits) {
        for (const SideKernels& kernels : supported_side_kernels()) {
            const KnownSides all = place.settle(place.near.features, limits, kernels);
            total += static_cast<std::size_t>(std::popcount(all.settled));
            const auto choose_by = [&](std::size_t ball) {
                SideFeatures chosen;
                kernels.choose(place.near, kCube, limits, ball, chosen);
                const KnownSides few = place.settle(chosen, limits, kernels);
                EXPECT_EQ(few.inside & all.settled, all.inside & few.settled) << ball;
                EXPECT_EQ(all.settled & ~few.settled, 0U) << ball;
                return chosen.balls.size();
            };
            by_deepest += choose_by(deepest_in(place.near.features, kCube.middle));
            by_first += choose_by(0);
        }
    });
    EXPECT_GT(total, 2000U);
    EXPECT_LT(by_deepest, by_first);
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
    Tally tally;
    std::size_t balls_left_out = 0;
    std::size_t arcs_left_out = 0;
    std::size_t vertices_left_out = 0;
    for_each_place([&](const Place& place, const SideLimits&) {
        const SideLimits limits = place.limits(1.7321 * kSmallStep);
        const SideFeatures& all = place.near.features;
        for (const SideKernels& kernels : supported_side_kernels())
            for (std::size_t at = 0; at < kCorners; ++at) {
                const Vec3 middle = corner(at, 1.5 * kSmallStep);
                const SideCube cube{to_small(middle), static_cast<float>(kSmallStep)};
                SideFeatures chosen;
                kernels.choose(place.near, cube, limits, deepest_in(all, cube.middle), chosen);
                balls_left_out += all.balls.size() - chosen.balls.size();
                arcs_left_out += all.arcs.size() - chosen.arcs.size();
                vertices_left_out += all.vertices.size() - chosen.vertices.size();
                SideWork work;
                tally.add(place, kernels.settle(place.caps, chosen, limits, points, kCorners, work), points, kCorners,
                          middle);
            }
    });
    tally.expect_few_open();
    EXPECT_GT(balls_left_out, 0U);
    EXPECT_GT(arcs_left_out, 0U);
    EXPECT_GT(vertices_left_out, 0U);
}

}  // namespace
}  // namespace meniscus::testing
