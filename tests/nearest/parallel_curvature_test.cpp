// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "nearest/parallel_curvature.h"

#include <gtest/gtest.h>

#include <cmath>

namespace meniscus::testing {
namespace {

TEST(ParallelCurvature, OfSpheresIsTheInverseRadiusWithItsSign) {
    EXPECT_EQ(contact_curvature(2.0), 0.5);
    EXPECT_EQ(reentrant_curvature(2.0), -0.5);
    EXPECT_EQ(contact_gaussian_curvature(2.0), 0.25);
    EXPECT_EQ(reentrant_gaussian_curvature(2.0), 0.25);
}

TEST(ParallelCurvature, OfATorusIsThatOfItsPrincipalRadii) {
    const double a = 3.0;                                                                  // circle
    const double d = 1.4;                                                                  // tube
    EXPECT_NEAR(toroidal_curvature(a, a - d, d), 0.5 * (1.0 / (a - d) - 1.0 / d), 1e-15);  // at the waist
    for (const double angle : {0.3, 0.9, 1.4}) {
        const double from_axis = a - d * std::cos(angle);
        EXPECT_NEAR(toroidal_curvature(a, from_axis, d), 0.5 * (std::cos(angle) / from_axis - 1.0 / d), 1e-15);
        EXPECT_NEAR(toroidal_gaussian_curvature(a, from_axis, d), -std::cos(angle) / (from_axis * d), 1e-15);
    }
}

TEST(ParallelCurvature, OnTheTopOfATorusOnlyTheTubeIsCurved) {
    EXPECT_NEAR(toroidal_curvature(3.0, 3.0, 1.4), -0.5 / 1.4, 1e-15);
    EXPECT_EQ(toroidal_gaussian_curvature(3.0, 3.0, 1.4), 0.0);
}

TEST(ParallelCurvature, MeanAndGaussianHaveTheSamePrincipalCurvatures) {
    for (const double from_axis : {0.5, 2.0, 3.5}) {
        const double d = 1.6;
        const double across = -1.0 / d;
        const double along = 2.0 * toroidal_curvature(2.5, from_axis, d) - across;
        EXPECT_NEAR(toroidal_gaussian_curvature(2.5, from_axis, d), along * across, 1e-15);
    }
}

}  // namespace
}  // namespace meniscus::testing
