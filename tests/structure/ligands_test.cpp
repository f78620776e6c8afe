// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/ligands.h"

#include <cmath>
#include <numbers>

#include "fragments.h"
#include "structure/additives.h"

namespace meniscus::reading {
namespace {

using meniscus::testing::Line;
using meniscus::testing::pdb_line;
using meniscus::testing::read_text;

using Bonds = std::vector<std::array<std::uint32_t, 2>>;
using Counts = std::map<std::string, std::size_t>;

Ligands atoms_of(const std::vector<std::pair<std::string, Vec3>>& atoms) {
    Ligands ligands;
    ligands.residues.resize(1);
    for (const auto& [element, centre] : atoms) {
        ligands.centres.push_back(centre);
        ligands.labels.push_back({.residue = 0, .name = element, .element = element});
    }
    return ligands;
}

TEST(Bonds, ABenzeneRingHasTwelve) {
    std::vector<std::pair<std::string, Vec3>> atoms;
    for (const auto& [element, radius] : {std::pair<const char*, double>{"C", 1.395}, {"H", 2.48}})
        for (int i = 0; i < 6; ++i) {
            const double turn = i * std::numbers::pi / 3.0;
            atoms.push_back({element, radius * Vec3{std::cos(turn), std::sin(turn), 0.0}});
        }
    EXPECT_EQ(
        find_bonds(atoms_of(atoms)),
        (Bonds{{0, 1}, {0, 5}, {0, 6}, {1, 2}, {1, 7}, {2, 3}, {2, 8}, {3, 4}, {3, 9}, {4, 5}, {4, 10}, {5, 11}}));
}

TEST(Bonds, AreAsLongAsTheElementsAre) {
    const auto is_bond = [](const std::string& a, const std::string& b, double length) {
        return !find_bonds(atoms_of({{a, {}}, {b, {0.0, length, 0.0}}})).empty();
    };
    EXPECT_TRUE(is_bond("C", "C", 1.54));
    EXPECT_FALSE(is_bond("C", "C", 2.5)) << "neighbours of a neighbour";
    EXPECT_FALSE(is_bond("C", "C", 0.1)) << "alternatives of one atom";
    EXPECT_TRUE(is_bond("C", "I", 2.1));
    EXPECT_TRUE(is_bond("FE", "N", 2.05)) << "haem";
    EXPECT_TRUE(is_bond("FE", "S", 2.3)) << "a cluster of iron and sulphur";
    EXPECT_FALSE(is_bond("FE", "FE", 2.7)) << "two metals of that cluster";
    EXPECT_FALSE(is_bond("H", "H", 0.74));
}

TEST(Additives, CrystalsAreGrownFromThemLigandsAreNot) {
    for (const char* name : {"GOL", "EDO", "SO4", "PO4", "PEG", "MES", "DMS", "ACT", "TRS", "POPC"})
        EXPECT_TRUE(is_additive(name)) << name;
    for (const char* name : {"HEM", "ATP", "NAD", "HEP", "STI", "NAG", "BTN", "RET", "LIG", "UNL", ""})
        EXPECT_FALSE(is_additive(name)) << name;
}

class LigandsOfFiles : public ::testing::Test {
protected:
    static std::string pair_of(const std::string& residue, char chain, double x) {
        const int number = static_cast<int>(x);
        return pdb_line({" C1 ", residue, number, x, 0.0, 0.0, "HETATM", chain, ' ', ' ', 1, 1.0, " C"}) +
               pdb_line({" O1 ", residue, number, x + 1.4, 0.0, 0.0, "HETATM", chain, ' ', ' ', 2, 1.0, " O"});
    }
    static std::string polymer(char chain, double x) {
        return pdb_line({" CA ", "ALA", 1, x, 5.0, 0.0, "ATOM", chain, ' ', ' ', 1, 1.0, " C"});
    }

    const std::string two_chains = polymer('A', 0) + polymer('B', 50) + pair_of("LIG", 'A', 3) +
                                   pair_of("LIG", 'B', 53) + pair_of("NAD", 'B', 60) + pair_of("EDO", 'A', 20) +
                                   pdb_line({"ZN  ", "ZN", 90, 30, 0, 0, "HETATM", 'A', ' ', ' ', 1, 1.0, "ZN"}) +
                                   pdb_line({" O  ", "HOH", 91, 40, 0, 0, "HETATM", 'A', ' ', ' ', 1, 1.0, " O"});
};

TEST_F(LigandsOfFiles, AreThereWithoutWatersIonsAndAdditives) {
    const Structure s = read_text(two_chains, "a.pdb");
    EXPECT_EQ(s.atoms.size(), 2U);
    EXPECT_EQ(count_ligands(s.ligands), (Counts{{"LIG", 2}, {"NAD", 1}}));
    EXPECT_EQ(s.ligands.bonds, (Bonds{{0, 1}, {2, 3}, {4, 5}}));
    EXPECT_FALSE(s.ligands.in_surface);
    EXPECT_EQ(s.ligands.residues[2].chain, "B");
    EXPECT_EQ(s.ligands.centres[3].x, 54.4);
}

TEST_F(LigandsOfFiles, BelongToTheSurfaceIfKept) {
    for (const HeteroPolicy hetero : {HeteroPolicy::Ligands, HeteroPolicy::All}) {
        const Structure s = read_text(two_chains, "a.pdb", {.hetero = hetero});
        EXPECT_TRUE(s.ligands.in_surface);
        EXPECT_EQ(count_ligands(s.ligands), (Counts{{"LIG", 2}, {"NAD", 1}}));
    }
}

TEST_F(LigandsOfFiles, AreThoseOfTheChosenChains) {
    EXPECT_EQ(count_ligands(read_text(two_chains, "a.pdb", {.chains = {"A"}}).ligands), (Counts{{"LIG", 1}}));
    const std::vector<Structure> chains = split_chains(read_text(two_chains, "a.pdb"));
    ASSERT_EQ(chains.size(), 2U);
    EXPECT_EQ(count_ligands(chains[0].ligands), (Counts{{"LIG", 1}}));
    EXPECT_EQ(count_ligands(chains[1].ligands), (Counts{{"LIG", 1}, {"NAD", 1}}));
    EXPECT_EQ(chains[1].ligands.bonds, (Bonds{{0, 1}, {2, 3}}));
    EXPECT_EQ(chains[1].ligands.labels[3].residue, 1U);
}

TEST_F(LigandsOfFiles, AMoleculeAloneIsNoLigand) {
    EXPECT_TRUE(read_text(pair_of("LIG", 'A', 3), "a.pdb").ligands.centres.empty());
}

}  // namespace
}  // namespace meniscus::reading
