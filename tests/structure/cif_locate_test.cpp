// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/cif_locate.h"

#include <gtest/gtest.h>

namespace meniscus::reading {
namespace {

void expect_place(std::string_view text, std::string_view tag, std::size_t row, std::size_t line, std::size_t column) {
    const Place place = locate_cif_value(text, tag, row);
    EXPECT_EQ(place.line, line) << tag << " " << row;
    EXPECT_EQ(place.column, column) << tag << " " << row;
}

TEST(CifLocate, FindsValuesOfALoop) {
    const char* text = "data_x\nloop_\n_a.x\n_a.Y\n1 2\n3\n 4\n";
    expect_place(text, "_a.x", 0, 5, 1);
    expect_place(text, "_a.y", 0, 5, 3);
    expect_place(text, "_a.x", 1, 6, 1);
    expect_place(text, "_A.Y", 1, 7, 2);
}

TEST(CifLocate, FindsTheValueOfAPair) { expect_place("data_x\n_a.x 7\n_a.y   8\n", "_a.y", 0, 3, 8); }

TEST(CifLocate, QuotesCommentsAndTextFieldsAreOneValueOrNone) {
    const char* text =
        "data_x # loop_ _a.x\nloop_\n_b.x\n_a.x\n'it''s it' 1\n;_a.x\nloop_\n;\n2 \"a # b\" 3 # 9 9\nO5' 4\n";
    expect_place(text, "_a.x", 0, 5, 12);
    expect_place(text, "_a.x", 1, 9, 1);
    expect_place(text, "_a.x", 2, 9, 11);
    expect_place(text, "_a.x", 3, 10, 5);
}

TEST(CifLocate, ALoopEndsAtTheNextTag) {
    const char* text = "data_x\nloop_\n_a.x\n1\n_b.y 5\nloop_\n_c.z\n6\n";
    expect_place(text, "_b.y", 0, 5, 6);
    expect_place(text, "_c.z", 0, 8, 1);
}

TEST(CifLocate, WhatIsNotThereIsTheStart) { expect_place("data_x\n", "_a.x", 3, 1, 1); }

}  // namespace
}  // namespace meniscus::reading
