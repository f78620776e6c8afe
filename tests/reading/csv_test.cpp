// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "reading/csv.h"

#include <gtest/gtest.h>

namespace meniscus::reading {
namespace {

std::vector<std::vector<std::string>> texts(std::string_view text) {
    std::vector<std::vector<std::string>> all;
    for (const CsvRow& row : read_csv(text, "t.csv")) {
        all.emplace_back();
        for (const CsvCell& cell : row) all.back().push_back(cell.text);
    }
    return all;
}

using Texts = std::vector<std::vector<std::string>>;

TEST(Csv, CellsAreSeparatedByCommasAndRowsByLines) {
    EXPECT_EQ(texts(""), Texts{});
    EXPECT_EQ(texts("a,b\n1,\n\n,2"), (Texts{{"a", "b"}, {"1", ""}, {"", "2"}}));
}

TEST(Csv, WhatStandsMostOftenInTheFirstLineSeparates) {
    EXPECT_EQ(texts("a;b;c (x, y)\n1;2;3\n"), (Texts{{"a", "b", "c (x, y)"}, {"1", "2", "3"}}));
    EXPECT_EQ(texts("a\t\"b,c,d\"\n1\t2\n"), (Texts{{"a", "b,c,d"}, {"1", "2"}}));
    EXPECT_EQ(texts("\na;b\n\"1;2\";0,5\n"), (Texts{{"a", "b"}, {"1;2", "0,5"}}));
    EXPECT_EQ(texts("a\tb c\n1\t2;3\n"), (Texts{{"a", "b c"}, {"1", "2;3"}}));
    EXPECT_EQ(texts("a,b;c\n1,2;3\n"), (Texts{{"a", "b;c"}, {"1", "2;3"}}));
}

TEST(Csv, QuotesHoldCommasQuotesAndLines) {
    EXPECT_EQ(texts("\"a,b\",\"say \"\"x\"\"\"\n\"two\nlines\",end\n"),
              (Texts{{"a,b", "say \"x\""}, {"two\nlines", "end"}}));
}

TEST(Csv, CellsKnowTheirPlace) {
    const auto rows = read_csv("a,\"b\nc\",d\nx,y\n", "t.csv");
    EXPECT_EQ(rows[0][2].place.line, 2U);
    EXPECT_EQ(rows[0][2].place.column, 4U);
    EXPECT_EQ(rows[1][1].place.line, 3U);
    EXPECT_EQ(rows[1][1].place.column, 3U);
}

TEST(Csv, QuotesThatDoNotEndAreRefused) {
    const auto message = [](std::string_view text) -> std::string {
        try {
            read_csv(text, "t.csv");
        } catch (const InputError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message("a,b\n1,\"2\n"), "t.csv:2:3: the quote is not closed");
    EXPECT_EQ(message("\"a\"b\n").substr(0, 10), "t.csv:1:4:");
}

}  // namespace
}  // namespace meniscus::reading
