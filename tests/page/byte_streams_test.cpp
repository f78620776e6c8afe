// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "page/byte_streams.h"

#include <gtest/gtest.h>

#include <limits>

#include "page/decoding.h"

namespace meniscus::page {
namespace {

TEST(ByteStreams, VarintsReadBack) {
    const std::vector<std::uint64_t> values{0,   1,     127,   128,
                                            300, 16383, 16384, std::numeric_limits<std::uint64_t>::max()};
    std::string bytes;
    for (const std::uint64_t value : values) append_varint(bytes, value);
    EXPECT_EQ(testing::varints(bytes), values);
}

TEST(ByteStreams, SmallNumbersOfEitherSignTakeOneByte) {
    for (const std::int64_t value : {-64, -1, 0, 1, 63}) EXPECT_LT(zigzag(value), 128U) << value;
}

TEST(ByteStreams, DifferencesReadBack) {
    const std::vector<std::int64_t> values{5, -7, 1000000, 1000000, -2000000000};
    EXPECT_EQ(testing::sums(differences(values)), values);
}

TEST(ByteStreams, DifferencesOfUnsignedNumbersMayFall) {
    EXPECT_EQ(testing::sums(differences(std::vector<std::uint32_t>{9, 2, 4000000000U})),
              (std::vector<std::int64_t>{9, 2, 4000000000LL}));
}

TEST(ByteStreams, ByteDifferencesWrapAround) {
    EXPECT_EQ(byte_differences(std::vector<std::uint8_t>{250, 4, 3}), (std::string{"\xFA\x0A\xFF"}));
}

TEST(ByteStreams, StreamsKnowTheirPlaces) {
    Streams streams;
    streams.add("a", "xyz");
    streams.add("b", "");
    streams.add("c", "12");
    ASSERT_EQ(streams.places().size(), 3U);
    EXPECT_EQ(streams.places()[2].offset, 3U);
    EXPECT_EQ(streams.places()[2].size, 2U);
    EXPECT_EQ(streams.bytes(), "xyz12");
}

}  // namespace
}  // namespace meniscus::page
