// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The audit: the side of every node of the band against the exact geometry.
#include "band/sides.h"

#include <gtest/gtest.h>

#include <cmath>

#include "band/surface_blocks.h"
#include "core/parallel.h"
#include "meniscus/threads.h"
#include "support/arrangements.h"
#include "support/sampled_field.h"

namespace meniscus::testing {
namespace {

constexpr std::size_t kAnyNumber = 1'000'000;
constexpr double kTie = 1e-9;  // Å: nearer to the surface rounding decides

// As the program finds them.
struct Sides {
    Sides(const Atoms& atoms, double probe, double h, const Vec3& origin = {0.1, 0.1, 0.1})
        : surface(atoms, probe),
          grid(h, origin, blocks_near_surface(surface, {.spacing = h, .origin = origin}, 1.8 * h, kAnyNumber)),
          inside(find_sides(surface, grid)) {}

    AccessibleSurface surface;
    BlockGrid grid;
    std::vector<InsideBits> inside;
};

void expect_every_node(const Sides& sides) {
    ASSERT_EQ(sides.inside.size(), sides.grid.block_count());
    std::size_t count = 0;
    for (BlockId b = 0; b < sides.grid.block_count(); ++b)
        for (int z = 0; z < kBlockEdge; ++z)
            for (int y = 0; y < kBlockEdge; ++y)
                for (int x = 0; x < kBlockEdge; ++x) {
                    const Vec3 place = node_position(sides.grid, b, x, y, z);
                    const double s = sides.surface.nearest(place).signed_distance;
                    const bool inside = inside_bit(sides.inside[b], x, y, z);
                    count += inside ? 1 : 0;
                    if (std::abs(s) < kTie) continue;
                    ASSERT_EQ(inside, s < 0.0) << b << ' ' << x << ' ' << y << ' ' << z << ' ' << s;
                }
    EXPECT_GT(count, 0U);
    EXPECT_LT(count, sides.grid.node_count());
}

TEST(Sides, AreThoseOfTheExactDistanceOnAwkwardArrangements) {
    for (const Arrangement& a : awkward_arrangements()) {
        SCOPED_TRACE(a.name);
        expect_every_node(Sides(a.atoms, a.probe, 0.5));
        expect_every_node(Sides(a.atoms, a.probe, 0.25));
        expect_every_node(Sides(a.atoms, a.probe, 0.5, {0, 0, 0}));  // nodes on planes of symmetry, centres and ties
    }
}

TEST(Sides, AreThoseOfTheExactDistanceOnRandomClusters) {
    for (std::uint64_t seed = 20; seed < 24; ++seed) {
        SCOPED_TRACE(seed);
        expect_every_node(Sides(random_cluster(seed, 60, 10.0), 0.7 * static_cast<double>(seed - 20), 0.5));
        expect_every_node(Sides(random_cluster(seed, 60, 12.0), 1.4, 2.0));
    }
}

// Where units are larger than balls.
TEST(Sides, AreThoseOfTheExactDistanceOnCoarseGrids) {
    for (std::uint64_t seed = 24; seed < 30; ++seed)
        for (const double spacing : {2.0, 3.0, 5.0}) {
            SCOPED_TRACE(spacing);
            expect_every_node(
                Sides(random_cluster(seed, 400, 10.0 * spacing), 0.7 * static_cast<double>(seed % 3), spacing));
        }
}

TEST(Sides, AreOutsideFarFromEveryAtom) {
    const AccessibleSurface surface(two_spheres(3.0), 1.4);
    const BlockGrid grid(0.5, {}, {{.z = 1000, .y = 0, .x = 0}, {.z = 0, .y = -5, .x = 0}});
    for (const InsideBits& bits : find_sides(surface, grid)) EXPECT_EQ(bits, InsideBits{});
}

TEST(Sides, AreTheSameForAnyNumberOfThreadsAndOrderOfAtoms) {
    const Atoms atoms = random_cluster(40, 200, 16.0);
    const Sides two(atoms, 1.4, 0.5);
    const ThreadLimit limit(1);
    EXPECT_EQ(Sides(shuffled(atoms, 3).atoms, 1.4, 0.5).inside, two.inside);
}

}  // namespace
}  // namespace meniscus::testing
