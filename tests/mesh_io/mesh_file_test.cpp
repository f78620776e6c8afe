// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_io/mesh_file.h"

#include <gtest/gtest.h>

#include "meniscus/errors.h"

namespace meniscus::reading {
namespace {

TEST(TextCursor, WordsOverLinesAndComments) {
    const std::string file = "a";
    TextCursor cursor(file, "one # two\n\t three\r\n# four\nfive");
    EXPECT_EQ(cursor.next(), "one");
    EXPECT_EQ(cursor.next(), "three");
    EXPECT_EQ(cursor.next(), "five");
    EXPECT_EQ(cursor.next(), "");
    EXPECT_EQ(cursor.bytes_left(), 0U);
}

TEST(TextCursor, FailsAtTheLastWord) {
    const std::string file = "a.off";
    TextCursor cursor(file, "1 2\n  x");
    EXPECT_EQ(cursor.number("a number"), 1.0);
    cursor.skip_line();
    try {
        cursor.number("a number");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_STREQ(error.what(), "a.off:2:3: a number: 'x' is not a finite number; correct it");
    }
}

TEST(BinaryCursor, BothByteOrdersAndTheEnd) {
    const std::string file = "a";
    const std::string bytes("\x01\x02\x03", 3);
    EXPECT_EQ(BinaryCursor(file, bytes).take<std::uint16_t>("a number"), 0x0201);
    BinaryCursor big(file, bytes, 0, std::endian::big);
    EXPECT_EQ(big.take<std::uint16_t>("a number"), 0x0102);
    EXPECT_EQ(big.position(), 2U);
    EXPECT_THROW(big.take<std::uint16_t>("a number"), InputError);
    EXPECT_THROW(big.skip(2, "a number"), InputError);
}

TEST(AddPolygon, IsAFanRoundTheFirstCorner) {
    Mesh mesh;
    add_polygon(mesh, std::vector<VertexId>{5, 6, 7, 8, 9});
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{5, 6, 7}, {5, 7, 8}, {5, 8, 9}}));
}

}  // namespace
}  // namespace meniscus::reading
