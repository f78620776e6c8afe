// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/join_residues.h"

#include "fragments.h"

namespace meniscus {
namespace {

using reading::join_residues;
using reading::RawModel;
using testing::add_residue;
using testing::pdb_line;
using testing::read_text;

std::uint32_t add(RawModel& model, const std::string& segment, int number, std::initializer_list<const char*> atoms) {
    const std::uint32_t residue = add_residue(model, "THR", number, atoms);
    model.residues[residue].segment = segment;
    return residue;
}

// The residue of every atom, after joining.
std::vector<std::uint32_t> residues_of_atoms(RawModel model) {
    join_residues(model);
    std::vector<std::uint32_t> residues;
    for (const reading::RawAtom& atom : model.atoms) residues.push_back(atom.residue);
    return residues;
}

using Residues = std::vector<std::uint32_t>;

TEST(JoinResidues, ASegmentOnSomeAtomsPartsNothing) {
    RawModel model;
    add(model, "A", 1, {"N"});
    add(model, "", 1, {"CA", "C"});
    add(model, "A", 1, {"O"});
    add(model, "", 1, {"CB"});
    add(model, "", 2, {"N", "CA"});
    EXPECT_EQ(residues_of_atoms(model), (Residues{0, 0, 0, 0, 0, 1, 1}));
    join_residues(model);
    EXPECT_EQ(model.residues.at(0).segment, "A");
}

TEST(JoinResidues, SegmentsPartWhatWouldRepeat) {
    RawModel model;
    add(model, "PROA", 1, {"N", "CA"});
    add(model, "PROB", 1, {"N", "CA"});
    add(model, "", 1, {"C"});  // stands behind PROB
    EXPECT_EQ(residues_of_atoms(model), (Residues{0, 0, 1, 1, 1}));
}

TEST(JoinResidues, ProteinsThatOnlySegmentsTellApartStayTwo) {
    RawModel model;
    for (const char* segment : {"PROA", "PROB"})
        for (const int number : {1, 2, 3}) add(model, segment, number, {"N", "CA", "C", "O"});
    join_residues(model);
    EXPECT_EQ(model.residues.size(), 6U);
    EXPECT_EQ(model.residues[0].segment, "PROA");
    EXPECT_EQ(model.residues[3].segment, "PROB");
}

TEST(JoinResidues, AtomsAtTheEndOfTheFileBelongToTheirResidue) {
    RawModel model;
    add(model, "", 1, {"N", "CA"});
    add(model, "", 2, {"N", "CA"});
    add(model, "", 1, {"H"});
    add(model, "", 2, {"H"});
    EXPECT_EQ(residues_of_atoms(model), (Residues{0, 0, 1, 1, 0, 1}));
}

TEST(JoinResidues, WhereItIsDoubtfulPiecesStayApart) {
    RawModel model;
    for (const int number : {1, 2, 1, 2}) add(model, "", number, {"N", "CA"});
    add(model, "", 1, {"H"});  // of the first or of the third
    EXPECT_EQ(residues_of_atoms(model), (Residues{0, 0, 1, 1, 2, 2, 3, 3, 4}));
}

TEST(JoinResidues, OtherNamesAndChainsAreOtherResidues) {
    RawModel model;
    add(model, "", 1, {"N"});
    add(model, "", 1, {"CA"});
    add(model, "", 1, {"C"});
    model.residues[1].name = "SER";
    model.residues[2].label_chain = "B";
    EXPECT_EQ(residues_of_atoms(model), (Residues{0, 1, 2}));
}

TEST(JoinResidues, AlternativesWithOtherNamesMayStandBetween) {
    RawModel model;
    for (const char* name : {"SER", "PRO", "SER", "PRO"}) {
        const std::uint32_t residue = add(model, "", 1, {model.atoms.size() < 2 ? "N" : "CA"});
        model.residues[residue].name = name;
        model.atoms.back().altloc = name == std::string("SER") ? 'A' : 'B';
    }
    EXPECT_EQ(residues_of_atoms(model), (Residues{0, 1, 0, 1}));
}

TEST(JoinResidues, AFileThatNumbersEveryResidueOneKeepsThemApart) {
    RawModel model;
    for (const char* name : {"LEU", "ARG", "LEU", "ARG"}) model.residues[add(model, "", 1, {"N", "CA"})].name = name;
    EXPECT_EQ(residues_of_atoms(model), (Residues{0, 0, 1, 1, 2, 2, 3, 3}));
}

TEST(JoinResidues, AlternativesOfTheSameAtomJoin) {
    RawModel model;
    add(model, "", 1, {"N"});
    add(model, "", 2, {"N"});
    add(model, "AC1", 1, {"N"});
    model.atoms[0].altloc = 'A';
    model.atoms[2].altloc = 'B';
    EXPECT_EQ(residues_of_atoms(model), (Residues{0, 1, 0}));
}

// A PDB line with a segment identifier.
std::string with_segment(const std::string& line, const std::string& segment) {
    std::string text = line.substr(0, line.size() - 1);
    text.resize(72, ' ');
    return text + segment + "\n";
}

TEST(JoinResidues, OneResidueOfAFileIsOneResidue) {
    const std::string text = with_segment(pdb_line({.name = " N  "}), "   A") + pdb_line({.name = " CA ", .x = 1.5}) +
                             with_segment(pdb_line({.name = " O  ", .x = 3.0}), "   A") +
                             pdb_line({.name = " N  ", .number = 2, .x = 5.0});
    const Structure s = read_text(text, "s.pdb");
    EXPECT_EQ(s.residues.size(), 2U);
    EXPECT_EQ(s.labels.at(2).residue, 0U);
}

TEST(JoinResidues, ChainsOfAnMdProgramStayTwo) {
    std::string text;
    for (const char* segment : {"PROA", "PROB"})
        for (const char* name : {" N  ", " CA "})
            text +=
                with_segment(pdb_line({.name = name, .x = static_cast<double>(text.size()), .chain = ' '}), segment);
    EXPECT_EQ(read_text(text, "s.pdb").residues.size(), 2U);
}

TEST(JoinResidues, AtomsOfAResidueMayStandApart) {
    const std::string text = pdb_line({.name = " N  "}) + pdb_line({.name = " N  ", .number = 2, .x = 4.0}) +
                             pdb_line({.name = " CA ", .x = 1.5});
    const Structure s = read_text(text, "s.pdb");
    ASSERT_EQ(s.residues.size(), 2U);
    EXPECT_EQ(s.labels.at(2).residue, 0U);
    EXPECT_EQ(s.labels.at(2).name, "CA");
}

}  // namespace
}  // namespace meniscus
