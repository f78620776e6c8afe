// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/residue_kinds.h"

#include "fragments.h"

namespace meniscus::reading {
namespace {

using meniscus::testing::add_residue;

std::vector<ResidueKind> kinds_of(RawModel model) {
    classify_residues(model);
    std::vector<ResidueKind> kinds;
    for (const RawResidue& residue : model.residues) kinds.push_back(residue.kind);
    return kinds;
}

using enum ResidueKind;

TEST(ResidueKinds, WaterIsKnownByNameWhateverTheRecord) {
    RawModel model;
    add_residue(model, "TIP3", 1, {"O", "H", "H"});
    add_residue(model, "HOH", 2, {"O"}, true);
    EXPECT_EQ(kinds_of(model), (std::vector{Water, Water}));
}

TEST(ResidueKinds, HeteroGroupsOfOneAtomAreIons) {
    RawModel model;
    add_residue(model, "ALA", 1, {"N", "C"});
    add_residue(model, "ZN", 2, {"ZN"}, true);
    add_residue(model, "SO4", 3, {"S", "O"}, true);
    add_residue(model, "MG", 4, {"MG", "MG"}, true);
    model.atoms[5].altloc = 'A';
    model.atoms[6].altloc = 'B';
    EXPECT_EQ(kinds_of(model), (std::vector{Polymer, Ion, Ligand, Ion}));
}

TEST(ResidueKinds, AHetatmResidueLinkedByAPeptideBondIsPolymer) {
    RawModel model;
    add_residue(model, "ALA", 1, {"N", "C"});
    add_residue(model, "MSE", 2, {"N", "C", "SE"}, true);
    add_residue(model, "MSE", 3, {"N", "C"}, true);
    model.atoms[2].centre = model.atoms[1].centre + Vec3{1.33, 0, 0};
    EXPECT_EQ(kinds_of(model), (std::vector{Polymer, Polymer, Ligand})) << "the third is not linked";
    model.atoms[5].centre = model.atoms[3].centre + Vec3{0, 1.33, 0};
    EXPECT_EQ(kinds_of(model), (std::vector{Polymer, Polymer, Polymer})) << "linked through the second";
}

TEST(ResidueKinds, LinksAreFoundFromTheFarEndToo) {
    RawModel model;
    add_residue(model, "ACE", 1, {"C", "O"}, true);
    add_residue(model, "DPN", 2, {"N", "C"}, true);
    add_residue(model, "ALA", 3, {"N", "C"});
    model.atoms[2].centre = model.atoms[0].centre + Vec3{1.33, 0, 0};
    model.atoms[4].centre = model.atoms[3].centre + Vec3{1.33, 0, 0};
    EXPECT_EQ(kinds_of(model), (std::vector{Polymer, Polymer, Polymer}));
}

TEST(ResidueKinds, ASugarOnASideChainIsNoPolymer) {
    RawModel model;
    add_residue(model, "ASN", 1, {"N", "C", "N"});
    model.atoms[2].name = "ND2";
    add_residue(model, "NAG", 2, {"C"}, true);
    add_residue(model, "NAG", 3, {"C", "O"}, true);
    model.atoms[3].centre = model.atoms[2].centre + Vec3{1.45, 0, 0};
    EXPECT_EQ(kinds_of(model)[1], Ion);
    EXPECT_EQ(kinds_of(model)[2], Ligand);
}

TEST(ResidueKinds, OtherChainsDoNotLink) {
    RawModel model;
    add_residue(model, "ALA", 1, {"N", "C"});
    add_residue(model, "MSE", 2, {"N", "C"}, true);
    model.atoms[2].centre = model.atoms[1].centre + Vec3{1.33, 0, 0};
    model.residues[1].chain = "B";
    EXPECT_EQ(kinds_of(model)[1], Ligand);
}

TEST(ResidueKinds, PhosphodiesterBondsLinkNucleotides) {
    RawModel model;
    add_residue(model, "G", 1, {"P", "O"});
    model.atoms[1].name = "O3'";
    add_residue(model, "5MC", 2, {"P", "O"}, true);
    model.atoms[2].centre = model.atoms[1].centre + Vec3{1.6, 0, 0};
    EXPECT_EQ(kinds_of(model), (std::vector{Polymer, Polymer}));
}

TEST(ResidueKinds, NeighboursInNumberLinkAcrossTheFile) {
    RawModel model;
    add_residue(model, "ALA", 1, {"N", "C"});
    for (int i = 0; i < 5; ++i) add_residue(model, "ALA", 10 + i, {"N", "C"});
    add_residue(model, "MSE", 2, {"N", "C"}, true);
    model.atoms[12].centre = model.atoms[1].centre + Vec3{1.33, 0, 0};
    EXPECT_EQ(kinds_of(model).back(), Polymer);
}

TEST(ResidueKinds, WhatTheFileListsInASequenceIsPolymer) {
    RawModel model;
    add_residue(model, "CRO", 66, {"N", "C"}, true);
    model.residues[0].in_sequence = true;
    EXPECT_EQ(kinds_of(model), (std::vector{Polymer}));
}

}  // namespace
}  // namespace meniscus::reading
