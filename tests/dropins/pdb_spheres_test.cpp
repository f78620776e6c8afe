// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "dropins/pdb_spheres.h"

#include <gtest/gtest.h>

#include <sstream>

#include "meniscus/errors.h"

namespace meniscus::dropins {
namespace {

// The last atom of crambin, whose lines by MSMS's own scripts are public.
constexpr const char* kOxygen = "ATOM    327  OXT ASN A  46      12.703   4.973  10.746  1.00  7.86           O  \n";

std::vector<PdbRecord> read_pdb(const std::string& text) {
    std::istringstream stream(text);
    return read_pdb_records(stream, "a.pdb");
}

TEST(PdbSpheres, LinesAreThoseOfTheScripts) {
    const std::vector<PdbRecord> records = read_pdb(kOxygen);
    ASSERT_EQ(records.size(), 1U);
    EXPECT_EQ(xyzr_line(records[0], 1.4), "  12.703    4.973   10.746 1.40\n");
    EXPECT_EQ(xyzrn_line(records[0], 1.4), "12.703000 4.973000 10.746000 1.400000 1 OXT_ASN_46\n");
}

TEST(PdbSpheres, EveryRecordOfTheFirstModelIsALine) {
    const std::string text =
        std::string("HEADER\nMODEL        1\n") + kOxygen +
        "HETATM  332  O  AHOH A 101A      1.000  -2.000   3.000\nANISOU\nENDMDL\nMODEL        2\n" + kOxygen;
    const std::vector<PdbRecord> records = read_pdb(text);
    ASSERT_EQ(records.size(), 2U);
    EXPECT_EQ(records[1].names.residue, "HOH");
    EXPECT_EQ(records[1].names.name, "O");
    EXPECT_EQ(records[1].names.element, "O");
    EXPECT_EQ(records[1].number, "101A");
    EXPECT_EQ(records[1].centre, (Vec3{1.0, -2.0, 3.0}));
}

TEST(PdbSpheres, ElementsComeFromTheirColumnsElseFromTheName) {
    EXPECT_EQ(element_of(" CA ", "CA"), "CA");
    EXPECT_EQ(element_of(" CA ", " C"), "C");
    EXPECT_EQ(element_of(" CA ", ""), "C");
    EXPECT_EQ(element_of("CA  ", ""), "CA");
    EXPECT_EQ(element_of("HG11", ""), "H");
    EXPECT_EQ(element_of("1HB ", ""), "H");
    EXPECT_EQ(element_of("ZN  ", ""), "ZN");
    EXPECT_EQ(element_of(" N1+", "N1+"), "N");
}

TEST(PdbSpheres, MalformedRecordsAreToldWithTheirPlace) {
    std::string text = kOxygen;
    text.replace(38, 8, "   4.9x3");
    try {
        read_pdb(text);
        FAIL();
    } catch (const InputError& error) {
        EXPECT_TRUE(std::string(error.what()).starts_with("a.pdb:1:39: ")) << error.what();
    }
    EXPECT_THROW(read_pdb("ATOM      1\n"), InputError);
    EXPECT_THROW(read_pdb("data_1ABC\n"), InputError);
}

}  // namespace
}  // namespace meniscus::dropins
