// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/surface_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.h"
#include "meniscus/errors.h"
#include "meniscus/threads.h"
#include "support/arrangements.h"

namespace meniscus::testing {
namespace {

constexpr std::size_t kEveryBlock = 1'000'000;

bool lists(const std::vector<BlockCoord>& blocks, const BlockCoord& block) {
    return std::binary_search(blocks.begin(), blocks.end(), block);
}

// Every point near the surface is in a listed block, and no listed block is far from it.
void expect_cover(const Arrangement& a, const Lattice& lattice, double margin) {
    const AccessibleSurface surface(a.atoms, a.probe);
    const std::vector<BlockCoord> blocks = blocks_near_surface(surface, lattice, margin, kEveryBlock);
    EXPECT_TRUE(std::is_sorted(blocks.begin(), blocks.end()));
    EXPECT_EQ(std::adjacent_find(blocks.begin(), blocks.end()), blocks.end());
    for (const Vec3& p : random_points_around(a.atoms, 4000, 4.0 + margin))
        if (std::abs(surface.nearest(p).signed_distance) < margin) {
            EXPECT_TRUE(lists(blocks, lattice.block_of(p)));
        }
    const double edge = lattice.block_edge();
    for (const BlockCoord& block : blocks) {
        const Vec3 centre = lattice.corner(block) + 0.5 * edge * Vec3{1, 1, 1};
        EXPECT_LE(std::abs(surface.nearest(centre).signed_distance), margin + 0.5 * std::numbers::sqrt3 * edge);
    }
}

TEST(SurfaceBlocks, HoldEveryPointNearTheSurface) {
    for (const Arrangement& a : awkward_arrangements()) {
        SCOPED_TRACE(a.name);
        expect_cover(a, {.spacing = 0.25, .origin = {0.1, 0.1, 0.1}}, 1.25);
    }
}

TEST(SurfaceBlocks, HoldMarginsWiderThanTheProbe) {
    for (const Arrangement& a : awkward_arrangements()) {
        SCOPED_TRACE(a.name);
        expect_cover(a, {.spacing = 0.8, .origin = {}}, 4.0);
    }
}

TEST(SurfaceBlocks, FindEveryPieceHoweverFar) {
    const Atoms atoms{{{0, 0, 0}, {500, 0, 0}, {0, -3e5, 2e5}}, {1.5, 1.7, 2.0}};
    const Lattice lattice{.spacing = 0.5, .origin = {}};
    const std::vector<BlockCoord> blocks =
        blocks_near_surface(AccessibleSurface(atoms, 1.4), lattice, 1.0, kEveryBlock);
    for (std::size_t i = 0; i < atoms.size(); ++i)
        EXPECT_TRUE(lists(blocks, lattice.block_of(atoms.centres[i] + Vec3{atoms.radii[i], 0, 0})));
}

TEST(SurfaceBlocks, FindTheWallOfAVoid) {
    const Atoms shell = hollow_shell(150, 8.0, 1.7);
    const Lattice lattice{.spacing = 0.25, .origin = {}};
    const std::vector<BlockCoord> blocks =
        blocks_near_surface(AccessibleSurface(shell, 1.4), lattice, 0.5, kEveryBlock);
    EXPECT_TRUE(lists(blocks, lattice.block_of({6.3, 0.1, 0.1})));
    EXPECT_FALSE(lists(blocks, lattice.block_of({0.1, 0.1, 0.1})));
}

TEST(SurfaceBlocks, AreTheSameForAnyNumberOfThreads) {
    const AccessibleSurface surface(random_cluster(1, 300, 20.0), 1.4);
    const Lattice lattice{.spacing = 0.5, .origin = {}};
    const std::vector<BlockCoord> two = blocks_near_surface(surface, lattice, 1.0, kEveryBlock);
    const ThreadLimit limit(1);
    EXPECT_EQ(two, blocks_near_surface(surface, lattice, 1.0, kEveryBlock));
}

TEST(SurfaceBlocks, RefuseMoreThanTheLimit) {
    const AccessibleSurface surface(random_cluster(2, 100, 15.0), 1.4);
    const Lattice lattice{.spacing = 0.25, .origin = {}};
    const std::size_t count = blocks_near_surface(surface, lattice, 1.0, kEveryBlock).size();
    EXPECT_EQ(blocks_near_surface(surface, lattice, 1.0, count).size(), count);
    EXPECT_THROW(blocks_near_surface(surface, lattice, 1.0, count - 1), LimitError);
    EXPECT_THROW(blocks_near_surface(surface, lattice, 1.0, 1), LimitError);
}

TEST(SurfaceBlocks, RefuseCoordinatesThatDoNotFit) {
    const AccessibleSurface surface({{{0, 0, 0}, {1e11, 0, 0}}, {1.5, 1.5}}, 1.4);
    EXPECT_THROW(blocks_near_surface(surface, {.spacing = 0.5, .origin = {}}, 1.0, kEveryBlock), LimitError);
}

TEST(Lattice, NamesTheBlockOfAPoint) {
    const Lattice lattice{.spacing = 0.5, .origin = {0.1, 0.2, 0.3}};
    EXPECT_EQ(lattice.block_edge(), 4.0);
    EXPECT_EQ(lattice.block_of({0.1, 0.2, 0.3}), (BlockCoord{.z = 0, .y = 0, .x = 0}));
    EXPECT_EQ(lattice.block_of({4.2, 0.1, -3.8}), (BlockCoord{.z = -2, .y = -1, .x = 1}));
    EXPECT_EQ((lattice.corner(BlockCoord{.z = -2, .y = -1, .x = 1})), (lattice.origin + Vec3{4.0, -4.0, -8.0}));
    EXPECT_THROW(lattice.block_of({0, 1e300, 0}), LimitError);
    EXPECT_THROW(lattice.block_of({0, 0, std::nan("")}), LimitError);
}

}  // namespace
}  // namespace meniscus::testing
