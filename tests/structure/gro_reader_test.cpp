// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/gro_reader.h"

#include "fragments.h"
#include "structure/input_file.h"
#include "support/test_data.h"

namespace meniscus::reading {
namespace {

using testing::error_of;
using testing::expect_contains;
using testing::has_note;
using testing::has_warning;
using testing::read_text;

constexpr const char* kAtoms =
    "    1ALA      N    1   0.126  -1.624   1.679\n"
    "    1ALA     CA    2   0.191  -1.661   1.600  0.1227 -0.0580  0.0434\n"
    "    2GLY      C    3   0.295  -1.545   1.551\n"
    "    3LIG   CL12    4   1.295   1.545   1.551\n"
    "    3LIG     O1    5   1.395   1.545   1.551\n"
    "    4NA      NA    6   3.295   1.545   1.551\n"
    "    5SOL     OW    7   4.295   1.545   1.551\n"
    "    5SOL    HW1    8   4.395   1.545   1.551\n"
    "    5SOL    HW2    9   4.295   1.645   1.551\n"
    "    5SOL     MW   10   4.296   1.546   1.551\n";
const std::string kSmall = std::string("Protein in water t=   0.00000 step= 0\n   10\n") + kAtoms + "   5.0 5.0 5.0\n";

constexpr const char* kEverything = "a.gro";
const ReadOptions kAll{.hetero = HeteroPolicy::All, .keep_waters = true};

RawModel gro(const std::string& text, std::size_t frame = 0) {
    return parse_gro(text, find_gro_frames(text, "f.gro").at(frame), "f.gro");
}

std::string one_atom(const std::string& line) { return "title\n1\n" + line + "\n 1 1 1\n"; }

TEST(GroReader, ReadsColumnsInAngstroms) {
    const RawModel model = gro(kSmall);
    ASSERT_EQ(model.atoms.size(), 9U);
    EXPECT_EQ(model.atoms[0].centre, (Vec3{1.26, -16.24, 16.79}));
    EXPECT_EQ(model.atoms[1].centre, (Vec3{1.91, -16.61, 16.0}));
    EXPECT_EQ(model.atoms[1].name, "CA");
    EXPECT_EQ(model.atoms[1].element, "C");
    EXPECT_EQ(model.atoms[3].element, "CL");
    EXPECT_EQ(model.atoms[5].element, "NA");
    EXPECT_EQ(model.atoms[5].serial, 6);
    ASSERT_EQ(model.residues.size(), 5U);
    EXPECT_EQ(model.residues[1].name, "GLY");
    EXPECT_EQ(model.residues[1].number, 2);
    EXPECT_EQ(model.residues[1].chain, "");
}

TEST(GroReader, FollowsTheRulesOfPdbFiles) {
    const Structure polymer = read_text(kSmall, kEverything);
    EXPECT_EQ(polymer.atoms.size(), 3U);
    EXPECT_TRUE(has_note(polymer, "3 elements taken from atom names: GROMACS files have no elements"));
    EXPECT_TRUE(has_note(polymer, "1 virtual site of water left out"));
    EXPECT_TRUE(has_note(polymer, "taken as hetero groups"));
    EXPECT_EQ(read_text(kSmall, kEverything, {.hetero = HeteroPolicy::Ligands}).atoms.size(), 5U);
    const Structure all = read_text(kSmall, kEverything, kAll);
    EXPECT_EQ(all.atoms.size(), 7U);  // without hydrogens
    EXPECT_TRUE(has_warning(all, "3 elements in non-standard residues guessed"));
}

TEST(GroReader, GivesTheNumbersOfThePdbFile) {
    const Structure pdb = read_text(testing::pdb_line({.name = " CA ", .x = 12.34, .y = -0.07, .z = 5.55}), "a.pdb");
    const Structure own = read_text(one_atom("    1ALA     CA    1   1.234  -0.007   0.555"), "a.gro");
    EXPECT_EQ(pdb.atoms.centres, own.atoms.centres);
    EXPECT_EQ(pdb.atoms.radii, own.atoms.radii);
}

TEST(GroReader, ThePrecisionIsWhereThePointsStand) {
    EXPECT_EQ(gro(one_atom("    1ALA     CA    1   1.23456  -0.00700   0.55555")).atoms[0].centre,
              (Vec3{12.3456, -0.07, 5.5555}));
    EXPECT_EQ(gro(one_atom("    1ALA     CA    1   1.2  -0.1   0.5")).atoms[0].centre, (Vec3{12.0, -1.0, 5.0}));
}

TEST(GroReader, NumbersMayBeginAgain) {
    const RawModel model =
        gro("t\n4\n99999SOL     OW99999   0.000   0.000   0.000\n    0SOL     OW    0   1.000   0.000   0.000\n"
            "    0ALA     CA*****   2.000   0.000   0.000\n    0SOL     OW    2   3.000   0.000   0.000\n"
            " 1 1 1\n");
    ASSERT_EQ(model.residues.size(), 4U);
    EXPECT_EQ(model.atoms[2].serial, 3);
    EXPECT_EQ(model.atoms[3].residue, 3U);
}

TEST(GroReader, NeighboursOfOneNumberAreToldApartByTheirFirstAtoms) {
    const auto residues = [](const std::string& name) {
        const std::string line = "    1" + name + "     N     1   0.000   0.000   0.000\n";
        std::string other = line;
        other[14] = 'C';
        return gro("t\n4\n" + line + other + line + other + " 1 1 1\n").residues.size();
    };
    EXPECT_EQ(residues("ALA"), 2U);
    EXPECT_EQ(residues("LIG"), 1U);  // whose atoms may all have one name
}

TEST(GroReader, FramesAreModels) {
    const std::string frame = one_atom("    1ALA     CA    1   1.000   0.000   0.000");
    const std::string other = one_atom("    1ALA     CA    1   2.000   0.000   0.000");
    const std::string text = frame + other + "\n\n";
    ASSERT_EQ(find_gro_frames(text, "f").size(), 2U);
    EXPECT_EQ(gro(text, 1).atoms.at(0).centre.x, 20.0);
    EXPECT_EQ(read_text(text, "a.gro", {.model = 2}).atoms.centres.at(0).x, 20.0);
    EXPECT_TRUE(has_note(read_text(text, "a.gro"), "model 1 of 2"));
    expect_contains(error_of(text, "a.gro", {.model = 3}), "no model 3; there are 2");
    expect_contains(error_of(frame + "title\n2\n" + std::string(kAtoms).substr(0, 45), "a.gro"),
                    "a.gro:8:1: the file ends after 1 of 2 atoms");
}

TEST(GroReader, IonsOfForceFieldsHaveTheirElements) {
    const Structure ions = read_text(
        "t\n7\n    1NA+     NA    1   0.000   0.000   0.000\n    2CA2+    CA    2   1.000   0.000   0.000\n"
        "    3NA2     NA    3   2.000   0.000   0.000\n    4ION     CA    4   3.000   0.000   0.000\n"
        "    5ION    CLA    5   4.000   0.000   0.000\n    6LIG     CA    6   5.000   0.000   0.000\n"
        "    6LIG     CB    7   5.100   0.000   0.000\n 9 9 9\n",
        kEverything, kAll);
    EXPECT_TRUE(
        has_warning(ions, "7 elements in non-standard residues guessed from atom names: 2 C, 2 Ca, 2 Na, 1 Cl"));
}

TEST(GroReader, MissingAndWrongLinesAreNamed) {
    const std::string line = "    1ALA     CA    1   1.000   0.000   0.000";
    expect_contains(error_of("", "a.gro"), "a.gro:1:1: the line of the title is missing");
    expect_contains(error_of("title\n", "a.gro"), "a.gro:2:1: the line of the number of atoms is missing");
    expect_contains(error_of("title\nten\n", "a.gro"), "a.gro:2:1: the second line of a frame is the number");
    expect_contains(error_of("title\n-1\n", "a.gro"), "a.gro:2:1: the second line of a frame is the number");
    expect_contains(error_of("title\n2\n" + line + "\n", "a.gro"), "a.gro:4:1: the file ends after 1 of 2 atoms");
    expect_contains(error_of("title\n1\n" + line + "\n", "a.gro"), "a.gro:4:1: the line of the box is missing");
    expect_contains(error_of("title\n1\n" + line + "\n" + line + "\n 1 1 1\n", "a.gro"),
                    "a.gro:4:1: another atom behind 1 atom, the number on line 2");
    expect_contains(error_of("title\n1\n" + line + "\n1 1\n", "a.gro"), "a.gro:4:1: the box needs three lengths");
    expect_contains(error_of("title\n1\n1 ALA CA 1 0.1 0.2 0.3\n1 1 1\n", "a.gro"), "a.gro:3:1: no three coordinates");
    expect_contains(error_of("title\n0\n1 1 1\n", "a.gro"), "no atoms in this file");
}

TEST(GroReader, WrongFieldsAreErrorsWithTheirPlace) {
    const std::string first = "    1ALA     CA    1   1.000   0.000   0.000\n";
    const auto second = [&](const std::string& line) {
        return error_of("t\n2\n" + first + line + "\n1 1 1\n", "a.gro");
    };
    expect_contains(second("    xALA     CA    1   1.000   0.000   0.000"), "a.gro:4:1: residue number");
    expect_contains(second("    1        CA    1   1.000   0.000   0.000"), "a.gro:4:6: the name of the residue");
    expect_contains(second("    1ALA           1   1.000   0.000   0.000"), "a.gro:4:11: the name of the atom");
    expect_contains(second("    1ALA     CA    1   1.000     nan   0.000"), "a.gro:4:29: y coordinate");
    expect_contains(second("    1ALA     CA    1    1.000   0.000   0.000"), "a.gro:4:29: y coordinate");
    expect_contains(second("    1ALA     CA    1   1.000   0.000   0.00"),
                    "a.gro:4:44: the line ends before column 44");
    expect_contains(second("    1A\x01"
                           "A     CA    1   1.000   0.000   0.000"),
                    "a.gro:4:6: a byte");
}

TEST(GroReader, IsToldByContent) {
    EXPECT_EQ(load_bytes(kSmall, "-").format, Format::Gro);
    expect_contains(error_of(kSmall, "a.pdb"), "rename it to .gro");
    expect_contains(error_of("HEADER\nATOM\n", "a.gro"), "rename it to .pdb");
    expect_contains(error_of("data_x\n_a.b 1\n", "a.gro"), "rename it to .cif");
    EXPECT_EQ(read_text(kSmall, "b.gro").name, "b");
    EXPECT_EQ(read_text(testing::gzipped(kSmall), "b.gro.gz").atoms.size(), 3U);
}

// Adenylate kinase in water with its ions, as GROMACS wrote it.
TEST(GroReader, ASimulationGivesItsProtein) {
    MENISCUS_NEED_TEST_DATA();
    const auto path = *testing::test_data() / "trajectories" / "adk_oplsaa.gro";
    if (!std::filesystem::exists(path)) GTEST_SKIP() << path << " is not there";
    const Structure protein = read_structure(path.string());
    EXPECT_EQ(protein.atoms.size(), 3341U);
    EXPECT_EQ(protein.radii_set, "bondi");
    EXPECT_FALSE(has_warning(protein, "unknown element"));
    EXPECT_EQ(read_structure(path.string(), kAll).atoms.size(), 36597U);
    const Structure sodium = read_structure(path.string(), {.select = "(NA+)", .hetero = HeteroPolicy::All});
    EXPECT_TRUE(has_warning(sodium, "4 elements in non-standard residues guessed from atom names: 4 Na"));
}

}  // namespace
}  // namespace meniscus::reading
