// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/file_words.h"

#include <gtest/gtest.h>

#include <set>

namespace meniscus {
namespace {

template <class T, std::size_t N>
void expect_one_word_per_value(const Words<T, N>& words) {
    std::set<std::string> texts;
    for (const auto& [word, value] : words) {
        EXPECT_TRUE(texts.insert(word).second) << word;
        EXPECT_STREQ(word_for(words, value), word);
        EXPECT_EQ(parse_word("--option", word, words), value);
    }
}

TEST(Words, EveryValueHasOneWord) {
    expect_one_word_per_value(kHydrogenWords);
    expect_one_word_per_value(kHeteroWords);
    expect_one_word_per_value(kMethodWords);
    expect_one_word_per_value(kPiecesWords);
    expect_one_word_per_value(kCornersWords);
    expect_one_word_per_value(kCurvatureWords);
    expect_one_word_per_value(kReinitialiserWords);
    expect_one_word_per_value(kSolverWords);
    expect_one_word_per_value(kSlopeWords);
    expect_one_word_per_value(kFlowEndWords);
    expect_one_word_per_value(kRowsPerWords);
    expect_one_word_per_value(kAtomValueWords);
    expect_one_word_per_value(kColourSchemeWords);
}

TEST(Words, AnUnknownWordIsToldWithThoseThatAreKnown) {
    try {
        parse_word("--slope", "steep", kSlopeWords);
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_STREQ(error.what(), "--slope: unknown value 'steep'; choose one of unit, computed");
    }
}

}  // namespace
}  // namespace meniscus
