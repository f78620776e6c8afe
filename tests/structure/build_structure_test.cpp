// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/build_structure.h"

#include "fragments.h"

namespace meniscus::reading {
namespace {

using meniscus::testing::add_residue;
using meniscus::testing::all_atoms;
using meniscus::testing::expect_contains;

RawOperator shift(double x) {
    RawOperator op;
    op.rows[3] = x;
    return op;
}

// Chain A with a ligand of its own label name, chain B.
RawModel two_chains() {
    RawModel model;
    add_residue(model, "ALA", 1, {"C", "N"});
    add_residue(model, "HEM", 1, {"FE"});
    add_residue(model, "GLY", 1, {"C"});
    model.residues[0].label_chain = "A";
    model.residues[1].label_chain = "C";
    model.residues[2].chain = model.residues[2].label_chain = "B";
    RawAssembly& twice = model.assemblies.emplace_back();
    twice.name = "1";
    twice.generators = {{{"A"}, true, {shift(0), shift(100)}}, {{"C"}, true, {shift(0), shift(100)}}};
    model.assemblies.emplace_back().name = "broken";
    model.assemblies.back().generators.emplace_back().chains = {"A"};
    return model;
}

Structure build(const RawModel& model, const std::string& assembly) {
    Chosen chosen;
    chosen.atoms = all_atoms(model);
    const AssignedRadii radii{"bondi", std::vector<double>(chosen.atoms.size(), 1.5)};
    Structure structure;
    structure.file = "f";
    build_structure(model, chosen, radii, assembly, structure);
    return structure;
}

TEST(BuildStructure, AsDepositedWithoutAnAssembly) {
    const Structure s = build(two_chains(), "");
    ASSERT_EQ(s.atoms.size(), 4U);
    EXPECT_EQ(s.labels.size(), 4U);
    ASSERT_EQ(s.residues.size(), 3U);
    EXPECT_EQ(s.labels[3].residue, 2U);
    EXPECT_EQ(s.residues[2].chain, "B");
}

TEST(BuildStructure, CopiesOfAChainAreNumbered) {
    const Structure s = build(two_chains(), "1");
    ASSERT_EQ(s.atoms.size(), 6U);
    EXPECT_EQ(s.residues[s.labels[0].residue].chain, "A");
    EXPECT_EQ(s.residues[s.labels[2].residue].chain, "A-2");
    EXPECT_EQ(s.residues[s.labels[4].residue].chain, "A") << "the haem moves with its chain";
    EXPECT_EQ(s.residues[s.labels[5].residue].chain, "A-2");
    EXPECT_EQ(s.atoms.centres[2].x, s.atoms.centres[0].x + 100.0);
    EXPECT_EQ(s.atoms.centres[0].x, 10.0) << "the identity changes no bit";
    EXPECT_EQ(s.dropped.at("assembly"), 1U);
}

TEST(BuildStructure, AnUnknownAssemblyIsAnErrorThatListsThem) {
    try {
        build(two_chains(), "7");
        FAIL();
    } catch (const InputError& error) {
        expect_contains(error.what(), "no assembly 7; assemblies of the file: 1 broken");
    }
    EXPECT_THROW(build(two_chains(), "broken"), InputError);
}

}  // namespace
}  // namespace meniscus::reading
