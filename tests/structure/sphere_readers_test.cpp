// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/sphere_readers.h"

#include "fragments.h"

namespace meniscus::reading {
namespace {

using meniscus::testing::expect_contains;

template <class Parse>
std::string error_in(Parse parse, const std::string& text) {
    try {
        parse(text, "f");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

TEST(Xyzr, ReadsSpheresCommentsAndBlankLines) {
    const RawModel model = parse_xyzr("# spheres\n0 0 0 1.7\n\n1\t2\t3\t1.5 # last\n1e6 0 0 100 more words\n", "f");
    ASSERT_EQ(model.atoms.size(), 3U);
    EXPECT_FALSE(model.has_names);
    EXPECT_EQ(model.atoms[1].centre, (Vec3{1, 2, 3}));
    EXPECT_EQ(model.atoms[1].radius, 1.5);
    EXPECT_EQ(model.atoms[2].centre.x, 1e6);
    EXPECT_EQ(model.atoms[2].radius, 100.0);
}

TEST(Xyzr, ErrorsNameTheirPlace) {
    EXPECT_TRUE(error_in(parse_xyzr, "0 0 0\n").starts_with("f:1:6: the radius is missing"));
    EXPECT_EQ(error_in(parse_xyzr, "0 0 0 1\n0 1e300 0 1\n"),
              "f:2:3: y coordinate '1e300' is more than 1e12 Å; correct it");
    EXPECT_EQ(error_in(parse_xyzr, "0 0 0 2e12\n"), "f:1:7: radius '2e12' is more than 1e12 Å; correct it");
    EXPECT_TRUE(error_in(parse_xyzr, "0 0 0 1\n0 0 0 -1\n").starts_with("f:2:7: radius '-1' is negative"));
    EXPECT_TRUE(error_in(parse_xyzr, "x 0 0 1\n").starts_with("f:1:1: x coordinate 'x'"));
    EXPECT_TRUE(error_in(parse_xyzr, "0 0 1e400 1\n").starts_with("f:1:5: z coordinate '1e400'"));
    EXPECT_EQ(parse_xyzr("", "f").atoms.size(), 0U);
}

TEST(Xyzrn, TakesNamesApart) {
    const RawModel model =
        parse_xyzrn("0 0 0 1.7 1 CA_ALA_12\n1 0 0 1.5 1 O5'_HOH_-3_A-2\n2 0 0 1.5 1 odd\n3 0 0 1\n", "f");
    ASSERT_EQ(model.atoms.size(), 4U);
    EXPECT_EQ(model.atoms[0].name, "CA");
    EXPECT_EQ(model.residue_of(model.atoms[0]).name, "ALA");
    EXPECT_EQ(model.residue_of(model.atoms[0]).number, 12);
    EXPECT_EQ(model.residue_of(model.atoms[1]).name, "HOH");
    EXPECT_EQ(model.residue_of(model.atoms[1]).number, -3);
    EXPECT_EQ(model.residue_of(model.atoms[1]).chain, "A-2");
    EXPECT_EQ(model.atoms[2].name, "ODD");
    EXPECT_EQ(model.atoms[3].name, "");
}

}  // namespace
}  // namespace meniscus::reading
