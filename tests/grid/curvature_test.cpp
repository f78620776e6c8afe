// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/curvature.h"

#include <gtest/gtest.h>

#include <limits>

namespace meniscus::testing {
namespace {

constexpr double kTooLarge = std::numeric_limits<double>::infinity();
constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

TEST(Curvature, ShapeIndexNamesTheShapes) {
    EXPECT_EQ((PrincipalCurvatures{0.5, 0.5}.shape_index()), 1.0);
    EXPECT_DOUBLE_EQ((PrincipalCurvatures{0.5, 0.0}.shape_index()), 0.5);
    EXPECT_EQ((PrincipalCurvatures{0.5, -0.5}.shape_index()), 0.0);
    EXPECT_DOUBLE_EQ((PrincipalCurvatures{0.0, -0.5}.shape_index()), -0.5);
    EXPECT_EQ((PrincipalCurvatures{-0.5, -0.5}.shape_index()), -1.0);
    EXPECT_EQ((PrincipalCurvatures{0.0, 0.0}.shape_index()), 0.0) << "a plane has none";
}

TEST(Curvature, PrincipalOnesGiveMeanAndGaussianBack) {
    for (const PrincipalCurvatures k :
         {PrincipalCurvatures{2.0, 0.25}, PrincipalCurvatures{0.5, -3.0}, PrincipalCurvatures{-0.1, -0.7}}) {
        const PrincipalCurvatures again = principal_curvatures(k.mean(), k.gaussian());
        EXPECT_NEAR(again.largest, k.largest, 1e-15);
        EXPECT_NEAR(again.smallest, k.smallest, 1e-15);
    }
}

TEST(Curvature, RoundingPastASphereGivesASphere) {
    const PrincipalCurvatures k = principal_curvatures(0.5, 0.25 * (1.0 + 1e-12));
    EXPECT_EQ(k.largest, k.smallest);
    EXPECT_EQ(k.shape_index(), 1.0);
}

TEST(Curvature, CuspsAreCapped) {
    const PrincipalCurvatures waist = principal_curvatures(kTooLarge, -kTooLarge).capped(4.0);
    EXPECT_EQ(waist.largest, 4.0);
    EXPECT_EQ(waist.smallest, 0.0);
    const PrincipalCurvatures cup = principal_curvatures(-kTooLarge, kTooLarge).capped(4.0);
    EXPECT_EQ(cup.mean(), -4.0);
    EXPECT_EQ(cup.gaussian(), 16.0);
    EXPECT_EQ(principal_curvatures(kUndefined, 1.0).capped(4.0).mean(), 0.0);
    const PrincipalCurvatures sharp = PrincipalCurvatures{100.0, -0.5}.capped(4.0);
    EXPECT_EQ(sharp.largest, 4.0);
    EXPECT_EQ(sharp.smallest, -0.5);
}

}  // namespace
}  // namespace meniscus::testing
