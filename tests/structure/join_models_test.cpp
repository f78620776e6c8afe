// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/join_models.h"

#include "fragments.h"

namespace meniscus {
namespace {

using reading::describe;
using reading::find_partners;
using reading::join_models;
using reading::RawModel;
using testing::add_residue;
using testing::error_of;
using testing::expect_contains;
using testing::gzipped;
using testing::has_note;
using testing::has_warning;
using testing::pdb_line;
using testing::read_text;

RawModel model_of(const std::vector<std::string>& chains) {
    RawModel model;
    for (const std::string& chain : chains) model.residues[add_residue(model, "ALA", 1, {"CA"})].chain = chain;
    return model;
}

std::vector<std::string> chains_of(const RawModel& model) {
    std::vector<std::string> chains;
    for (const reading::RawAtom& atom : model.atoms) chains.push_back(model.residue_of(atom).chain);
    return chains;
}

using Chains = std::vector<std::string>;

TEST(JoinModels, CopiesOfAChainAreNumbered) {
    EXPECT_EQ(chains_of(join_models({model_of({"A", "B"}), model_of({"B"}), model_of({"A", "B"})}, "f")),
              (Chains{"A", "B", "B-2", "A-2", "B-3"}));
    EXPECT_EQ(chains_of(join_models({model_of({""}), model_of({""})}, "f")), (Chains{"", "-2"}));
}

TEST(JoinModels, NamesOfTheFileAreNotTakenTwice) {
    EXPECT_EQ(chains_of(join_models({model_of({"A", "A-2"}), model_of({"A", "A-2"})}, "f")),
              (Chains{"A", "A-2", "A-3", "A-2-2"}));
}

TEST(JoinModels, PartnersAreToldWithWhereTheyAre) {
    EXPECT_EQ(describe({{"A"}, {"B"}, {}, 69}), "chain A taken, before END in line 69; chain B follows it");
    EXPECT_EQ(describe({{"H", "L"}, {"", "C"}, {}, 9}),
              "chains H, L taken, before END in line 9; chains (blank), C follow it");
    EXPECT_EQ(describe({{"A"}, {"C"}, {"A"}, 9}),
              "chain A taken, before END in line 9; chain C and another chain A follow it");
    EXPECT_EQ(describe({{"A"}, {"B"}, {}, 0}), "chain A taken, of model 1; chain B is only in others");
}

TEST(JoinModels, PartnersAreChainsThatTheFirstModelLacks) {
    EXPECT_EQ(find_partners({{"A"}, {"A", "B"}, {"C"}}).others, (std::set<std::string>{"B", "C"}));
    EXPECT_FALSE(find_partners({{"A", "B"}, {"A"}}).exist());
}

TEST(JoinModels, AnEnsembleIsNoUnit) {
    const auto warnings = [](double shift) {
        RawModel moved = model_of({"A"});
        moved.atoms[0].centre.x += shift;
        return join_models({model_of({"A"}), moved}, "f").warnings.size();
    };
    EXPECT_EQ(warnings(1.0), 1U);
    EXPECT_EQ(warnings(20.0), 0U);
}

const std::string kReceptor = pdb_line({.name = " N  "}) + pdb_line({.name = " CA ", .x = 1.5});
const std::string kLigand = pdb_line({.name = " N  ", .y = 5.0, .chain = 'B'});

TEST(JoinModels, ChainsBehindEndAreAWarning) {
    const std::string text = kReceptor + "END\n" + kLigand + "END\n";
    const Structure first = read_text(text, "c.pdb");
    EXPECT_EQ(first.atoms.size(), 2U);
    EXPECT_EQ(first.warnings, (Chains{"chain A taken, before END in line 3; chain B follows it (take all with model = "
                                      "join)"}));
    EXPECT_TRUE(first.notes.size() == 1 && has_note(first, "elements taken from atom names"));
    const Structure all = read_text(text, "c.pdb", {.join_models = true});
    EXPECT_EQ(all.atoms.size(), 3U);
    EXPECT_TRUE(all.warnings.empty());
    EXPECT_TRUE(has_note(all, "2 models put together"));
    EXPECT_EQ(all.residues.at(1).chain, "B");
    EXPECT_TRUE(read_text(text, "c.pdb", {.model = 2}).warnings.empty());
}

TEST(JoinModels, BothPartnersMayHaveTheSameName) {
    const std::string other = pdb_line({.name = " N  ", .residue = "TRP", .number = 7, .y = 9.0});
    const std::string text = kReceptor + "END\n" + other + "END\n";
    EXPECT_TRUE(has_warning(read_text(text, "d.pdb"),
                            "chain A taken, before END in line 3; another chain A follows it (take all"));
    EXPECT_EQ(read_text(text, "d.pdb", {.join_models = true}).residues.at(1).chain, "A-2");
    EXPECT_TRUE(read_text(kReceptor + "END\n" + kReceptor + "END\n", "t.pdb").warnings.empty());
}

TEST(JoinModels, TheOtherSubunitOfAHomodimerIsAPartner) {
    const auto subunit = [](double shift, char chain) {
        return pdb_line({.name = " N  ", .x = shift, .chain = chain}) +
               pdb_line({.name = " CA ", .x = shift + 1.5, .chain = chain}) +
               pdb_line({.name = " C  ", .x = shift + 2.5, .chain = chain});
    };
    const std::string end = "END\n";
    EXPECT_TRUE(has_warning(read_text(subunit(0, 'A') + end + subunit(30, 'A') + end, "d.pdb"),
                            "chain A taken, before END in line 4; another chain A follows it (take all"));
    EXPECT_TRUE(has_warning(read_text(subunit(0, ' ') + end + subunit(30, ' '), "d.pdb"), "another chain (blank)"));
    const std::string shorter = pdb_line({.name = " CA ", .x = 30.0}) + pdb_line({.name = " C  ", .x = 31.5});
    EXPECT_TRUE(has_warning(read_text(subunit(0, 'A') + end + shorter, "d.pdb"), "another chain A follows it"));
    EXPECT_TRUE(read_text(subunit(0, 'A') + end + subunit(2, 'A') + end, "frames.pdb").warnings.empty());
    const std::string frames = subunit(0, 'A') + end + subunit(30, 'A') + end + subunit(60, 'A') + end;
    EXPECT_TRUE(read_text(frames, "frames.pdb").warnings.empty());
}

TEST(JoinModels, AnEmptyModelNamesAnother) {
    const std::string text = "MODEL 1\nENDMDL\nMODEL 2\n" + kReceptor + "ENDMDL\n";
    EXPECT_EQ(error_of(text, "e.pdb"), "e.pdb: model 1 has no atoms; take another with model = 2");
    EXPECT_EQ(read_text(text, "e.pdb", {.model = 2}).atoms.size(), 2U);
    EXPECT_EQ(read_text(text, "e.pdb", {.join_models = true}).atoms.size(), 2U);
    expect_contains(error_of("MODEL 1\nENDMDL\nMODEL 2\nENDMDL\n", "e.pdb"), "no atoms in this file");
}

TEST(JoinModels, OneCopyOfABiologicalUnitIsAWarning) {
    const std::string moved = pdb_line({.name = " N  ", .x = 30.0}) + pdb_line({.name = " CA ", .x = 31.5});
    const std::string text = "MODEL 1\n" + kReceptor + "ENDMDL\nMODEL 2\n" + moved + "ENDMDL\n";
    const Structure first = read_text(text, "b.pdb1");
    EXPECT_EQ(first.name, "b");
    EXPECT_TRUE(has_warning(first, "model 1 of 2 taken, a part of the biological unit"));
    EXPECT_TRUE(read_text(text, "b.pdb").warnings.empty());
    EXPECT_TRUE(has_note(read_text(text, "b.pdb"), "model 1 of 2 taken"));
    const std::string ensemble = "MODEL 1\n" + kReceptor + "ENDMDL\nMODEL 2\n" + kReceptor + "ENDMDL\n";
    EXPECT_TRUE(read_text(ensemble, "b.pdb1").warnings.empty());
    const Structure both = read_text(gzipped(text), "b.pdb1.gz", {.join_models = true});
    EXPECT_EQ(both.atoms.size(), 4U);
    EXPECT_EQ(both.residues.at(1).chain, "A-2");
    EXPECT_EQ(read_text(text, "b.pdb1", {.join_models = true, .chains = {"A-2"}}).atoms.size(), 2U);
}

TEST(JoinModels, CopiesOfABiologicalUnitMayHaveDifferentSizes) {
    const std::string text = "MODEL 1\n" + kReceptor + "ENDMDL\nMODEL 2\n" + pdb_line({.x = 30.0}) + "ENDMDL\n";
    EXPECT_FALSE(has_warning(read_text(text, "b.pdb1"), "different number of atoms"));
    EXPECT_TRUE(has_warning(read_text(text, "b.pdb"), "different number of atoms"));
}

TEST(JoinModels, AChainThatOnlyFollowsIsNamedWhereItIsMissing) {
    expect_contains(error_of(kReceptor + "END\n" + kLigand + "END\n", "c.pdb", {.chains = {"B"}}),
                    "no chain B; chains of the file: A (chain A taken, before END in line 3; chain B follows it");
}

TEST(JoinModels, DifferentSizesMatterToCopiesOnly) {
    const std::string text = "MODEL 1\n" + kReceptor + "ENDMDL\nMODEL 2\n" + pdb_line({.name = " N  "}) + "ENDMDL\n";
    EXPECT_TRUE(has_warning(read_text(text, "m.pdb"), "different number of atoms"));
    EXPECT_FALSE(has_warning(read_text(text, "m.pdb", {.join_models = true}), "different number of atoms"));
}

TEST(JoinModels, DifferentSizesAreToldInAllFormats) {
    const auto warning = [](const std::string& text, const std::string& name) {
        for (const std::string& line : read_text(text, name, {.hetero = HeteroPolicy::All}).warnings)
            if (line.find("different number of atoms") != std::string::npos) return line;
        return std::string();
    };
    const std::string different = ": this model has a different number of atoms from the first";
    const std::string atom = pdb_line({});
    const std::string twice = "MODEL 2\n" + atom + atom + "ENDMDL\n";
    EXPECT_EQ(warning("MODEL 1\n" + atom + "ENDMDL\n" + twice + twice, "m.pdb"), "line 4" + different + " (2 times)");
    const std::string pqr = "ATOM 1 CA ALA 1 0 0 0 0 1\n";
    EXPECT_EQ(warning("MODEL 1\n" + pqr + "ENDMDL\nMODEL 2\n" + pqr + pqr + "ENDMDL\n", "m.pqr"), "line 4" + different);
    const std::string gro = "    1ALA     CA    1   0.126  -1.624   1.679\n";
    EXPECT_EQ(warning("t\n1\n" + gro + " 1 1 1\nt\n2\n" + gro + gro + " 1 1 1\n", "m.gro"), "line 7" + different);
    EXPECT_EQ(warning("t\n1\n" + gro + " 1 1 1\nt\n1\n" + gro + " 1 1 1\n", "m.gro"), "");
    const std::string cif =
        "data_x\nloop_\n_atom_site.pdbx_PDB_model_num\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n"
        "_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n1 CA ALA 0 0 0\n2 CA ALA 0 0 0\n";
    EXPECT_EQ(warning(cif, "m.cif"), "");
    EXPECT_EQ(warning(cif + "2 C ALA 0 0 2\n", "m.cif"), "line 10" + different);
}

TEST(JoinModels, OneModelIsTakenAsItIs) {
    const Structure s = read_text(kReceptor, "o.pdb", {.join_models = true});
    EXPECT_EQ(s.atoms.size(), 2U);
    EXPECT_FALSE(has_note(s, "put together"));
    EXPECT_EQ(read_text("0 0 0 1\n", "o.xyzr", {.join_models = true}).atoms.size(), 1U);
}

TEST(JoinModels, ModelsOfMmcif) {
    const std::string head =
        "data_m\nloop_\n_atom_site.pdbx_PDB_model_num\n_atom_site.auth_asym_id\n_atom_site.label_atom_id\n"
        "_atom_site.label_comp_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n_atom_site.Cartn_z\n";
    const std::string copies = head + "1 A CA ALA 0 0 0\n2 A CA ALA 5 0 0\n";
    EXPECT_TRUE(has_note(read_text(copies, "m.cif"), "model 1 of 2 taken"));
    const Structure both = read_text(copies, "m.cif", {.join_models = true});
    ASSERT_EQ(both.residues.size(), 2U);
    EXPECT_EQ(both.residues[1].chain, "A-2");
    EXPECT_TRUE(has_warning(read_text(head + "1 A CA ALA 0 0 0\n2 B CA ALA 5 0 0\n", "m.cif"),
                            "chain A taken, of model 1; chain B is only in others (take all with"));
}

TEST(JoinModels, AnAssemblyIsSomethingElse) {
    expect_contains(error_of<UsageError>(kReceptor, "a.pdb", {.join_models = true, .assembly = "1"}),
                    "model = join: the models of a file are not to be copied by assembly;");
}

}  // namespace
}  // namespace meniscus
