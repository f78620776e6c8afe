// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The audit: every node of the band against the exact geometry, and against brute force.
#include "band/distance_band.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "band/surface_blocks.h"
#include "core/parallel.h"
#include "meniscus/threads.h"
#include "support/arrangements.h"
#include "support/brute_force_ses.h"
#include "support/sampled_field.h"
#include "support/test_data.h"

namespace meniscus::testing {
namespace {

constexpr std::size_t kNoLimit = 1'000'000;

// As the program samples it: margin of five spacings, on the blocks near the surface.
struct Sampled {
    Sampled(const Atoms& atoms, double probe, double h, double band_margin, const Vec3& origin = {0.1, 0.1, 0.1})
        : surface(atoms, probe),
          margin(band_margin),
          grid(h, origin, blocks_near_surface(surface, {.spacing = h, .origin = origin}, margin, kNoLimit)),
          band(sample_distance(surface, grid, margin)) {}

    Vec3 position(std::size_t n) const {
        const int node = static_cast<int>(n % kBlockNodes);
        return node_position(grid, static_cast<BlockId>(n / kBlockNodes), node % 8, node / 8 % 8, node / 64);
    }

    AccessibleSurface surface;
    double margin;
    BlockGrid grid;
    DistanceBand band;
};

// At ties of features either one's curvature is right: the range over tiny steps around p.
std::pair<double, double> curvature_range(const AccessibleSurface& surface, const Vec3& p, double limit) {
    constexpr double kStep = 1e-6;
    double low = limit;
    double high = -limit;
    for (const double x : {-kStep, 0.0, kStep})
        for (const double y : {-kStep, 0.0, kStep})
            for (const double z : {-kStep, 0.0, kStep}) {
                const double h = std::clamp(surface.nearest(p + Vec3{x, y, z}).mean_curvature, -limit, limit);
                low = std::min(low, h);
                high = std::max(high, h);
            }
    return {low, high};
}

void expect_node(const Sampled& sampled, std::size_t n) {
    const NearestFeature exact = sampled.surface.nearest(sampled.position(n));
    const double expected = std::clamp(exact.signed_distance, -sampled.margin, sampled.margin);
    ASSERT_NEAR(sampled.band.distance[n], expected, 1e-6) << "node " << n;
    if (std::abs(exact.signed_distance) > sampled.margin + 1e-9) {
        ASSERT_EQ(sampled.band.curvature[n], 0.0F);
    }
    if (std::abs(exact.signed_distance) > sampled.margin - 1e-9) return;
    const double limit = 1.0 / sampled.grid.spacing();
    const auto [low, high] = curvature_range(sampled.surface, sampled.position(n), limit);
    ASSERT_GE(sampled.band.curvature[n], low - 1e-4) << "node " << n;
    ASSERT_LE(sampled.band.curvature[n], high + 1e-4) << "node " << n;
}

void expect_every_node(const Sampled& sampled) {
    ASSERT_EQ(sampled.band.distance.size(), sampled.grid.node_count());
    ASSERT_EQ(sampled.band.curvature.size(), sampled.grid.node_count());
    for (std::size_t n = 0; n < sampled.grid.node_count(); ++n) expect_node(sampled, n);
}

void expect_all_claimed(const Sampled& sampled) {
    const auto margin = static_cast<float>(sampled.margin);
    const auto limit = static_cast<float>(1.0 / sampled.grid.spacing());
    for (std::size_t n = 0; n < sampled.grid.node_count(); ++n) {
        const float s = sampled.band.distance[n];
        ASSERT_TRUE(s >= -margin && s <= margin) << s;
        const float h = sampled.band.curvature[n];
        ASSERT_TRUE(h >= -limit && h <= limit) << h;
    }
}

void expect_brute_force(const Atoms& atoms, double probe, double spacing, std::size_t count) {
    const Sampled sampled(atoms, probe, spacing, 5.0 * spacing);
    expect_all_claimed(sampled);
    const BruteForceSes oracle(atoms, probe);
    std::mt19937_64 random(9);
    double worst = 0.0;
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t n = std::uniform_int_distribution<std::size_t>(0, sampled.grid.node_count() - 1)(random);
        const double s = std::clamp(oracle.signed_distance(sampled.position(n)), -sampled.margin, sampled.margin);
        worst = std::max(worst, std::abs(s - double{sampled.band.distance[n]}));
    }
    EXPECT_LT(worst, 1e-5);
}

TEST(DistanceBand, EqualsTheExactDistanceOnAwkwardArrangements) {
    for (const Arrangement& a : awkward_arrangements()) {
        SCOPED_TRACE(a.name);
        expect_every_node(Sampled(a.atoms, a.probe, 0.5, 1.2));
    }
}

TEST(DistanceBand, EqualsTheExactDistanceWhereTheMarginExceedsTheProbe) {
    for (const Arrangement& a : awkward_arrangements()) {
        SCOPED_TRACE(a.name);
        expect_every_node(Sampled(a.atoms, a.probe, 0.5, 2.5));
    }
}

// Nodes on the planes of symmetry, on centres and on ties.
TEST(DistanceBand, EqualsTheExactDistanceWithNodesOnSymmetryPlanes) {
    for (const Arrangement& a : awkward_arrangements()) {
        SCOPED_TRACE(a.name);
        expect_every_node(Sampled(a.atoms, a.probe, 0.5, 1.5, {0, 0, 0}));
    }
}

TEST(DistanceBand, EqualsTheExactDistanceOnRandomClusters) {
    for (std::uint64_t seed = 20; seed < 24; ++seed) {
        SCOPED_TRACE(seed);
        expect_every_node(Sampled(random_cluster(seed, 60, 10.0), 0.7 * static_cast<double>(seed - 20), 0.5, 1.7));
    }
}

TEST(DistanceBand, EqualsTheExactDistanceOnAFineGrid) {
    expect_every_node(Sampled(two_spheres(5.9), 1.4, 0.1, 0.5));
    expect_every_node(Sampled(triangle(4.6, 1.7), 1.4, 0.15, 0.4));
}

TEST(DistanceBand, EqualsTheExactDistanceOnACoarseGrid) {
    expect_every_node(Sampled(random_cluster(30, 60, 12.0), 1.4, 2.0, 10.0));
}

TEST(DistanceBand, EqualsBruteForceOnAwkwardArrangements) {
    for (const Arrangement& a : awkward_arrangements()) {
        if (a.name == "ring through a point") continue;  // whether the point is free is for the perturbation to say
        SCOPED_TRACE(a.name);
        expect_brute_force(a.atoms, a.probe, 0.25, 1500);
    }
}

TEST(DistanceBand, EqualsTheExactDistanceInANarrowBand) {
    for (const Arrangement& a : awkward_arrangements()) {
        SCOPED_TRACE(a.name);
        expect_every_node(Sampled(a.atoms, a.probe, 0.25, 1.5 * 0.25));
    }
}

TEST(DistanceBand, HasTheRightSignDeepInsideAndFarOutside) {
    const Sampled sampled(cubic_lattice(5, 2.5, 1.7), 1.4, 0.5, 0.6);
    for (std::size_t n = 0; n < sampled.grid.node_count(); ++n) {
        const double s = sampled.surface.nearest(sampled.position(n)).signed_distance;
        if (s < -0.6) {
            EXPECT_EQ(sampled.band.distance[n], -0.6F);
        }
        if (s > 0.6) {
            EXPECT_EQ(sampled.band.distance[n], 0.6F);
        }
    }
}

TEST(DistanceBand, BlocksFarFromEveryAtomAreOutside) {
    const AccessibleSurface surface(two_spheres(3.0), 1.4);
    const BlockGrid grid(0.5, {}, {{.z = 1000, .y = 0, .x = 0}, {.z = 0, .y = -5, .x = 0}});
    const DistanceBand band = sample_distance(surface, grid, 1.0);
    EXPECT_TRUE(std::all_of(band.distance.begin(), band.distance.end(), [](float s) { return s == 1.0F; }));
    EXPECT_TRUE(std::all_of(band.curvature.begin(), band.curvature.end(), [](float h) { return h == 0.0F; }));
}

TEST(DistanceBand, KeepsItsBitsForAnyNumberOfThreadsAndOrderOfAtoms) {
    const Atoms atoms = random_cluster(40, 200, 16.0);
    const Sampled two(atoms, 1.4, 0.5, 2.5);
    const ThreadLimit limit(1);
    const Sampled one(shuffled(atoms, 3).atoms, 1.4, 0.5, 2.5);
    EXPECT_EQ(one.band.distance, two.band.distance);
    EXPECT_EQ(one.band.curvature, two.band.curvature);
}

TEST(DistanceBand, EqualsBruteForceOnEverySphereFile) {
    MENISCUS_NEED_TEST_DATA();
    for (const auto& entry : std::filesystem::directory_iterator(*test_data() / "reference/spheres")) {
        SCOPED_TRACE(entry.path().filename().string());
        expect_brute_force(read_spheres(entry.path()), 1.4, 0.25, 10000);
        expect_brute_force(read_spheres(entry.path()), 1.4, 0.5, 2000);
    }
}

TEST(DistanceBand, EqualsBruteForceOnCrambin) {
    MENISCUS_NEED_TEST_DATA();
    expect_brute_force(read_spheres(*test_data() / "reference/xyzr/1crn.xyzr"), 1.4, 0.25, 10000);
}

TEST(DistanceBand, ClaimsEveryNodeOfALargeLattice) { expect_all_claimed({cubic_lattice(8, 3.2, 1.7), 1.4, 0.3, 1.5}); }

}  // namespace
}  // namespace meniscus::testing
