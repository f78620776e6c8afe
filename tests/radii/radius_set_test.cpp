// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "radii/radius_set.h"

#include <gtest/gtest.h>

#include <array>

namespace meniscus {
namespace {

TEST(RadiusRule, MatchesNamesPrefixesAndElements) {
    const AtomType type{"ASP", "OD1", "O"};
    EXPECT_TRUE(matches({"ASP", "OD1", 1.0}, type));
    EXPECT_TRUE(matches({"GLU,ASP", "OE1,OD*", 1.0}, type));
    EXPECT_TRUE(matches({"*", "@O", 1.0}, type));
    EXPECT_TRUE(matches({"*", "OD*@O", 1.0}, type));
    EXPECT_TRUE(matches({"*", "*", 1.0}, type));
    EXPECT_FALSE(matches({"ASN", "OD1", 1.0}, type));
    EXPECT_FALSE(matches({"ASP", "OD2,OE*", 1.0}, type));
    EXPECT_FALSE(matches({"ASP", "OD1@N", 1.0}, type));
    EXPECT_FALSE(matches({"NTERM", "OD1", 1.0}, type));
}

TEST(RadiusRule, ElementTellsCalciumFromAlphaCarbon) {
    EXPECT_TRUE(matches({"*", "CA@C", 1.0}, {"GLY", "CA", "C"}));
    EXPECT_FALSE(matches({"*", "CA@C", 1.0}, {"CA", "CA", "CA"}));
}

TEST(RadiusSet, FindsTheBuiltInSetsOnly) {
    for (const char* name : {"bondi", "united", "protor", "naccess", "parse"}) {
        ASSERT_TRUE(find_radius_set(name).has_value()) << name;
        EXPECT_EQ(find_radius_set(name)->name, name);
        EXPECT_NE(radius_set_names().find(name), std::string::npos);
    }
    EXPECT_FALSE(find_radius_set("auto").has_value());
    EXPECT_FALSE(find_radius_set("Bondi").has_value());
}

TEST(RadiusSet, UnitedSetsStandForHydrogens) {
    EXPECT_TRUE(find_radius_set("united")->united);
    EXPECT_TRUE(find_radius_set("protor")->united);
    EXPECT_TRUE(find_radius_set("naccess")->united);
    EXPECT_FALSE(find_radius_set("bondi")->united);
    EXPECT_FALSE(find_radius_set("parse")->united);
}

TEST(RadiusTyper, FirstRuleWinsUnderOwnOrCanonicalNames) {
    static constexpr auto kRules = std::to_array<RadiusRule>({
        {"HID", "ND1", 1.0},
        {"HIS", "ND1", 2.0},
        {"*", "@N", 3.0},
    });
    RadiusTyper typer(RadiusSet{"test", false, kRules, nullptr});
    EXPECT_EQ(typer.find({"HID", "ND1", "N"}), 1.0);
    EXPECT_EQ(typer.find({"HIE", "ND1", "N"}), 2.0);
    EXPECT_EQ(typer.find({"HIS", "NE2", "N"}), 3.0);
    EXPECT_EQ(typer.find({"HIS", "CE1", "C"}), std::nullopt);
    EXPECT_EQ(typer.find({"HIS", "CE1", "C"}), std::nullopt) << "also when asked again";
}

}  // namespace
}  // namespace meniscus
