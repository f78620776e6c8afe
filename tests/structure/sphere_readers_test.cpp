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

TEST(Pqr, ReadsAtomsWithAndWithoutAChain) {
    const RawModel model = parse_pqr(
        "REMARK x\nATOM  5 N      MET    1   -6.40600   5.46900  -3.25900 -0.30000 1.85000\n"
        "HETATM 6 ZN ZN B -27A 1 2 3 2.0 1.4\nATOM 7 CA ALA C1000 1 2 3 0 1.7\nTER\nEND\n",
        "f");
    ASSERT_EQ(model.atoms.size(), 3U);
    EXPECT_TRUE(model.has_radii);
    EXPECT_EQ(model.atoms[0].centre, (Vec3{-6.406, 5.469, -3.259}));
    EXPECT_EQ(model.atoms[0].charge, -0.3);
    EXPECT_EQ(model.atoms[0].radius, 1.85);
    EXPECT_EQ(model.atoms[0].element, "N");
    EXPECT_EQ(model.residues[0].number, 1);
    EXPECT_EQ(model.residues[1].chain, "B");
    EXPECT_EQ(model.residues[1].number, -27);
    EXPECT_EQ(model.residues[1].insertion_code, 'A');
    EXPECT_EQ(model.atoms[1].element, "ZN");
    EXPECT_EQ(model.residues[2].chain, "C");
    EXPECT_EQ(model.residues[2].number, 1000);
}

TEST(Pqr, ErrorsNameTheirPlace) {
    EXPECT_TRUE(error_in(parse_pqr, "ATOM 1 N ALA 1 0 0 0 0 -1.5\n").starts_with("f:1:24: radius '-1.5' is negative"));
    EXPECT_TRUE(error_in(parse_pqr, "ATOM 1 N ALA 1 0 nan 0 0 1.5\n").starts_with("f:1:18: y coordinate 'nan'"));
    EXPECT_TRUE(error_in(parse_pqr, "\nATOM 1 N ALA 1 0 0 0 1,0 1.5\n").starts_with("f:2:22: charge '1,0'"));
    expect_contains(error_in(parse_pqr, "ATOM 1 N ALA 1 0 0 0 0\n"), "this line has 9");
    expect_contains(error_in(parse_pqr, "ATOM 1 N ALA A 0 0 0 0 1\n"), "residue number 'A'");
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
