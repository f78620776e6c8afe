// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "radii/element_radii.h"

#include <gtest/gtest.h>

namespace meniscus {
namespace {

TEST(ElementRadii, BondiComesBeforeAlvarez) {
    EXPECT_EQ(element_radius("C")->radius, 1.70);
    EXPECT_EQ(element_radius("C")->source, RadiusSource::Bondi1964);
    EXPECT_EQ(element_radius("FE")->radius, 2.44);
    EXPECT_EQ(element_radius("FE")->source, RadiusSource::Alvarez2013);
}

TEST(ElementRadii, WhatIsNoElementHasNoRadius) {
    EXPECT_FALSE(element_radius("X").has_value());
    EXPECT_FALSE(element_radius("").has_value());
    EXPECT_FALSE(element_radius("c").has_value());
    EXPECT_FALSE(is_element("CX"));
}

TEST(ElementRadii, ElementsWithoutRadiusAreElements) {
    EXPECT_TRUE(is_element("PO"));
    EXPECT_FALSE(element_radius("PO").has_value());
    EXPECT_TRUE(is_element("D"));
}

}  // namespace
}  // namespace meniscus
