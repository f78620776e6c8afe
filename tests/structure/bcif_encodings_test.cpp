// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/bcif_encodings.h"

#include "bcif_writer.h"
#include "fragments.h"

namespace meniscus::reading {
namespace {

using testing::Encoded;
using testing::expect_contains;
using testing::IntegerCoding;
using testing::Integers;
using testing::packed;

constexpr std::size_t kMany = 1000000;

BcifArray decoded(const Encoded& encoded, std::size_t at_most = kMany) {
    const std::string bytes = testing::packed_data(encoded);
    const BcifArray array = decode_bcif(unpack(bytes), at_most);
    EXPECT_FALSE(std::holds_alternative<BcifTexts>(array)) << "views of bytes that end here";
    return array;
}

std::string decode_error(const Encoded& encoded, std::size_t at_most = kMany) {
    const std::string bytes = testing::packed_data(encoded);
    try {
        decode_bcif(unpack(bytes), at_most);
    } catch (const DamagedData& damage) {
        return damage.what();
    }
    return "";
}

std::string packed_integer(std::int64_t number) { return packed(number); }

// An encoding with members that may be wrong, above plain 32-bit integers.
Encoded wrong(const Integers& values, const std::string& kind, std::vector<testing::PackedMember> members) {
    Encoded encoded = testing::encoded(values, IntegerCoding::Plain);
    members.push_back({"kind", packed(kind)});
    encoded.encodings.insert(encoded.encodings.begin(), testing::packed_map(members));
    return encoded;
}

TEST(BcifEncodings, IntegersComeBack) {
    const std::vector<Integers> cases{{},
                                      {0},
                                      {5, 5, 5, 5},
                                      {-1, -128, -129, 127, 128, 254, 255, 256, 300},
                                      {1, 2, 3, 4},
                                      {0, 255, 510, 65535, 65536, 70000},
                                      {-40000, 40000, -32768, 32767}};
    for (const Integers& values : cases) {
        for (int coding = 0; coding < 6; ++coding)
            EXPECT_EQ(std::get<BcifIntegers>(decoded(testing::encoded(values, static_cast<IntegerCoding>(coding)))),
                      values)
                << coding;
    }
}

TEST(BcifEncodings, TypesOfBytesAreLittleEndianWithTheirSigns) {
    const auto of_type = [](const std::string& bytes, std::int64_t type) {
        return decoded({bytes, {testing::packed_map({{"kind", packed("ByteArray")}, {"type", packed(type)}})}});
    };
    EXPECT_EQ(std::get<BcifIntegers>(of_type("\xff\x01", 1)), (Integers{-1, 1}));
    EXPECT_EQ(std::get<BcifIntegers>(of_type("\xfe\xff", 2)), (Integers{-2}));
    EXPECT_EQ(std::get<BcifIntegers>(of_type("\xff\x01", 4)), (Integers{255, 1}));
    EXPECT_EQ(std::get<BcifIntegers>(of_type("\xfe\xff", 5)), (Integers{65534}));
    EXPECT_EQ(std::get<BcifIntegers>(of_type("\xff\xff\xff\xff", 6)), (Integers{4294967295}));
}

// As near as the text "12.345" comes, which is why it is compared for equality.
TEST(BcifEncodings, DecimalsAreThoseOfTheText) {
    const std::vector<double> values{12.345, -0.001, 99.999, 0.1, 0.3};
    for (int coding = 0; coding < 6; ++coding) {
        const auto reals =
            std::get<BcifReals>(decoded(testing::fixed_point(values, 1000, static_cast<IntegerCoding>(coding))));
        EXPECT_EQ(reals.values, values);
    }
    EXPECT_TRUE(std::get<BcifReals>(decoded(testing::floats(values))).single);
    EXPECT_EQ(std::get<BcifReals>(decoded(testing::doubles(values))).values, values);
}

TEST(BcifEncodings, IntervalsReachBothEnds) {
    const auto reals = std::get<BcifReals>(decoded(testing::interval({1.0, 1.25, 3.0}, 1.0, 3.0, 9)));
    EXPECT_EQ(reals.values, (std::vector<double>{1.0, 1.25, 3.0}));
}

TEST(BcifEncodings, TextsComeBackAlsoOutsideOfAscii) {
    const std::vector<std::string> values{"CA", "", "O5'", "CA", "CA"};
    const std::string bytes = testing::packed_data(testing::texts(values, IntegerCoding::Runs));
    const auto texts = std::get<BcifTexts>(decode_bcif(unpack(bytes), kMany));
    EXPECT_EQ(std::vector<std::string>(texts.begin(), texts.end()), values);

    // Offsets count UTF-16: one for an umlaut, two for what has four bytes.
    const Encoded indices = testing::encoded({0, 1, 2, -1}, IntegerCoding::Plain);
    const Encoded offsets = testing::encoded({0, 2, 4, 5}, IntegerCoding::Plain);
    const Encoded umlauts{indices.bytes,
                          {testing::packed_map({{"kind", packed("StringArray")},
                                                {"dataEncoding", testing::packed_array(indices.encodings)},
                                                {"stringData", packed("\xc3\xa4"
                                                                      "b"
                                                                      "\xf0\x9f\x98\x80"
                                                                      "c")},
                                                {"offsetEncoding", testing::packed_array(offsets.encodings)},
                                                {"offsets", testing::packed_bytes(offsets.bytes)}})}};
    const std::string other = testing::packed_data(umlauts);
    const auto parts = std::get<BcifTexts>(decode_bcif(unpack(other), kMany));
    EXPECT_EQ(std::vector<std::string>(parts.begin(), parts.end()),
              (std::vector<std::string>{"\xc3\xa4"
                                        "b",
                                        "\xf0\x9f\x98\x80", "c", ""}));
}

TEST(BcifEncodings, SumsWrapAsThirtyTwoBitsDo) {
    const Encoded deltas = wrong({2147483647, 1}, "Delta", {{"origin", packed_integer(0)}});
    EXPECT_EQ(std::get<BcifIntegers>(decoded(deltas)), (Integers{2147483647, -2147483648LL}));
}

TEST(BcifEncodings, WhatDoesNotFitIsDamage) {
    const auto size = [](std::int64_t n) { return testing::PackedMember{"srcSize", packed_integer(n)}; };
    expect_contains(decode_error(wrong({1, 5}, "RunLength", {size(4)})), "longer than their sum");
    expect_contains(decode_error(wrong({1, -5}, "RunLength", {size(4)})), "longer than their sum");
    expect_contains(decode_error(wrong({1, 3}, "RunLength", {size(4)})), "shorter than their sum");
    expect_contains(decode_error(wrong({1}, "RunLength", {size(4)})), "without its length");
    expect_contains(decode_error(wrong({1, 2000000000}, "RunLength", {size(2000000000)})), "2000000000 values");
    expect_contains(decode_error(wrong({1, 1}, "RunLength", {})), "\"srcSize\" is missing");
    expect_contains(decode_error(wrong({1}, "FixedPoint", {{"factor", packed(0.0)}})), "is 0");
    expect_contains(decode_error(wrong({1}, "FixedPoint", {{"factor", packed("x")}})), "not a finite number");
    expect_contains(decode_error(wrong({1}, "Zip", {})), "'Zip' is unknown");
    expect_contains(decode_error(wrong({1}, "ByteArray", {})), "out of place");
    const testing::PackedMember is_signed{"isUnsigned", packed(false)};
    expect_contains(
        decode_error(wrong({127}, "IntegerPacking", {{"byteCount", packed_integer(1)}, is_signed, size(1)})),
        "cut off");
    expect_contains(decode_error(wrong({1}, "IntegerPacking", {{"byteCount", packed_integer(1)}, is_signed, size(2)})),
                    "srcSize");
    expect_contains(decode_error(wrong({1}, "IntegerPacking", {{"byteCount", packed_integer(4)}, is_signed, size(1)})),
                    "neither 1 nor 2");
    const std::vector<testing::PackedMember> ends{{"min", packed(0.0)}, {"max", packed(1.0)}};
    auto steps = ends;
    steps.push_back({"numSteps", packed_integer(1)});
    expect_contains(decode_error(wrong({0}, "IntervalQuantization", steps)), "below 2");
    steps.back().value = packed_integer(3);
    expect_contains(decode_error(wrong({3}, "IntervalQuantization", steps)), "none of \"numSteps\"");
    expect_contains(decode_error({"abc", testing::encoded({}, IntegerCoding::Plain).encodings}), "3 bytes");
    expect_contains(decode_error({"abc", {}}), "no list of encodings");
    expect_contains(decode_error({"abc", std::vector<std::string>(17, packed("x"))}), "no list of encodings");
    Encoded outside = testing::texts({"a"}, IntegerCoding::Plain);
    outside.bytes[0] = 7;
    expect_contains(decode_error(outside), "text 7 of 1");
}

}  // namespace
}  // namespace meniscus::reading
