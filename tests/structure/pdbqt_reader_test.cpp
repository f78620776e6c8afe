// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pdbqt_reader.h"

#include "fragments.h"
#include "support/test_data.h"

namespace meniscus {
namespace {

using testing::error_of;
using testing::expect_contains;
using testing::has_note;
using testing::pdb_line;
using testing::read_text;

// An atom as AutoDock writes it: charge in columns 71-76, type in 78-79.
std::string pdbqt_line(const testing::Line& atom, const std::string& type, double charge = -0.3) {
    std::string line = pdb_line(atom);
    line.pop_back();
    char tail[32];
    std::snprintf(tail, sizeof tail, "    %6.3f %-2s\n", charge, type.c_str());
    return line + tail;
}

std::string element_of(const std::string& type, const std::string& name = " X1 ") {
    const Structure s = read_text(pdbqt_line({.name = name, .residue = "LIG"}, type), "a.pdbqt");
    return s.labels.at(0).element;
}

TEST(Pdbqt, ElementsComeFromAtomTypes) {
    for (const auto& [type, element] : std::vector<std::pair<std::string, std::string>>{
             {"A", "C"},   {"C", "C"},   {"OA", "O"},  {"OS", "O"},  {"NA", "N"},  {"N", "N"},   {"NS", "N"},
             {"HD", "H"},  {"SA", "S"},  {"S", "S"},   {"P", "P"},   {"F", "F"},   {"I", "I"},   {"Cl", "CL"},
             {"CL", "CL"}, {"Br", "BR"}, {"Mg", "MG"}, {"Mn", "MN"}, {"Zn", "ZN"}, {"Fe", "FE"}, {"Ca", "CA"},
             {"CA", "CA"}, {"Na", "NA"}, {"CG0", "C"}, {"W", "O"}})
        EXPECT_EQ(element_of(type), element) << type;
}

TEST(Pdbqt, AnUnknownTypeLeavesTheElementToTheName) { EXPECT_EQ(element_of("Xx", " N1 "), "N"); }

TEST(Pdbqt, ChargesAreRead) {
    const std::string text = pdbqt_line({}, "C", 0.123) + pdbqt_line({.name = " N  ", .x = 2.0}, "NA", -1.25) +
                             pdbqt_line({.name = " O  ", .x = 4.0}, "OA", 1.0);
    const Structure s = read_text(text, "a.pdbqt");
    ASSERT_EQ(s.labels.size(), 3U);
    EXPECT_EQ(s.labels[0].charge, 0.123);
    EXPECT_EQ(s.labels[1].charge, -1.25);
    EXPECT_EQ(s.labels[2].charge, 1.0);
    EXPECT_TRUE(s.notes.empty());
    EXPECT_TRUE(s.warnings.empty());
}

TEST(Pdbqt, PosesAreModels) {
    const auto pose = [](double x) {
        return "REMARK VINA RESULT:    -7.1      0.000      0.000\nROOT\n" +
               pdbqt_line({.name = " C1 ", .residue = "LIG", .x = x}, "A") + "ENDROOT\nBRANCH   1   2\n" +
               pdbqt_line({.name = " O1 ", .residue = "LIG", .x = x + 1.4}, "OA") + "ENDBRANCH   1   2\nTORSDOF 1\n";
    };
    const std::string text = "MODEL 1\n" + pose(0) + "ENDMDL\nMODEL 2\n" + pose(5) + "ENDMDL\n";
    const Structure first = read_text(text, "out.pdbqt");
    EXPECT_EQ(first.atoms.size(), 2U);
    EXPECT_TRUE(has_note(first, "model 1 of 2 taken"));
    EXPECT_EQ(read_text(text, "out.pdbqt", {.model = 2}).atoms.centres[0].x, 5.0);
}

TEST(Pdbqt, WhatStandsForNoAtomIsLeftOutWithANote) {
    const std::string text = pdbqt_line({}, "CG0") + pdbqt_line({.x = 2.0}, "G0") + pdbqt_line({.x = 4.0}, "C", 0.5);
    const Structure s = read_text(text, "a.pdbqt");
    ASSERT_EQ(s.atoms.size(), 2U);
    EXPECT_EQ(s.labels[1].charge, 0.5);
    EXPECT_TRUE(has_note(s, "1 of AutoDock's atom types that stand for no atom (G0) left out"));
}

TEST(Pdbqt, IsRecognisedUnderTheNameOfPdb) {
    const std::string text = pdbqt_line({}, "A") + pdbqt_line({.name = " N  ", .x = 2.0}, "NA");
    for (const char* name : {"a.pdb", "a.ent"}) {
        const Structure s = read_text(text, name);
        EXPECT_EQ(s.labels.at(0).element, "C");
        EXPECT_EQ(s.labels.at(1).element, "N");
        EXPECT_TRUE(has_note(s, "read as PDBQT: charges and atom types of AutoDock"));
    }
    EXPECT_FALSE(reading::has_pdbqt_atoms(pdb_line({.element = " C"}) + pdb_line({.element = "CA"})));
    EXPECT_FALSE(
        reading::has_pdbqt_atoms("ATOM      1  N   ASN E   1      40.700  41.500  25.600  1.00 33.76      "
                                 "1ABC 123\n"));
}

TEST(Pdbqt, RecordsAreTidiedAsInPdb) {
    const std::string atom = pdbqt_line({}, "A");
    const auto other = [](const std::string& name) {
        return name + pdbqt_line({.name = " N  ", .x = 2.0}, "NA").substr(4);
    };
    for (const char* name : {"a.pdbqt", "a.pdb"}) {
        const Structure moved = read_text(atom + other(" ATOM"), name);
        EXPECT_EQ(moved.atoms.size(), 2U);
        EXPECT_EQ(moved.labels.at(1).element, "N");
        EXPECT_TRUE(testing::has_warning(moved, "line 2: 'ATOM': a record behind blanks"));
        const Structure lower = read_text(other("atom") + other("atom"), name);
        EXPECT_EQ(lower.atoms.size(), 2U);
        EXPECT_EQ(lower.labels.at(1).charge, -0.3);
        EXPECT_TRUE(testing::has_warning(read_text(atom + other("#ATOM"), name), "is not a record of the PDB format"));
        const std::string joined = atom.substr(0, atom.size() - 1) + " " + other("ATOM");
        expect_contains(error_of(joined, name), ":1:81: an atom record begins within a line");
    }
}

TEST(Pdbqt, APartnerBehindEndIsAWarning) {
    const std::string ligand = pdbqt_line({.residue = "LIG", .x = 9.0, .chain = 'B'}, "C");
    EXPECT_TRUE(testing::has_warning(read_text(pdbqt_line({}, "A") + "END\n" + ligand, "a.pdbqt"),
                                     "chain A taken, before END in line 2; chain B follows it"));
}

TEST(Pdbqt, ErrorsKeepTheirPlaces) {
    std::string wrong = pdbqt_line({.x = 2.0}, "C");
    wrong.replace(46, 8, "********");
    EXPECT_TRUE(error_of("ROOT\n" + pdbqt_line({}, "G0") + wrong, "a.pdbqt").starts_with("a.pdbqt:3:47: z coordinate"));
    expect_contains(error_of("ROOT\n", "a.pdbqt"), "no atoms in this file");
}

TEST(Pdbqt, AReportOfAUserIsRead) {
    MENISCUS_NEED_TEST_DATA();
    const Structure s = read_structure((*testing::test_data() / "malformed/reports/vina_as.pdb").string());
    EXPECT_EQ(s.atoms.size(), 67U);
    EXPECT_EQ(s.labels.at(0).element, "N");
    EXPECT_EQ(s.labels.at(7).element, "C");
    EXPECT_EQ(s.labels.at(0).charge, -0.3);
}

}  // namespace
}  // namespace meniscus
