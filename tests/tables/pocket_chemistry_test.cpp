// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/pocket_chemistry.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "meniscus/describe_pockets.h"

namespace meniscus::testing {
namespace {

struct NamedAtom {
    std::string residue;
    std::string name;
    std::string element;
};

// Each atom in a residue of its own.
Structure structure_of(const std::vector<NamedAtom>& atoms) {
    Structure structure;
    for (const NamedAtom& atom : atoms) {
        AtomLabel label;
        label.residue = static_cast<std::uint32_t>(structure.residues.size());
        label.name = atom.name;
        label.element = atom.element;
        structure.residues.push_back({"A", atom.residue, static_cast<int>(structure.residues.size()) + 1, ' '});
        structure.labels.push_back(label);
        structure.atoms.centres.push_back({5.0 * static_cast<double>(structure.residues.size()), 0.0, 0.0});
        structure.atoms.radii.push_back(1.7);
    }
    return structure;
}

TEST(PocketChemistry, ClassesOfAtoms) {
    const Structure structure = structure_of({{"ALA", "CA", "C"},
                                              {"ALA", "CB", "C"},
                                              {"TYR", "CZ", "C"},
                                              {"ARG", "CZ", "C"},
                                              {"ALA", "N", "N"},
                                              {"ASN", "ND2", "N"},
                                              {"LYS", "NZ", "N"},
                                              {"HIE", "NE2", "N"},
                                              {"ALA", "OXT", "O"},
                                              {"GLN", "OE1", "O"},
                                              {"SEP", "OG", "O"},
                                              {"GLU", "OE2", "O"},
                                              {"MSE", "SE", "SE"},
                                              {"HEM", "FE", "FE"},
                                              {"TRP", "NE1", "N"},
                                              {"HIS", "CD2", "C"}});
    using enum AtomClass;
    const std::vector<AtomClass> expected{BackboneCarbon,   AliphaticCarbon, AromaticCarbon,   PolarCarbon,
                                          BackboneNitrogen, AmideNitrogen,   CationicNitrogen, HistidineNitrogen,
                                          BackboneOxygen,   AmideOxygen,     HydroxylOxygen,   AnionicOxygen,
                                          Sulfur,           Other,           AmideNitrogen,    AromaticCarbon};
    EXPECT_EQ(atom_classes(structure), expected);
}

TEST(PocketChemistry, OfAWall) {
    const Structure structure = structure_of({{"ILE", "CD1", "C"},
                                              {"ARG", "NH1", "N"},
                                              {"ASP", "OD1", "O"},
                                              {"SER", "OG", "O"},
                                              {"PRO", "N", "N"},
                                              {"LYS", "NZ", "N"}});
    Pocket pocket;
    pocket.wall = {{0, 6.0}, {1, 2.0}, {2, 2.0}, {3, 1.5}, {4, 2.0}, {5, 0.5}};
    const PocketChemistry chemistry = describe_pocket(pocket, structure);
    EXPECT_EQ(chemistry.atoms, (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));  // the last one has too little
    EXPECT_EQ(chemistry.residues, chemistry.atoms);
    EXPECT_EQ(chemistry.charge, 0);
    EXPECT_EQ(chemistry.donors, 2u);     // ARG, SER; not proline's nitrogen
    EXPECT_EQ(chemistry.acceptors, 2u);  // ASP, SER
    const double sum = 6.0 * 4.5 - 2.0 * 4.5 - 2.0 * 3.5 - 1.5 * 0.8 - 2.0 * 1.6 - 0.5 * 3.9;
    EXPECT_NEAR(chemistry.hydrophobicity, sum / 14.0, 1e-12);
}

TEST(PocketChemistry, TableHasARowPerPocket) {
    const Structure structure = structure_of({{"SER", "OG", "O"}});
    Pockets pockets;
    Pocket& pocket = pockets.pockets.emplace_back();
    pocket.rank = 1;
    pocket.volume = 12.5;
    pocket.wall = {{0, 2.0}};
    pocket.mouths = {{3.0, 1.0, {}}, {1.5, 0.5, {}}};
    const Table table = pockets_table(describe_pockets(pockets, structure));
    ASSERT_EQ(table.rows.size(), 1u);
    ASSERT_EQ(table.rows[0].size(), table.columns.size());
    const auto cell = [&](const std::string& name) {
        for (std::size_t i = 0; i < table.columns.size(); ++i)
            if (table.columns[i] == name) return table.rows[0][i];
        return Cell{};
    };
    EXPECT_EQ(cell("volume"), Cell(12.5));
    EXPECT_EQ(cell("mouths"), Cell(std::int64_t{2}));
    EXPECT_EQ(cell("mouth_area"), Cell(4.5));
    EXPECT_EQ(cell("residues"), Cell(std::string("A:SER 1")));
}

}  // namespace
}  // namespace meniscus::testing
