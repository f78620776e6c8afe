// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "meniscus/errors.h"
#include "meniscus/tables.h"
#include "small_complex.h"

namespace meniscus {
namespace {

using testing::small_complex;

void expect_sums_to_totals(const std::vector<GroupMeasure>& groups, const Measures& measures) {
    GroupMeasure sum;
    for (const GroupMeasure& g : groups) {
        sum.atoms += g.atoms;
        sum.sas_area += g.sas_area;
        sum.contact_area += g.contact_area;
        sum.toroidal_area += g.toroidal_area;
        sum.reentrant_area += g.reentrant_area;
    }
    const SurfaceTotals& t = measures.totals;
    EXPECT_EQ(sum.atoms, measures.atoms.size());
    EXPECT_NEAR(sum.sas_area, t.sas_area, 1e-11 * t.sas_area);
    EXPECT_NEAR(sum.ses_area(), t.ses_area, 1e-11 * t.ses_area);
    EXPECT_NEAR(sum.contact_area, t.contact_area, 1e-11 * t.ses_area);
    EXPECT_NEAR(sum.toroidal_area, t.toroidal_area, 1e-11 * t.ses_area);
    EXPECT_NEAR(sum.reentrant_area, t.reentrant_area, 1e-11 * t.ses_area);
}

TEST(GroupMeasures, ResiduesAndChainsSumToTheTotals) {
    const Structure s = small_complex();
    const Measures measures = measure(s.atoms);
    const auto residues = residue_measures(s, measures);
    const auto chains = chain_measures(s, measures);
    ASSERT_EQ(residues.size(), 4u);
    ASSERT_EQ(chains.size(), 3u);
    expect_sums_to_totals(residues, measures);
    expect_sums_to_totals(chains, measures);
    EXPECT_EQ(residues[1].atoms, 2u);
}

TEST(GroupMeasures, DepthIsMeanAndLargestOfTheAtoms) {
    const Structure s = small_complex();
    const Measures measures = measure(s.atoms, {.depth = true});
    const GroupMeasure residue = residue_measures(s, measures)[1];
    const auto [low, high] = std::minmax(measures.atoms[2].depth, measures.atoms[3].depth);
    EXPECT_DOUBLE_EQ(residue.max_depth, high);
    EXPECT_DOUBLE_EQ(residue.mean_depth, 0.5 * (low + high));
    EXPECT_NEAR(residue_measures(s, measures)[3].max_depth, 2.0, 1e-8);
}

TEST(GroupMeasures, BuriedMeansNoAccessibleArea) {
    Structure s = small_complex();
    s.labels[3].residue = 2;
    const Measures measures = measure(s.atoms);
    EXPECT_EQ(measures.atoms[3].sas_area, 0.0);
    EXPECT_FALSE(residue_measures(s, measures)[2].buried());
    s.residues.push_back({.chain = "C", .name = "ALA", .number = 1, .insertion_code = ' '});
    s.labels[3].residue = 4;
    EXPECT_TRUE(residue_measures(s, measures)[4].buried());
    EXPECT_TRUE(chain_measures(s, measures)[1].buried());  // C comes before B in the order of atoms
}

TEST(GroupMeasures, ChainsKeepTheOrderOfTheirFirstAtom) {
    Structure s = small_complex();
    s.labels[5].residue = 0;  // the far atom now belongs to chain A, whose other atoms come first
    const Chains chains = chains_of(s);
    EXPECT_EQ(chains.names, (std::vector<std::string>{"A", "B"}));
    EXPECT_EQ(chains.of_atom, (std::vector<std::uint32_t>{0, 0, 0, 0, 1, 0}));
}

TEST(GroupMeasures, RelativeAccessibilityKnowsProtonationStatesButNoOtherResidues) {
    EXPECT_DOUBLE_EQ(relative_accessibility("ALA", 64.5).value(), 0.5);
    EXPECT_DOUBLE_EQ(relative_accessibility("HIE", 224.0).value(), 1.0);
    EXPECT_DOUBLE_EQ(relative_accessibility("CYX", 0.0).value(), 0.0);
    EXPECT_FALSE(relative_accessibility("MSE", 100.0));
    EXPECT_FALSE(relative_accessibility("", 100.0));
}

TEST(GroupMeasures, ValuesPerAtom) {
    const Structure s = small_complex();
    const Measures measures = measure(s.atoms, {.depth = true});
    const auto sas = atom_values(s, measures, AtomValue::Sas);
    const auto ses = atom_values(s, measures, AtomValue::Ses);
    const auto rsa = atom_values(s, measures, AtomValue::Rsa);
    const auto depth = atom_values(s, measures, AtomValue::Depth);
    for (std::size_t i = 0; i < s.atoms.size(); ++i) {
        EXPECT_EQ(sas[i], measures.atoms[i].sas_area);
        EXPECT_EQ(ses[i], measures.atoms[i].ses_area());
        EXPECT_EQ(depth[i], measures.atoms[i].depth);
    }
    EXPECT_DOUBLE_EQ(rsa[0], (sas[0] + sas[1]) / 129.0);
    EXPECT_EQ(rsa[0], rsa[1]);
    EXPECT_EQ(rsa[2], -1.0);  // MSE
}

TEST(GroupMeasures, StructuresWithoutResiduesAreOneResidueAndOneChain) {
    Structure s = small_complex();
    s.residues.clear();
    const Measures measures = measure(s.atoms);
    expect_sums_to_totals(residue_measures(s, measures), measures);
    EXPECT_EQ(chains_of(s).names, (std::vector<std::string>{""}));
    EXPECT_EQ(atom_values(s, measures, AtomValue::Rsa)[0], -1.0);
}

TEST(GroupMeasures, MeasuresOfOtherAtomsAreRefused) {
    const Structure s = small_complex();
    Measures measures = measure(s.atoms);
    measures.atoms.pop_back();
    EXPECT_THROW(residue_measures(s, measures), UsageError);
    EXPECT_THROW(chain_measures(s, measures), UsageError);
    EXPECT_THROW(atom_values(s, measures, AtomValue::Sas), UsageError);
}

TEST(GroupMeasures, LiningResiduesAreThoseWithAnAtomThatTouches) {
    SurfaceComponent component;
    component.atoms = {4, 0, 1};
    EXPECT_EQ(lining_residues(small_complex(), component), (std::vector<std::uint32_t>{0, 2}));
}

}  // namespace
}  // namespace meniscus
