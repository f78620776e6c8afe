// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pqr_content.h"

#include "fragments.h"
#include "structure/input_file.h"
#include "support/test_data.h"

namespace meniscus::reading {
namespace {

using testing::error_of;
using testing::expect_contains;
using testing::read_text;

const std::string kStart = "ATOM      1  N   MET A   1      27.340  24.430   2.614";
const std::string kNext = "ATOM      2  CA  MET A   1      26.266  25.413   2.842";
constexpr const char* kRemark = "REMARK    The B-factors in this file hold atomic radii\n";

std::string two_atoms(const std::string& first, const std::string& second) {
    return "TITLE     x\n" + kStart + first + "\n" + kNext + second + "\nEND\n";
}

const std::string kPdb = two_atoms("  1.00  9.67           N", "  1.00  0.38           C");
const std::string kPdbWithoutElements = two_atoms("  1.00  9.67", "  0.50 10.38");
const std::string kPdbWithoutBFactors = two_atoms("  1.00  0.00           N", "  1.00  0.00           C");
const std::string kGromacs = two_atoms("  0.16  1.62           N", " -0.16  1.70           C");
const std::string kPdb2pqr = two_atoms("  0.1592 1.8240", "  0.0000 1.9080");

TEST(PqrContent, PdbIsToldByItsColumnsAndRadiiThatNoAtomHas) {
    for (const std::string& text : {kPdb, kPdbWithoutElements, kPdbWithoutBFactors}) {
        EXPECT_TRUE(is_surely_pdb(text)) << text;
        EXPECT_FALSE(is_surely_pqr(text)) << text;
    }
    for (const std::string& text : {kGromacs, kPdb2pqr, std::string("END\n")})
        EXPECT_FALSE(is_surely_pdb(text)) << text;
    EXPECT_FALSE(is_surely_pdb(kRemark + kPdb));
    EXPECT_FALSE(is_surely_pdb(two_atoms(" -2.16  4.70", " -0.16  4.70")));  // beads with charges
}

TEST(PqrContent, PqrIsToldByNumbersThatAreNotInColumnsOfPdb) {
    const std::string in_no_columns = "ATOM  5 N      MET    1   -6.40600   5.46900  -3.25900 -0.30000 1.85000\n";
    for (const std::string& text : {kPdb2pqr, two_atoms("  0.185 1.824", " -0.190 1.000"), in_no_columns,
                                    two_atoms("  0.1592  1.8240       N  ", "  0.1592  1.8240       C  "),
                                    two_atoms("    0.00     3.62", "    0.10     3.62"), kRemark + kGromacs})
        EXPECT_TRUE(is_surely_pqr(text)) << text;
}

TEST(PqrContent, WhatMayBePdbIsNoPqr) {
    const std::string shifted = "ATOM  1000000  N   MET A   1      27.340  24.430   2.614";
    for (const std::string& text :
         {kGromacs, std::string("HEADER\n"), kStart + "\n", kPdb + kPdb2pqr,
          two_atoms("  1.000 9.670", "  1.000 8.380"),                                // B factors
          two_atoms("  1.00   1.00", "  0.00   1.00"),                                // marks of atoms
          two_atoms("  4     1 1.63         -0.15", "  4     1 1.63         -0.15"),  // of ZDOCK
          two_atoms("  4     1", "  4     1"), shifted + "  1.00  9.67           N\n", shifted + "  1.00  0.00\n"})
        EXPECT_FALSE(is_surely_pqr(text)) << text;
}

TEST(PqrContent, OneNamedAsTheOtherIsRefused) {
    for (const std::string& text : {kPdb, kPdbWithoutElements, kPdbWithoutBFactors})
        expect_contains(error_of(text, "a.pqr"), "a.pqr: looks like a PDB file (occupancy and B factor");
    for (const char* name : {"a.pdb", "a.ent", "a.pdb1"})
        expect_contains(error_of(kPdb2pqr, name), "contains PQR (charge and radius");
    EXPECT_EQ(read_text(kPdb2pqr, "a.pqr").atoms.size(), 2U);
    EXPECT_EQ(read_text(kGromacs, "a.pqr").atoms.size(), 2U);
    EXPECT_EQ(read_text(kPdb, "a.pdb").atoms.size(), 2U);
}

TEST(PqrContent, OnStandardInputPqrIsRecognised) {
    EXPECT_EQ(load_bytes(kPdb2pqr, "-").format, Format::Pqr);
    EXPECT_EQ(load_bytes("# by hand\n" + kPdb2pqr, "-").format, Format::Pqr);
    EXPECT_EQ(load_bytes(kRemark + kGromacs, "-").format, Format::Pqr);
    EXPECT_EQ(load_bytes(kGromacs, "-").format, Format::Pdb);
    EXPECT_EQ(load_bytes(kPdb, "-").format, Format::Pdb);
}

TEST(PqrContent, RealFilesAreWhatTheyAreNamed) {
    MENISCUS_NEED_TEST_DATA();
    std::size_t pqr = 0;
    for (const char* folder : {"structures", "malformed", "ligands", "complexes", "pockets"}) {
        const auto root = *testing::test_data() / folder;
        if (!std::filesystem::exists(root)) continue;
        for (const auto& entry : std::filesystem::recursive_directory_iterator(root)) {
            const std::string name = entry.path().string();
            if (!name.ends_with(".pqr") && !name.ends_with(".pdb")) continue;
            const std::string text = testing::read_file(name);
            EXPECT_EQ(is_surely_pqr(text), name.ends_with(".pqr")) << name;
            EXPECT_FALSE(name.ends_with(".pqr") && is_surely_pdb(text)) << name;
            pqr += static_cast<std::size_t>(name.ends_with(".pqr"));
        }
    }
    EXPECT_GE(pqr, 5U);
}

}  // namespace
}  // namespace meniscus::reading
