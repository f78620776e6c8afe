// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "tables/tien_maxima.h"

#include <gtest/gtest.h>

#include <string>

namespace meniscus {
namespace {

TEST(TienMaxima, AreThoseOfTheSource) {
    EXPECT_EQ(tien_maximum("ALA"), 129.0);
    EXPECT_EQ(tien_maximum("GLY"), 104.0);
    EXPECT_EQ(tien_maximum("TRP"), 285.0);
    EXPECT_EQ(tien_maximum("VAL"), 174.0);
}

TEST(TienMaxima, CoverTheTwentyAminoAcidsAndNothingElse) {
    double sum = 0.0;
    for (const char* name : {"ALA", "ARG", "ASN", "ASP", "CYS", "GLN", "GLU", "GLY", "HIS", "ILE",
                             "LEU", "LYS", "MET", "PHE", "PRO", "SER", "THR", "TRP", "TYR", "VAL"})
        sum += tien_maximum(name).value();
    EXPECT_EQ(sum, 4040.0);
    for (const char* name : {"MSE", "HOH", "DA", "", "ala"}) EXPECT_FALSE(tien_maximum(name)) << name;
}

}  // namespace
}  // namespace meniscus
