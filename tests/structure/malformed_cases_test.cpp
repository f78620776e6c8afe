// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Awkward inputs beside the collection of files: each case ends in a surface's atoms or in one line that says why not.
#include "fragments.h"

namespace meniscus {
namespace {

using testing::error_of;
using testing::expect_contains;
using testing::gzipped;
using testing::pdb_line;
using testing::read_text;

TEST(MalformedCases, FieldsThatAreNoCoordinates) {
    for (const char* field : {"********", "        ", "nan     ", "     inf", "   1e400", "  11,104"}) {
        for (const std::size_t column : {30U, 38U, 46U}) {
            std::string line = pdb_line({});
            line.replace(column, 8, field);
            const std::string place = "a.pdb:2:" + std::to_string(column + 1) + ": ";
            EXPECT_TRUE(error_of(pdb_line({}) + line, "a.pdb").starts_with(place)) << field;
        }
    }
}

TEST(MalformedCases, ShortLines) {
    const std::string line = pdb_line({});
    for (std::size_t length = 6; length < 54; ++length) {
        EXPECT_TRUE(error_of(line.substr(0, length), "a.pdb").starts_with("a.pdb:1:")) << length;
    }
    for (std::size_t length = 54; length < line.size(); ++length) {
        EXPECT_EQ(read_text(line.substr(0, length), "a.pdb").atoms.size(), 1U) << length;
    }
}

TEST(MalformedCases, AWebPageIsNoStructure) {
    expect_contains(error_of("<html><body>404</body></html>\n", "1abc.pdb"), "HTML page");
}

TEST(MalformedCases, GzipCutInHalfAndTextNamedGzip) {
    const std::string whole = gzipped(pdb_line({}) + pdb_line({.number = 2, .x = 3.3}));
    expect_contains(error_of(whole.substr(0, whole.size() / 2), "a.pdb.gz"), "end too early");
    expect_contains(error_of(pdb_line({}), "a.pdb.gz"), "contains no gzip data");
}

TEST(MalformedCases, FoldersEmptyFilesAndDevices) {
    EXPECT_THROW(read_structure("/"), InputError);
    EXPECT_THROW(read_structure("/dev/null"), InputError);
    expect_contains(error_of("", "a.pdb"), "no atoms in this file");
    expect_contains(error_of("", "a.xyzr"), "no atoms in this file");
    expect_contains(error_of("", "a.pqr"), "no atoms in this file");
    expect_contains(error_of("", "a.cif"), "a.cif:");
    expect_contains(error_of("", "a.pdb.gz"), "contains no gzip data");
}

TEST(MalformedCases, OnlyWatersOnlyHydrogensOneAtom) {
    expect_contains(error_of(pdb_line({.name = " O  ", .residue = "TIP"}), "a.pdb"), "1 water left out (keep it with");
    const std::string hydrogens = pdb_line({.name = " H  "}) + pdb_line({.name = " HA ", .x = 2});
    EXPECT_EQ(read_text(hydrogens, "a.pdb").atoms.size(), 2U);
    expect_contains(error_of(hydrogens, "a.pdb", {.radii = "united"}), "2 hydrogens left out");
    EXPECT_EQ(read_text(pdb_line({}), "a.pdb").atoms.size(), 1U);
}

TEST(MalformedCases, CoincidentFarAndOddlySizedSpheres) {
    const Structure s = read_text("0 0 0 1\n0 0 0 1\n1e6 0 0 100\n3 0 0 0\n", "a.xyzr");
    EXPECT_EQ(s.atoms.size(), 3U);
    EXPECT_EQ(s.dropped.at("zero_radius"), 1U);
    EXPECT_TRUE(error_of("0 0 0 -1\n", "a.xyzr").starts_with("a.xyzr:1:7: radius '-1' is negative"));
    EXPECT_TRUE(error_of("0 0 0 inf\n", "a.xyzr").starts_with("a.xyzr:1:7: "));
}

TEST(MalformedCases, DamageAnywhereIsAnErrorOrAStructure) {
    std::string text = "SEQRES   1 A    2  ALA GLY\nLINK         SG  CYS A   1\nSSBOND   1\nCONECT\nHELIX    1\nTER\n" +
                       pdb_line({.element = " C"}) + "ANISOU\n" + pdb_line({.number = 2, .x = 3}) + "MASTER\nEND\n";
    for (std::size_t i = 0; i < text.size(); ++i) {
        for (const char c : {' ', '*', '\t', '\n', '9', '\xff', 'A'}) {
            std::string damaged = text;
            damaged[i] = c;
            try {
                const std::string path = "a.pdb";
                EXPECT_FALSE(read_text(damaged, path, {.assembly = ""}).atoms.empty());
            } catch (const InputError& error) {
                EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
            }
        }
    }
}

}  // namespace
}  // namespace meniscus
