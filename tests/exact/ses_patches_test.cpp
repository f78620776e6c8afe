// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact/ses_patches.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

std::size_t count(const SesPatches& patches, PatchKind kind) {
    return static_cast<std::size_t>(std::count_if(patches.patches().begin(), patches.patches().end(),
                                                  [&](const SesPatch& patch) { return patch.kind == kind; }));
}

TEST(SesPatches, TwoBridgedSpheresAreThreePatchesInOnePiece) {
    const AccessibleSurface surface({{{0, 0, 0}, {3, 0, 0}}, {1.7, 1.5}}, 1.4);
    const SesPatches patches(surface, 0);
    EXPECT_EQ(count(patches, PatchKind::Contact), 2U);
    EXPECT_EQ(count(patches, PatchKind::Toroidal), 1U);
    EXPECT_EQ(patches.component_count(), 1U);
    EXPECT_EQ(patches.sas_component_count(), 1U);
}

TEST(SesPatches, ASpindleTorusIsTwoPatchesInTwoPieces) {
    const AccessibleSurface surface({{{0, 0, 0}, {5.9, 0, 0}}, {1.7, 1.7}}, 1.4);
    const SesPatches patches(surface, 0);
    EXPECT_EQ(count(patches, PatchKind::Toroidal), 2U);
    EXPECT_EQ(patches.component_count(), 2U);
    EXPECT_EQ(patches.sas_component_count(), 1U);
    EXPECT_NE(patches.component_at({0.0, 0.0, 1.7}), patches.component_at({5.9, 0.0, 1.7}));
    EXPECT_EQ(patches.component_at({1.9, 0.0, 0.1}), patches.component_at({0.0, 0.0, 1.7}));
}

TEST(SesPatches, ThreeSpheresHaveTwoReentrantPatches) {
    const AccessibleSurface surface({{{0, 0, 0}, {2.5, 0, 0}, {1.2, 2.2, 0}}, {1.7, 1.6, 1.5}}, 1.4);
    const SesPatches patches(surface, 0);
    EXPECT_EQ(count(patches, PatchKind::Contact), 3U);
    EXPECT_EQ(count(patches, PatchKind::Toroidal), 3U);
    EXPECT_EQ(count(patches, PatchKind::Reentrant), 2U);
    EXPECT_EQ(patches.component_count(), 1U);
    EXPECT_TRUE(patches.unresolved().empty());
    EXPECT_FALSE(patches.degenerate());
}

TEST(SesPatches, SpheresApartAreTheirOwnPieces) {
    const AccessibleSurface surface({{{0, 0, 0}, {20, 0, 0}, {0, 20, 0}}, {1.7, 1.6, 1.5}}, 1.4);
    const SesPatches patches(surface, 0);
    EXPECT_EQ(patches.component_count(), 3U);
    EXPECT_EQ(patches.sas_component_count(), 3U);
}

}  // namespace
}  // namespace meniscus
