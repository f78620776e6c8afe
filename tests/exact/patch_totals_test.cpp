// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact/patch_totals.h"

#include <gtest/gtest.h>

#include "exact/ses_patches.h"
#include "support/arrangements.h"

namespace meniscus {
namespace {

// The sums without patches against the sum over the patches.
TEST(PatchTotals, AreTheSumsOverAllPatches) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const AccessibleSurface surface(testing::random_cluster(seed, 150, 12.0), 1.4, seed);
        PatchIntegrals ses[3];
        PatchIntegrals sas;
        const SesPatches patches(surface, seed);
        const PatchTotals found = sum_patches(surface, seed, &patches);
        for (const SesPatch& patch : patches.patches()) {
            ses[static_cast<int>(patch.kind)] += patch.ses;
            sas += patch.sas;
        }
        const auto of = [&](PatchKind kind) { return ses[static_cast<int>(kind)]; };
        const double tolerance = 1e-12 * found.totals.sas_volume;
        EXPECT_NEAR(found.totals.sas_area, sas.area, tolerance);
        EXPECT_NEAR(found.totals.sas_volume, sas.volume, tolerance);
        EXPECT_NEAR(found.totals.contact_area, of(PatchKind::Contact).area, tolerance);
        EXPECT_NEAR(found.totals.toroidal_area, of(PatchKind::Toroidal).area, tolerance);
        EXPECT_NEAR(found.totals.reentrant_area, of(PatchKind::Reentrant).area, tolerance);
        EXPECT_NEAR(found.totals.ses_volume, ses[0].volume + ses[1].volume + ses[2].volume, tolerance);
        std::vector<PatchIntegrals> pieces(patches.component_count());
        for (const SesPatch& patch : patches.patches()) pieces[patch.component] += patch.ses;
        ASSERT_EQ(found.components.size(), pieces.size());
        for (std::size_t c = 0; c < pieces.size(); ++c) {
            EXPECT_NEAR(found.components[c].ses_area, pieces[c].area, tolerance);
            EXPECT_NEAR(found.components[c].ses_volume, pieces[c].volume, tolerance);
        }
        EXPECT_EQ(found.degenerate, patches.degenerate());
        EXPECT_EQ(found.unresolved, patches.unresolved());
    }
}

// Another perturbation leaves other numbers, but every patch finds its piece.
TEST(PatchTotals, OfAnotherPerturbationAreDividedAmongTheSamePieces) {
    for (std::uint64_t seed = 0; seed < 10; ++seed) {
        const AccessibleSurface surface(testing::random_cluster(seed, 150, 12.0), 1.4);
        const SesPatches patches(surface, 0);
        const PatchTotals found = sum_patches(surface.perturbed(1), 1, &patches);
        std::vector<PatchIntegrals> pieces(patches.component_count());
        for (const SesPatch& patch : patches.patches()) pieces[patch.component] += patch.ses;
        ASSERT_EQ(found.components.size(), pieces.size());
        for (std::size_t c = 0; c < pieces.size(); ++c) {
            EXPECT_NEAR(found.components[c].ses_area, pieces[c].area, 1e-6);
            EXPECT_NEAR(found.components[c].ses_volume, pieces[c].volume, 1e-6);
        }
    }
}

}  // namespace
}  // namespace meniscus
