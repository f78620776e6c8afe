// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/message_pack.h"

#include "bcif_writer.h"
#include "fragments.h"

namespace meniscus::reading {
namespace {

using testing::expect_contains;
using Kind = PackedValue::Kind;

std::string unpack_error(std::string_view bytes) {
    try {
        unpack(bytes);
    } catch (const DamagedData& damage) {
        return damage.what() + (" at " + std::to_string(damage.at()));
    }
    return "";
}

std::string bytes_of(std::initializer_list<int> bytes) {
    std::string result;
    for (const int byte : bytes) result.push_back(static_cast<char>(byte));
    return result;
}

TEST(MessagePack, ReadsNumbersOfEverySize) {
    EXPECT_EQ(unpack(bytes_of({0x7f})).integer, 127);
    EXPECT_EQ(unpack(bytes_of({0xe0})).integer, -32);
    EXPECT_EQ(unpack(bytes_of({0xcc, 0xff})).integer, 255);
    EXPECT_EQ(unpack(bytes_of({0xcd, 0x01, 0x02})).integer, 0x102);
    EXPECT_EQ(unpack(bytes_of({0xce, 0xff, 0, 0, 1})).integer, 0xff000001LL);
    EXPECT_EQ(unpack(bytes_of({0xcf, 0, 0, 1, 0, 0, 0, 0, 0})).integer, 1LL << 40);
    EXPECT_EQ(unpack(bytes_of({0xd0, 0x80})).integer, -128);
    EXPECT_EQ(unpack(bytes_of({0xd1, 0xff, 0xfe})).integer, -2);
    EXPECT_EQ(unpack(bytes_of({0xd2, 0x80, 0, 0, 0})).integer, -2147483648LL);
    EXPECT_EQ(unpack(bytes_of({0xd3, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff, 0xff})).integer, -1);
    EXPECT_EQ(unpack(bytes_of({0xca, 0x3f, 0xc0, 0, 0})).real, 1.5);
    EXPECT_EQ(unpack(testing::packed(-2.25)).real, -2.25);
    EXPECT_EQ(unpack(testing::packed(std::int64_t{7})).real, 7.0);
}

TEST(MessagePack, ReadsTextsListsAndMaps) {
    EXPECT_EQ(unpack(testing::packed(std::string(40, 'a'))).text, std::string(40, 'a'));
    EXPECT_EQ(unpack(testing::packed(std::string(300, 'b'))).text, std::string(300, 'b'));
    EXPECT_EQ(unpack(testing::packed_bytes("xyz")).kind, Kind::Bytes);
    EXPECT_EQ(unpack(testing::packed(true)).integer, 1);
    EXPECT_EQ(unpack(testing::packed_nil()).kind, Kind::Nil);
    EXPECT_EQ(unpack(bytes_of({0xd4, 1, 2})).kind, Kind::Extension);
    EXPECT_EQ(unpack(bytes_of({0xc7, 2, 1, 0, 0})).kind, Kind::Extension);
    EXPECT_EQ(unpack(testing::packed_array(std::vector<std::string>(20, testing::packed("q")))).items.size(), 20U);
    const std::string map = testing::packed_map({{"a", testing::packed(std::int64_t{1})}, {"b", testing::packed("c")}});
    const PackedValue value = unpack(map);
    ASSERT_NE(value.find("b"), nullptr);
    EXPECT_EQ(value.find("b")->text, "c");
    EXPECT_EQ(value.find("c"), nullptr);
}

TEST(MessagePack, DamageIsNamedWithItsByte) {
    expect_contains(unpack_error(""), "ends too early at 0");
    expect_contains(unpack_error(bytes_of({0xc1})), "does not use at 0");
    expect_contains(unpack_error(bytes_of({1, 2})), "more bytes than its contents have at 1");
    expect_contains(unpack_error(bytes_of({0xdd, 0xff, 0xff, 0xff, 0xff, 0})), "ends too early");
    expect_contains(unpack_error(bytes_of({0xdb, 0x7f, 0xff, 0xff, 0xff, 0})), "ends too early");
    expect_contains(unpack_error(bytes_of({0xdf, 0xff, 0xff, 0xff, 0xff, 0})), "ends too early");
    expect_contains(unpack_error(bytes_of({0xcf, 0xff, 0, 0, 0, 0, 0, 0, 0})), "out of range");
    expect_contains(unpack_error(std::string(1000, '\x91')), "nested too deeply at 33");
}

}  // namespace
}  // namespace meniscus::reading
