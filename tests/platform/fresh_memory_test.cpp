// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "platform/fresh_memory.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <span>
#include <vector>

namespace meniscus::testing {
namespace {

constexpr std::byte kMark{0xAB};

TEST(FreshMemory, WhatAVectorHoldsStays) {
    std::vector<int> numbers(1000);
    std::iota(numbers.begin(), numbers.end(), 0);
    const std::vector<int> before = numbers;
    reserve_touched(numbers, 3'000'000);
    EXPECT_GE(numbers.capacity(), 3'000'000U);
    EXPECT_EQ(numbers, before);
    resize_touched(numbers, 2'000'000);
    ASSERT_EQ(numbers.size(), 2'000'000U);
    EXPECT_TRUE(std::equal(before.begin(), before.end(), numbers.begin()));
    EXPECT_EQ(std::count(numbers.begin() + 1000, numbers.end(), 0), 1'999'000);
}

TEST(FreshMemory, OnlyALikelyPartOfTheRoomIsTouched) {
    for (const std::size_t likely : {std::size_t{0}, std::size_t{500}, std::size_t{50'000}, std::size_t{10'000'000}}) {
        std::vector<int> numbers(1000, 7);
        reserve_touched(numbers, 100'000, likely);
        EXPECT_GE(numbers.capacity(), 100'000U);
        EXPECT_EQ(std::count(numbers.begin(), numbers.end(), 7), 1000);
    }
}

TEST(FreshMemory, AFewMoreMoveNothing) {
    std::vector<int> a;
    std::vector<double> b{1.0};
    resize_all_touched(100'000, a, b);
    EXPECT_EQ(std::count(a.begin(), a.end(), 0), 100'000);
    EXPECT_EQ(b.front(), 1.0);
    const int* const place = a.data();
    const double* const other = b.data();
    a.resize(100'150, 7);
    std::vector<int> c;
    resize_touched(c, 5000);
    EXPECT_GE(c.capacity(), with_spare(5000));
    for (int i = 0; i < 150; ++i) b.push_back(2.0);
    EXPECT_EQ(a.data(), place);
    EXPECT_EQ(b.data(), other);
}

TEST(FreshMemory, NothingBesideItIsWritten) {
    std::vector<std::byte> memory(std::size_t{5} << 20U, kMark);
    const auto is_marked = [](std::byte b) { return b == kMark; };
    for (const std::size_t begin : {0U, 1U, 4095U, 100'000U})
        for (const std::size_t size : {0U, 1U, 4096U, 8191U, 12'345U, 4'500'000U}) {
            touch_pages(memory.data() + begin, size);
            const std::span all(memory);
            EXPECT_TRUE(std::ranges::all_of(all.first(begin), is_marked));
            EXPECT_TRUE(std::ranges::all_of(all.subspan(begin + size), is_marked));
            std::fill(memory.begin(), memory.end(), kMark);
        }
}

TEST(FreshMemory, SeveralArraysAtOnce) {
    std::vector<double> a;
    std::vector<char> b(3, 'x');
    resize_all_touched(100'000, a, b);
    EXPECT_EQ(a.size(), 100'000U);
    EXPECT_EQ(b.size(), 100'000U);
    EXPECT_EQ(std::count(b.begin(), b.end(), 'x'), 3);
}

}  // namespace
}  // namespace meniscus::testing
