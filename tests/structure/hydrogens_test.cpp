// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/hydrogens.h"

#include "fragments.h"

namespace meniscus::reading {
namespace {

using meniscus::testing::add_residue;
using meniscus::testing::all_atoms;

TEST(Hydrogens, AProteinNeedsSevenForTenHeavyAtoms) {
    RawModel model;
    add_residue(model, "ALA", 1, {"C", "C", "C", "C", "C", "N", "N", "N", "O", "O", "H", "H", "H", "H", "H", "H", "H"});
    EXPECT_TRUE(count_hydrogens(model, all_atoms(model)).is_complete());
    model.atoms.pop_back();
    EXPECT_FALSE(count_hydrogens(model, all_atoms(model)).is_complete());
}

TEST(Hydrogens, ANucleicAcidNeedsThreeForTen) {
    RawModel model;
    add_residue(model, "DA", 1, {"C", "C", "C", "C", "C", "N", "N", "N", "O", "O", "H", "D", "H"});
    EXPECT_TRUE(count_hydrogens(model, all_atoms(model)).is_complete());
    model.atoms.pop_back();
    EXPECT_FALSE(count_hydrogens(model, all_atoms(model)).is_complete());
}

TEST(Hydrogens, ThoseOfLigandsAndWatersDoNotCountBesideAPolymer) {
    RawModel model;
    add_residue(model, "ALA", 1, {"C", "N"});
    add_residue(model, "HOH", 2, {"O", "H", "H"});
    model.residues[1].kind = ResidueKind::Water;
    const HydrogenCount count = count_hydrogens(model, all_atoms(model));
    EXPECT_EQ(count.all, 2U);
    EXPECT_EQ(count.in_polymer, 0U);
    EXPECT_FALSE(count.is_complete());
}

TEST(Hydrogens, WithoutAPolymerEverythingCounts) {
    RawModel model;
    add_residue(model, "HOH", 1, {"O", "H", "H"});
    model.residues[0].kind = ResidueKind::Water;
    EXPECT_TRUE(count_hydrogens(model, all_atoms(model)).is_complete());
}

TEST(Hydrogens, NoneAreNeverComplete) {
    RawModel model;
    EXPECT_FALSE(count_hydrogens(model, {}).is_complete());
    add_residue(model, "ALA", 1, {"C"});
    EXPECT_FALSE(count_hydrogens(model, all_atoms(model)).is_complete());
}

}  // namespace
}  // namespace meniscus::reading
