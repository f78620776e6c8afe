// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "meniscus/errors.h"
#include "meniscus/named_atoms.h"

namespace meniscus {
namespace {

NamedAtom named(const std::string& residue, int number, const std::string& name, double x) {
    NamedAtom atom;
    atom.centre = {x, 0, 0};
    atom.chain = "A";
    atom.residue = residue;
    atom.name = name;
    atom.element = name.substr(0, 1);
    atom.residue_number = number;
    return atom;
}

TEST(StructureOfAtoms, ChoosesAsOfAFile) {
    std::vector<NamedAtom> atoms{named("GLY", 1, "CA", 0), named("HOH", 2, "O", 4), named("LIG", 3, "C1", 8),
                                 named("LIG", 3, "C2", 9)};
    const StructureOfAtoms made = structure_of_atoms(atoms, "Elsewhere");
    EXPECT_EQ(made.indices, (std::vector<std::size_t>{0}));
    EXPECT_EQ(made.structure.radii_set, "united");
    EXPECT_TRUE(made.structure.file.empty());
    EXPECT_EQ(made.structure.dropped.at("waters"), 1U);
    EXPECT_EQ(made.structure.notes.front(),
              "residues that are neither amino acids nor nucleotides nor water taken as hetero groups: Elsewhere does "
              "not tell them");
    const StructureOfAtoms all = structure_of_atoms(atoms, "Elsewhere", {.hetero = HeteroPolicy::All});
    EXPECT_EQ(all.indices, (std::vector<std::size_t>{0, 2, 3}));
    for (NamedAtom& atom : atoms) atom.is_hetero = false;
    EXPECT_EQ(structure_of_atoms(atoms, "Elsewhere").indices, all.indices);
}

TEST(StructureOfAtoms, GuessesElementsAndLeavesOutVirtualSites) {
    std::vector<NamedAtom> atoms{named("ALA", 1, "CA", 0), named("SOL", 2, "OW", 4), named("SOL", 2, "MW", 4.1),
                                 named("ALA", 3, "N", 8)};
    for (NamedAtom& atom : atoms) atom.element.clear();
    atoms[2].element = "VS";
    const StructureOfAtoms made = structure_of_atoms(atoms, "Elsewhere", {.keep_waters = true});
    EXPECT_EQ(made.indices, (std::vector<std::size_t>{0, 1, 3}));
    EXPECT_EQ(made.structure.labels[0].element, "C");
    EXPECT_EQ(made.structure.notes.front(), "1 virtual site of water left out: no atoms");
}

TEST(StructureOfAtoms, TakesRadiiIfAllAtomsHaveOne) {
    std::vector<NamedAtom> atoms{named("GLY", 1, "CA", 0), named("GLY", 1, "C", 1.5)};
    atoms[0].radius = 1.9;
    EXPECT_EQ(structure_of_atoms(atoms, "Elsewhere").structure.radii_set, "united");
    atoms[1].radius = 1.8;
    const Structure made = structure_of_atoms(atoms, "Elsewhere").structure;
    EXPECT_EQ(made.radii_set, "file");
    EXPECT_EQ(made.atoms.radii, (std::vector<double>{1.9, 1.8}));
}

TEST(StructureOfAtoms, NamesTheProgramInMessages) {
    EXPECT_THROW(structure_of_atoms({}, "Elsewhere"), InputError);
    const std::vector<NamedAtom> atoms{named("HOH", 2, "O", 4)};
    try {
        structure_of_atoms(atoms, "Elsewhere");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(std::string(error.what()).substr(0, 25), "Elsewhere: no atoms left:");
    }
}

TEST(ParseStructure, IsReadStructure) {
    const std::string atom = "ATOM      1  CA  GLY A   1       1.000   2.000   3.000  1.00  0.00           C\n";
    const Structure named_file = parse_structure(atom, "dir/a.pdb");
    EXPECT_EQ(named_file.name, "a");
    EXPECT_EQ(named_file.file, "dir/a.pdb");
    EXPECT_EQ(named_file.sha256.size(), 64U);
    EXPECT_EQ(parse_structure("1 2 3 1.5\n", "<data>").atoms.radii.front(), 1.5);
    EXPECT_EQ(parse_structure(atom, "<data>").name, "structure");
    EXPECT_EQ(parse_all_models("MODEL 1\n" + atom + "ENDMDL\nMODEL 2\n" + atom + "ENDMDL\n", "<data>").size(), 2U);
    EXPECT_THROW(parse_structure("", "<data>"), InputError);
    EXPECT_THROW(parse_structure("hello\n", "<data>"), InputError);
    EXPECT_THROW(parse_structure(atom, "a.cif"), InputError);
}

}  // namespace
}  // namespace meniscus
