// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "radii/rule_file.h"

#include <gtest/gtest.h>

#include "meniscus/errors.h"

namespace meniscus {
namespace {

std::string error_of(std::string_view text) {
    try {
        parse_radius_rules(text, "my.radii");
    } catch (const InputError& error) {
        return error.what();
    }
    return "no error";
}

TEST(RuleFile, ReadsRulesInOrderWithoutRegardToCase) {
    RadiusTyper typer(parse_radius_rules("# mine\nasp  od*  1.45\r\n\n* @c 1.7 # carbon\n* * 1.6", "my.radii"));
    EXPECT_EQ(typer.set().name, "my.radii");
    EXPECT_FALSE(typer.set().united);
    EXPECT_EQ(typer.find({"ASP", "OD2", "O"}), 1.45);
    EXPECT_EQ(typer.find({"ASP", "CB", "C"}), 1.7);
    EXPECT_EQ(typer.find({"ASP", "N", "N"}), 1.6);
}

TEST(RuleFile, MayDropHydrogens) {
    EXPECT_TRUE(parse_radius_rules("hydrogens drop\n* * 1.6\n", "f").united);
    EXPECT_FALSE(parse_radius_rules("hydrogens keep\n* * 1.6\n", "f").united);
}

TEST(RuleFile, ZeroRadiusIsAllowed) {
    RadiusTyper typer(parse_radius_rules("* @H 0\n", "f"));
    EXPECT_EQ(typer.find({"ALA", "HA", "H"}), 0.0);
}

TEST(RuleFile, ErrorsNameTheirPlace) {
    EXPECT_TRUE(error_of("* @C 1.7\nASP OD* big\n").starts_with("my.radii:2:9: the radius 'BIG' is not a number"));
    EXPECT_TRUE(error_of("* @C 1\xff\n").starts_with("my.radii:1:6: the radius '1?' is not a number"));
    EXPECT_TRUE(error_of("ASP OD* -1\n").starts_with("my.radii:1:9: the radius '-1' is negative"));
    EXPECT_TRUE(error_of("ASP OD* nan\n").starts_with("my.radii:1:9: "));
    EXPECT_TRUE(error_of("ASP OD* 1.4 1.5\n").starts_with("my.radii:1:13: '1.5' is unexpected"));
    EXPECT_TRUE(error_of("ASP OD*\n").starts_with("my.radii:1:8: the radius is missing"));
    EXPECT_TRUE(error_of("ASP\n").starts_with("my.radii:1:4: the atom is missing"));
    EXPECT_TRUE(error_of("hydrogens maybe\n").starts_with("my.radii:1:11: 'hydrogens' must"));
    EXPECT_TRUE(error_of("# nothing\n").starts_with("my.radii: no rules"));
}

TEST(RuleFile, FoldersAndMissingFilesAreErrors) {
    EXPECT_THROW(read_radius_rules("/"), InputError);
    EXPECT_THROW(read_radius_rules("/no/such/file"), InputError);
}

}  // namespace
}  // namespace meniscus
