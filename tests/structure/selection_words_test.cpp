// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/selection_words.h"

#include <gtest/gtest.h>

#include "meniscus/errors.h"

namespace meniscus::reading {
namespace {

std::string translated(const std::string& expression) {
    EXPECT_TRUE(is_in_words(expression)) << expression;
    return in_gemmi_syntax(expression, "--select");
}

std::string refusal(const std::string& expression) {
    EXPECT_TRUE(is_in_words(expression)) << expression;
    try {
        return "understood as " + in_gemmi_syntax(expression, "--select");
    } catch (const UsageError& error) {
        return error.what();
    }
}

void expect_refused(const std::string& expression, const std::string& part) {
    EXPECT_NE(refusal(expression).find(part), std::string::npos) << refusal(expression);
}

TEST(SelectionWords, OfPyMolAreTranslated) {
    EXPECT_EQ(translated("chain A"), "//A");
    EXPECT_EQ(translated("chain A+B"), "//A,B");
    EXPECT_EQ(translated("resn HEM"), "//*/(HEM)");
    EXPECT_EQ(translated("resi 10-50"), "//*/10-50.Z");
    EXPECT_EQ(translated("resi 60"), "//*/60-60");
    EXPECT_EQ(translated("name CA"), "//*/*/CA");
    EXPECT_EQ(translated("chain A and resi 10-50"), "//A/10-50.Z");
    EXPECT_EQ(translated("c. A & i. 10-50 & n. CA+CB"), "//A/10-50.Z/CA,CB");
    EXPECT_EQ(translated("resn ALA AND resi 1-9"), "//*/1(ALA)-9.Z");
    EXPECT_EQ(translated("elem FE"), "//*/*/[FE]");
    EXPECT_EQ(translated("chain A and alt B"), "//A/*/:B");
    EXPECT_EQ(translated("b > 50"), ";b>50");
    EXPECT_EQ(translated("chain A and q<0.5"), "//A;q<0.5");
    EXPECT_EQ(translated("solvent"), ";solvent");
    EXPECT_EQ(translated("polymer and chain A"), "//A;polymer");
    EXPECT_EQ(translated("all"), "*");
    EXPECT_EQ(translated("(chain L)"), "//L");
    EXPECT_EQ(translated("chain 'L' and symbol C"), "//L/*/[C]");
    EXPECT_EQ(translated("chain \"L\""), "//L");
}

// PyMOL takes 82, 82A and 82B as parts of 80-82, but 82 alone as this residue only.
TEST(SelectionWords, RangesHaveTheInsertionCodesOfTheirLastNumber) {
    EXPECT_EQ(translated("chain H and resi 80-82"), "//H/80-82.Z");
    EXPECT_EQ(translated("chain H and resi 82"), "//H/82-82");
    EXPECT_EQ(translated("chain H and resi 82A"), "//H/82.A-82.A");
    expect_refused("resi 82A-82C", "//A/10.A-50.C");
}

TEST(SelectionWords, OfVmdAreTranslated) {
    EXPECT_EQ(translated("chain A B"), "//A,B");
    EXPECT_EQ(translated("resname HEM and name FE"), "//*/(HEM)/FE");
    EXPECT_EQ(translated("resid 10 to 50"), "//*/10-50.Z");
    EXPECT_EQ(translated("water"), ";solvent");
    EXPECT_EQ(translated("beta > 50 and chain A"), "//A;b>50");
}

TEST(SelectionWords, WhatIsNotExactIsRefusedWithTheRightForm) {
    expect_refused("chain A or chain B", "'or' has no exact counterpart");
    expect_refused("chain A or chain B", "//A,B");
    expect_refused("not resn HOH", "(!HEM)");
    expect_refused("protein", "kept without any selection");
    expect_refused("backbone", "N,CA,C,O");
    expect_refused("resi 10-50+60", "one range");
    expect_refused("resi 10+20+30", "several ranges or residues");
    expect_refused("resid 10 20 30", "one range");
    expect_refused("resi -5-10", "no negative residue numbers");
    expect_refused("resn H*", "not a list of names");
    expect_refused("chain A and chain B", "twice");
    expect_refused("chain A and", "nothing follows");
    expect_refused("chain", "is not a condition");
    expect_refused("//A and resi 10", "is not a condition");
    expect_refused("hetatm", "(HEM,NAG)");
    expect_refused("chain A resi 2", "'and' is missing before 'resi'");
    expect_refused("chain A polymer", "'and' is missing before 'polymer'");
    for (const char* text : {"b < 1,0", "b > 10 20", "b >= 10", "b 10", "q = x"})
        expect_refused(text, "compared with one number");
    expect_refused("chain ''", "an empty name");
    expect_refused("chain A-2", "by the option 'chains', as in A-2");
    expect_refused("resi -2", "no negative residue numbers");
    expect_refused("resi 4294967298", "larger than a residue number may be");
    expect_refused("resi 2-4294967299", "larger than a residue number may be");
    expect_refused("id 5", "'id' is not a condition");
    expect_refused("ligand", "(HEM,NAG)");
    expect_refused("within 5 of chain A", "no exact counterpart");
}

TEST(SelectionWords, SelectionsOfGemmiAreNone) {
    for (const char* expression : {"A", "CA", "//A/10-50", "(HEM)", ";q>0.5", "; b > 50", "A,B", "b", "N,CA", "", "!A",
                                   "//A;b>50", "//A ;b > 50"})
        EXPECT_FALSE(is_in_words(expression)) << expression;
}

}  // namespace
}  // namespace meniscus::reading
