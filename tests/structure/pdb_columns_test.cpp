// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pdb_columns.h"

#include "fragments.h"

namespace meniscus::reading {
namespace {

using meniscus::testing::expect_contains;

//                               1         2         3         4         5         6         7         8
//                      12345678901234567890123456789012345678901234567890123456789012345678901234567890
const std::string kInPlace = "ATOM      7  CA  ALA A  12      11.104   6.134  -6.504  1.00  8.20           C  ";

std::string fault_of(const std::string& line) {
    if (has_usual_columns(line)) return "";
    const auto found = find_column_fault(line);
    return found ? std::to_string(found->column) + ": " + found->message : "";
}

// The line with the coordinates' columns, and what is behind them, replaced.
std::string with_coordinates(const std::string& text) { return kInPlace.substr(0, 30) + text; }

std::string put_before(std::size_t column, const std::string& text, std::string line = kInPlace) {
    return line.insert(column - 1, text);
}

TEST(PdbColumns, UsualLinesAndOtherNumbersOfDecimalsAreInPlace) {
    for (const char* coordinates :
         {"  11.104   6.134  -6.504", "1111.1041116.134-116.504  1.00", "   11.10    6.13   -6.50  1.00  8.20",
          " 11.1040  6.1340 -6.5040  1.00", "    11.1     6.1    -6.5", "      11       6      -6",
          "11.104  6.134   -6.504  ", "12.104  16.134  66.504    1.00", "11.5    6.25    -6.504    1.00  8.20",
          "       0     1.5   -2.25", "    1e-3      .5     -5.", "   11.10 -106.13-1116.50"}) {
        EXPECT_EQ(fault_of(with_coordinates(coordinates)), "") << coordinates;
    }
}

TEST(PdbColumns, WhatFollowsCoordinatesToTheLeftMustBeInPlace) {
    std::string line = kInPlace;
    expect_contains(fault_of(line.erase(30, 1)), "31: columns are shifted by 1 to the left");
    expect_contains(fault_of(line.erase(30, 1)), "31: columns are shifted by 2 to the left");
}

TEST(PdbColumns, ShiftedLinesSayByHowManyAndFromWhere) {
    const auto says = [](const std::string& line, const std::string& what) { expect_contains(fault_of(line), what); };
    says(put_before(23, "1"), "22: columns are shifted by 1 to the right from the chain name 'A1' on");
    says(put_before(7, "9999"), "columns are shifted by 4 to the right");
    says("ATOM  1000007  CA  ALA A  12      11.104   6.134  -6.504",
         "7: columns are shifted by 2 to the right from the serial number '1000007' on");
    says("HETATM100007  CA  LIG A  12      11.104   6.134  -6.504",
         "1: columns are shifted by 1 to the right from the serial number 'HETATM100007' on");
    says("ATOM      7 HO5'1 ALA A  12      11.104   6.134  -6.504",
         "13: columns are shifted by 1 to the right from the atom name 'HO5'1' on");
    says("ATOM      7  CA  LIG01 A  12      11.104   6.134  -6.504",
         "18: columns are shifted by 2 to the right from the residue name 'LIG01' on");
    says("ATOM      7  CA  ALA A10012      11.104   6.134  -6.504",
         "22: columns are shifted by 1 to the right from the chain and residue number 'A10012' on");
    says(with_coordinates("-1111.104   6.134  -6.504"),
         "31: columns are shifted by 1 to the right from the x coordinate");
    says(with_coordinates("  11.104-1116.134  -6.504"),
         "39: columns are shifted by 1 to the right from the y coordinate");
    says(with_coordinates("  11.104   6.134-1116.504"),
         "47: columns are shifted by 1 to the right from the z coordinate");
    says("ATOM     7  CA  ALA A  12      11.104   6.134  -6.504 ", "columns are shifted by 1 to the left");
}

// Whatever number of columns is put in or taken out in front of x, no line is read as if nothing were wrong.
TEST(PdbColumns, NoShiftGoesUnseen) {
    for (const char* coordinates : {"  11.104   6.134  -6.504  1.00  8.20", "-111.104-116.134-996.504  1.00  8.20",
                                    "   1.000   2.000   3.000  1.00  0.00", "1111.1041116.1341116.504100.00  8.20"}) {
        const std::string line = with_coordinates(coordinates);
        for (std::size_t n = 1; n <= 12; ++n) {
            EXPECT_NE(fault_of(put_before(12, std::string(n, ' '), line)), "") << n << coordinates;
            EXPECT_NE(fault_of(line.substr(0, 6) + line.substr(6 + n)), "") << n << coordinates;
        }
    }
}

TEST(PdbColumns, NumbersAcrossTwoFieldsAreNotCutInTwo) {
    expect_contains(fault_of(kInPlace.substr(0, 29) + "-1111.104   6.134  -6.504"),
                    "31: a number runs across columns 30 and 31");
    expect_contains(fault_of(with_coordinates("12345.6712345.6712345.67")),
                    "39: a number runs across columns 38 and 39");
    expect_contains(fault_of(with_coordinates("  38.9032355.6020100.6482  1.00")),
                    "31: columns are shifted by 1 to the right from the x coordinate on");
    EXPECT_EQ(fault_of(with_coordinates("1111.1041116.1341116.504100.00")), "");
    expect_contains(fault_of(with_coordinates("  12    11.104   6.134  1.00")),
                    "31: the numbers in the columns of x, y and z are not aligned alike");
    expect_contains(fault_of("ATOM  \t7\tCA\tALA\tA\t12\t11.104\t6.134\t-6.504\t1.00\t8.20\tC"), "7: a tab");
    expect_contains(fault_of("ATOM 7 CA ALA A 12 11.104 6.134 -6.504 1.00"), "has its words between blanks");
}

TEST(PdbColumns, CoordinatesAreSeenWhereverTheyStand) {
    EXPECT_TRUE(has_coordinates(kInPlace));
    EXPECT_TRUE(has_coordinates("#" + kInPlace));
    EXPECT_TRUE(has_coordinates("ATM 7 CA 1.5 2.25 -3."));
    EXPECT_TRUE(has_coordinates("xx              1111.1041116.134-116.504"));
    EXPECT_FALSE(has_coordinates("CONECT    1    2    3    4"));
    EXPECT_FALSE(has_coordinates("Resolution 1.80 and 2.5"));
    EXPECT_FALSE(has_coordinates(""));
}

}  // namespace
}  // namespace meniscus::reading
