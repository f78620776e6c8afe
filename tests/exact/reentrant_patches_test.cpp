// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact/reentrant_patches.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace meniscus {
namespace {

Atoms triangle_of_atoms(double side, double radius) {
    return {{{0, 0, 0}, {side, 0, 0}, {0.5 * side, std::sqrt(0.75) * side, 0}}, {radius, radius, radius}};
}

double whole(const ReentrantPatch& patch) {
    double sum = 0.0;
    for (const SphericalRegion& region : patch.regions) sum += region.solid_angle;
    return sum;
}

TEST(ReentrantPatches, CompactTriangleIsNotTrimmed) {
    const AccessibleSurface surface(triangle_of_atoms(2.5, 1.7), 1.4);
    const auto patches = trim_reentrant_patches(surface, 0);
    ASSERT_EQ(patches.size(), 2U);
    for (const ReentrantPatch& patch : patches) {
        EXPECT_TRUE(patch.consistent);
        ASSERT_EQ(patch.regions.size(), 1U);
        EXPECT_NEAR(whole(patch), patch.triangle, 1e-12);
        EXPECT_EQ(patch.arcs.size(), 3U);
    }
}

// Probes above and below a wide triangle reach through it and meet in its plane.
TEST(ReentrantPatches, ProbesOnBothSidesTrimEachOther) {
    const AccessibleSurface surface(triangle_of_atoms(5.0, 1.7), 1.4);
    const auto patches = trim_reentrant_patches(surface, 0);
    ASSERT_EQ(patches.size(), 2U);
    const double height = surface.data().vertices[0].position.z;
    ASSERT_LT(std::abs(height), 1.4);
    for (const ReentrantPatch& patch : patches) {
        EXPECT_LT(whole(patch), patch.triangle - 0.1);
        EXPECT_NEAR(whole(patch), whole(patches[0]), 1e-8);
        // The cap beyond the plane of the atoms lies wholly within the triangle: it is cut out of its middle.
        const double cap = 2 * std::acos(-1.0) * (1 - std::abs(height) / 1.4);
        EXPECT_NEAR(patch.triangle - whole(patch), cap, 1e-7);
    }
}

TEST(ReentrantPatches, TrimmedPatchIsAPartOfItsTriangleForAnySeed) {
    std::mt19937_64 random(12);
    std::uniform_real_distribution<double> within(0.0, 10.0);
    Atoms atoms;
    for (int i = 0; i < 60; ++i) {
        atoms.centres.push_back({within(random), within(random), within(random)});
        atoms.radii.push_back(1.6);
    }
    const AccessibleSurface surface(atoms, 1.4);
    const auto first = trim_reentrant_patches(surface, 0);
    const auto second = trim_reentrant_patches(surface, 1);
    ASSERT_GT(first.size(), 50U);
    for (std::size_t v = 0; v < first.size(); ++v) {
        EXPECT_TRUE(first[v].consistent);
        EXPECT_FALSE(first[v].degenerate);
        EXPECT_GE(whole(first[v]), -1e-9);
        EXPECT_LE(whole(first[v]), first[v].triangle + 1e-9);
        EXPECT_NEAR(whole(first[v]), whole(second[v]), 1e-7);
    }
}

TEST(ReentrantPatches, ProbeOfNoSizeHasNone) {
    const AccessibleSurface surface(triangle_of_atoms(2.5, 1.7), 0.0);
    for (const ReentrantPatch& patch : trim_reentrant_patches(surface, 0)) EXPECT_TRUE(patch.regions.empty());
}

TEST(ReentrantPatches, ProbesThatTouchMoreThanThreeAtomsCoincide) {
    Atoms square{{{0, 0, 0}, {3, 0, 0}, {3, 3, 0}, {0, 3, 0}}, {1.7, 1.7, 1.7, 1.7}};
    EXPECT_TRUE(has_coincident_probes(AccessibleSurface(square, 1.4).data()));
    square.centres[2] = {3, 3, 1e-3};
    EXPECT_FALSE(has_coincident_probes(AccessibleSurface(square, 1.4).data()));
}

}  // namespace
}  // namespace meniscus
