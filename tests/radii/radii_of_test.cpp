// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/radii.h"

#include <gtest/gtest.h>

#include "meniscus/errors.h"

namespace meniscus::testing {
namespace {

std::vector<double> radii(const std::vector<AtomNames>& atoms, const std::string& set) { return radii_of(atoms, set); }

TEST(RadiiOf, TakeElementsAlone) {
    EXPECT_EQ(radii({{"", "", "C"}, {"", "", "o"}, {"", "", "Fe"}, {"", "", " H "}}, "bondi"),
              (std::vector<double>{1.70, 1.52, 2.44, 1.20}));
}

TEST(RadiiOf, TellUnitedAtomsByTheirNames) {
    const std::vector<double> united = radii({{"ALA", "CA", "C"}, {"ala", "cb", "c"}, {"ALA", "O", "O"}}, "united");
    EXPECT_GT(united[1], united[0] - 1e-9);
    EXPECT_NE(united[0], united[2]);
}

TEST(RadiiOf, AreZeroForHydrogensThatUnitedAtomsStandFor) {
    EXPECT_EQ(radii({{"ALA", "HA", "H"}, {"ALA", "DA", "D"}}, "protor"), (std::vector<double>{0.0, 0.0}));
}

TEST(RadiiOf, FallBackToTheElementOfAnUnknownAtom) {
    EXPECT_EQ(radii({{"XYZ", "C99", "C"}}, "protor"), (std::vector<double>{1.70}));
}

TEST(RadiiOf, RefuseWhatNothingIsKnownOf) {
    EXPECT_THROW(radii({{"XYZ", "Q1", ""}}, "protor"), UsageError);
    EXPECT_THROW(radii({{"", "", "C"}}, "no such set"), UsageError);
}

}  // namespace
}  // namespace meniscus::testing
