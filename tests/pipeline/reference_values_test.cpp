// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/reference_values.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/arrangements.h"

namespace meniscus::testing {
namespace {

std::size_t count(const ReferenceValues& reference, bool inside) {
    return static_cast<std::size_t>(std::count_if(reference.points.begin(), reference.points.end(),
                                                  [inside](const DeepPoint& p) { return p.inside == inside; }));
}

TEST(ReferenceValues, BothWaysGiveTheSameVolumes) {
    const Atoms shell = hollow_shell(60, 5.2, 1.7);
    const AccessibleSurface accessible(shell, 1.4);
    const Measures measured = measure(shell);
    for (const double spacing : {0.5, 1.2}) {  // the probe is resolved, and is not
        const SurfaceOptions options{.spacing = spacing};
        const ReferenceValues quick = find_reference_values(accessible, shell, options);
        const ReferenceValues full = reference_values_of(measured, shell, options);
        EXPECT_TRUE(quick.resolved);
        EXPECT_NEAR(quick.kept.ses_volume, full.kept.ses_volume, 1e-6);
        EXPECT_NEAR(quick.kept.ses_area, full.kept.ses_area, 1e-6);
        EXPECT_GE(count(quick, true), count(full, true));
        EXPECT_GE(count(quick, false), count(full, false));
        for (const DeepPoint& point : quick.points) EXPECT_GT(point.radius, kResolved * spacing);
    }
}

TEST(ReferenceValues, KnowsWhatTheMeshKeeps) {
    const Atoms shell = hollow_shell(60, 5.2, 1.7);
    const AccessibleSurface accessible(shell, 1.4);
    const Measures measured = measure(shell);
    const SurfaceComponent& cavity = measured.components.at(1);
    const auto volume = [&](const SurfaceOptions& options) {
        return find_reference_values(accessible, shell, options).kept.ses_volume;
    };
    const double outer = measured.components.at(0).ses_volume;
    EXPECT_NEAR(volume({.pieces = Pieces::Outer}), outer, 1e-6);
    EXPECT_NEAR(volume({.pieces = Pieces::Cavities}), -cavity.ses_volume, 1e-6);
    EXPECT_NEAR(volume({.min_cavity = 1.5 * cavity.ses_volume}), outer, 1e-6);
    EXPECT_NEAR(volume({.fill_cavities = 1.5 * cavity.ses_volume}), outer, 1e-6);
}

TEST(ReferenceValues, AllowsForWhatIsNotResolvedOrMayChangeSides) {
    const Atoms shell = hollow_shell(60, 5.2, 1.7);
    const Measures measured = measure(shell);
    const SurfaceComponent& cavity = measured.components.at(1);
    EXPECT_EQ(reference_values_of(measured, shell, {}).doubtful, 0.0);
    EXPECT_DOUBLE_EQ(reference_values_of(measured, shell, {.pieces = Pieces::Cavities}).doubtful, cavity.ses_volume);
    EXPECT_DOUBLE_EQ(reference_values_of(measured, shell, {.min_cavity = 3.0}).doubtful, cavity.ses_volume);
    const ReferenceValues coarse = reference_values_of(measured, shell, {.spacing = cavity.inscribed_radius});
    EXPECT_GE(coarse.doubtful, cavity.ses_volume);
}

TEST(ReferenceValues, ScatteredPointsAreOnBothSides) {
    const Atoms shell = hollow_shell(60, 5.2, 1.7);
    const std::vector<DeepPoint> points = scattered_points(AccessibleSurface(shell, 1.4), {});
    const auto inside = std::count_if(points.begin(), points.end(), [](const DeepPoint& p) { return p.inside; });
    EXPECT_GT(inside, 1000);
    EXPECT_GT(static_cast<std::ptrdiff_t>(points.size()) - inside, 1000);
}

}  // namespace
}  // namespace meniscus::testing
