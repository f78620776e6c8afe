// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <vector>

#include "meniscus/errors.h"
#include "meniscus/pockets.h"

namespace meniscus::testing {
namespace {

constexpr double kBead = 1.7;  // Å

// Beads on a sphere around a centre, evenly, where z is below a height: a closed shell, or a bowl.
void add_shell(Atoms& atoms, const Vec3& centre, double radius, double height) {
    const int count = static_cast<int>(4.0 * radius * radius);  // 3 Å² each: no probe passes
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0)) * i;
        const double r = std::sqrt(1.0 - z * z);
        if (radius * z > height) continue;
        atoms.centres.push_back(centre + radius * Vec3{r * std::cos(turn), r * std::sin(turn), z});
        atoms.radii.push_back(kBead);
    }
}

Atoms shell(double radius) {
    Atoms atoms;
    add_shell(atoms, {}, radius, radius);
    return atoms;
}

Atoms bowl(double radius, const Vec3& centre = {}) {
    Atoms atoms;
    add_shell(atoms, centre, radius, 0.5 * radius);
    return atoms;
}

Pockets find(const Atoms& atoms, const PocketOptions& options = {}, const RunOptions& run = {}) {
    return find_pockets(ExactSurface(atoms), {}, options, run);
}

double sum_of_volumes(const Pockets& pockets) {
    return std::accumulate(pockets.pockets.begin(), pockets.pockets.end(), pockets.rest_volume,
                           [](double sum, const Pocket& pocket) { return sum + pocket.volume; });
}

double area_of(const std::vector<PocketMouth>& mouths) {
    return std::accumulate(mouths.begin(), mouths.end(), 0.0,
                           [](double sum, const PocketMouth& mouth) { return sum + mouth.area; });
}

TEST(Pockets, AClosedShellHoldsACavityWithItsExactVolume) {
    const Atoms atoms = shell(7.0);
    const Pockets pockets = find(atoms);
    const auto cavity = std::find_if(pockets.pockets.begin(), pockets.pockets.end(),
                                     [](const Pocket& pocket) { return pocket.cavity; });
    ASSERT_NE(cavity, pockets.pockets.end());
    const ExactSurface exact(atoms);
    const Measures& measures = exact.measures();
    ASSERT_EQ(measures.components.size(), 2u);
    EXPECT_EQ(cavity->volume, measures.components[1].ses_volume);
    EXPECT_TRUE(cavity->mouths.empty());
    EXPECT_TRUE(cavity->openings.empty());
    EXPECT_NEAR(cavity->wall_area, measures.components[1].ses_area, 0.02 * measures.components[1].ses_area);
    EXPECT_NEAR(norm(cavity->centre), 0.0, 1.0);
}

TEST(Pockets, VolumesAddUpToTheExactOne) {
    const Atoms atoms = bowl(8.0);
    const Pockets pockets = find(atoms);
    const ExactSurface small(atoms);
    const double exact =
        small.of_same_atoms({SurfaceKind::Ses, 10.0}).measures().totals.ses_volume - small.measures().totals.ses_volume;
    EXPECT_EQ(pockets.volume, exact);
    EXPECT_NEAR(sum_of_volumes(pockets), exact, 1e-9 * exact);
}

TEST(Pockets, ABowlIsOneOpenPocket) {
    const Pockets pockets = find(bowl(8.0));
    ASSERT_FALSE(pockets.pockets.empty());
    const Pocket& pocket = pockets.pockets.front();
    EXPECT_FALSE(pocket.cavity);
    EXPECT_LT(std::hypot(pocket.centre.x, pocket.centre.y), 1.0);
    EXPECT_GT(area_of(pocket.mouths) + area_of(pocket.openings), 50.0);
    EXPECT_LE(area_of(pocket.mouths), pockets.mouth_area);
    EXPECT_GT(pocket.depth, 4.0);
    EXPECT_LT(pocket.deepest.z, pocket.centre.z + 8.0);
    double wall = 0.0;
    for (const WallAtom& atom : pocket.wall) wall += atom.area;
    EXPECT_DOUBLE_EQ(pocket.wall_area, wall);
}

TEST(Pockets, TheScaleTendsToOneAsTheSpacingHalves) {
    const Atoms atoms = bowl(8.0);
    const double coarse = std::abs(find(atoms, {.spacing = 1.0}).scale - 1.0);
    const double fine = std::abs(find(atoms, {.spacing = 0.25}).scale - 1.0);
    EXPECT_LT(coarse, 0.01);
    EXPECT_LT(fine, 0.0005);
}

void expect_same(const Pockets& a, const Pockets& b, const Vec3& shift = {}) {
    EXPECT_EQ(a.scale, b.scale);
    EXPECT_EQ(a.rest_volume, b.rest_volume);
    ASSERT_EQ(a.pockets.size(), b.pockets.size());
    for (std::size_t i = 0; i < a.pockets.size(); ++i) {
        EXPECT_EQ(a.pockets[i].score, b.pockets[i].score);
        EXPECT_EQ(a.pockets[i].volume, b.pockets[i].volume);
        EXPECT_EQ(a.pockets[i].centre + shift, b.pockets[i].centre);
        EXPECT_EQ(area_of(a.pockets[i].mouths), area_of(b.pockets[i].mouths));
        EXPECT_EQ(area_of(a.pockets[i].openings), area_of(b.pockets[i].openings));
        EXPECT_EQ(a.pockets[i].wall.size(), b.pockets[i].wall.size());
    }
}

TEST(Pockets, NumberOfThreadsAndOrderOfAtomsDoNotMatter) {
    const Atoms atoms = bowl(8.0);
    const Pockets one = find(atoms, {}, {.threads = 1});
    expect_same(one, find(atoms, {}, {.threads = 2}));
    std::vector<std::size_t> order(atoms.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::shuffle(order.begin(), order.end(), std::mt19937(3));
    Atoms shuffled;
    for (const std::size_t i : order) {
        shuffled.centres.push_back(atoms.centres[i]);
        shuffled.radii.push_back(atoms.radii[i]);
    }
    expect_same(one, find(shuffled));
}

TEST(Pockets, OfMoleculesFarApartAreThoseOfEach) {
    const Pockets alone = find(bowl(8.0));
    Atoms both = bowl(8.0);
    add_shell(both, {100000.0, 0.0, 0.0}, 8.0, 4.0);
    const Pockets pockets = find(both);
    EXPECT_NEAR(pockets.volume, 2.0 * alone.volume, 1e-6 * alone.volume);
    ASSERT_GE(pockets.pockets.size(), 2u);
    EXPECT_NEAR(pockets.pockets[0].volume, alone.pockets[0].volume, 0.01 * alone.pockets[0].volume);
    EXPECT_NEAR(pockets.pockets[1].volume, alone.pockets[0].volume, 0.01 * alone.pockets[0].volume);
    EXPECT_EQ(pockets.pockets[0].tied_with, std::vector<std::size_t>{2});
}

PocketOptions at(const Vec3& point, double reach) {
    PocketOptions options;
    options.places = {{{point}, reach}};
    return options;
}

TEST(PocketPlaces, TheMiddleOfABowlIsItsPocket) {
    const Pockets pockets = find(bowl(8.0), at({}, 4.0));
    ASSERT_EQ(pockets.pockets.size(), 1u);
    const Pocket& pocket = pockets.pockets[0];
    const double ball = 4.0 / 3.0 * std::numbers::pi * 64.0;
    EXPECT_NEAR(pocket.volume, ball, 0.1 * ball);
    EXPECT_EQ(pocket.points_inside, 1u);
    EXPECT_NEAR(sum_of_volumes(pockets), pockets.volume, 1e-6 * pockets.volume);
    EXPECT_LT(pocket.volume, find(bowl(8.0), at({}, 5.0)).pockets[0].volume);
}

TEST(PocketPlaces, ACavityIsThereAsAWhole) {
    const Atoms atoms = shell(7.0);
    const Pockets pockets = find(atoms, at({0.5, 0.0, 0.0}, 1.5));
    ASSERT_EQ(pockets.pockets.size(), 1u);
    EXPECT_TRUE(pockets.pockets[0].cavity);
    EXPECT_EQ(pockets.pockets[0].volume, ExactSurface(atoms).measures().components[1].ses_volume);
}

TEST(PocketPlaces, ACavityThatNoPlaceNamesIsInTheRest) {
    const Atoms atoms = shell(7.0);
    const Pockets pockets = find(atoms, at({100.0, 0.0, 0.0}, 4.0));
    ASSERT_EQ(pockets.pockets.size(), 1u);
    EXPECT_EQ(pockets.pockets[0].volume, 0.0);
    EXPECT_EQ(pockets.pockets[0].points_inside, 0u);
    EXPECT_NEAR(pockets.rest_volume, pockets.volume, 1e-9 * pockets.volume);
}

TEST(PocketPlaces, SpaceGoesToTheNearestPlace) {
    PocketOptions options;
    options.places = {{{{-1.5, 0.0, 0.0}}, 4.0}, {{{1.5, 0.0, 0.0}}, 4.0}};
    const Pockets pockets = find(bowl(8.0), options);
    ASSERT_EQ(pockets.pockets.size(), 2u);
    for (const PocketVoxel& voxel : pockets.voxels) {
        if (voxel.pocket == kNone) continue;
        const double side = voxel.pocket == 0 ? -1.0 : 1.0;
        EXPECT_GE(side * voxel.position.x, -1e-9);
    }
    EXPECT_NEAR(sum_of_volumes(pockets), pockets.volume, 1e-6 * pockets.volume);
}

TEST(PocketPlaces, RefusesPlacesThatMakeNoSense) {
    PocketOptions options;
    options.places = {{}};
    EXPECT_THROW(find(bowl(8.0), options), UsageError);
    EXPECT_THROW(find(bowl(8.0), at({}, 0.0)), UsageError);
    EXPECT_THROW(find(bowl(8.0), at({std::nan(""), 0.0, 0.0}, 4.0)), UsageError);
}

// Of 0.1 Å³ no voxel has a share worth speaking of: this was scaled by 10^12.
TEST(Pockets, WhatNoVoxelHoldsIsTheRest) {
    const Atoms atoms{{{}, {1.0, 0.0, 0.0}}, {1.9, 1.9}};
    const Pockets pockets = find(atoms);
    EXPECT_EQ(pockets.scale, 1.0);
    EXPECT_EQ(pockets.rest_volume, pockets.volume);
    for (const Check& check : pocket_checks(pockets)) EXPECT_TRUE(check.passed) << check.name;
}

TEST(Pockets, ASingleAtomHasNone) {
    const Pockets pockets = find({{{1.0, 2.0, 3.0}}, {1.5}});
    EXPECT_TRUE(pockets.pockets.empty());
    EXPECT_NEAR(pockets.volume, 0.0, 1e-9);
    EXPECT_NEAR(pockets.rest_volume, 0.0, 1e-9);
    for (const Check& check : pocket_checks(pockets)) EXPECT_TRUE(check.passed) << check.name;
}

TEST(Pockets, AreSortedAsAsked) {
    Atoms atoms = bowl(7.0);
    add_shell(atoms, {60.0, 0.0, 0.0}, 10.0, 5.0);
    for (const PocketRank rank : {PocketRank::Volume, PocketRank::Depth}) {
        const Pockets pockets = find(atoms, {.rank = rank});
        ASSERT_GE(pockets.pockets.size(), 2u);
        for (std::size_t i = 0; i < pockets.pockets.size(); ++i) {
            EXPECT_EQ(pockets.pockets[i].rank, i + 1);
            if (i == 0) continue;
            const Pocket& before = pockets.pockets[i - 1];
            const Pocket& pocket = pockets.pockets[i];
            EXPECT_GE(rank == PocketRank::Volume ? before.volume : before.depth,
                      rank == PocketRank::Volume ? pocket.volume : pocket.depth);
        }
    }
}

TEST(Pockets, VoxelsAndPocketsNameEachOther) {
    const Pockets pockets = find(bowl(8.0));
    std::size_t in_pockets = 0;
    for (std::uint32_t i = 0; i < pockets.pockets.size(); ++i)
        for (const std::uint32_t v : pockets.pockets[i].voxels) {
            EXPECT_EQ(pockets.voxels[v].pocket, i);
            ++in_pockets;
        }
    const auto labelled = std::count_if(pockets.voxels.begin(), pockets.voxels.end(),
                                        [](const PocketVoxel& voxel) { return voxel.pocket != kNone; });
    EXPECT_EQ(static_cast<std::size_t>(labelled), in_pockets);
    EXPECT_GT(in_pockets, 0u);
}

TEST(Pockets, RefusesOptionsThatMakeNoSense) {
    const Atoms atoms = bowl(8.0);
    EXPECT_THROW(find(atoms, {.probe = 0.0}), UsageError);
    EXPECT_THROW(find(atoms, {.probe = 4.0, .large_probe = 4.0}), UsageError);
    EXPECT_THROW(find(atoms, {.spacing = 0.0}), UsageError);
    EXPECT_THROW(find(atoms, {.spacing = 3.0}), UsageError);
    EXPECT_THROW(find(atoms, {.spacing = 0.1}), UsageError);
    EXPECT_THROW(find(atoms, {.large_probe = 101.0}), UsageError);
    EXPECT_THROW(find(atoms, {.large_probe = std::nan("")}), UsageError);
    EXPECT_THROW(find(atoms, {.count = 0}), UsageError);
    const std::vector<AtomClass> too_few(atoms.size() - 1, AtomClass::Other);
    EXPECT_THROW(find_pockets(ExactSurface(atoms), too_few), UsageError);
}

}  // namespace
}  // namespace meniscus::testing
