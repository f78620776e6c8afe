// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/choose_atoms.h"

#include "fragments.h"
#include "meniscus/list_of_counts.h"

namespace meniscus::reading {
namespace {

using meniscus::testing::add_residue;
using meniscus::testing::expect_contains;

RawModel mixed() {
    RawModel model;
    add_residue(model, "ALA", 1, {"N", "C"});
    add_residue(model, "HEM", 2, {"FE", "N", "C"}, true);
    add_residue(model, "HEM", 3, {"FE", "N", "C"}, true);
    add_residue(model, "ZN", 4, {"ZN"}, true);
    add_residue(model, "HOH", 5, {"O"}, true);
    model.residues[1].kind = model.residues[2].kind = ResidueKind::Ligand;
    model.residues[3].kind = ResidueKind::Ion;
    model.residues[4].kind = ResidueKind::Water;
    return model;
}

TEST(ChooseAtoms, DefaultsKeepThePolymerAndSayWhatWent) {
    const Chosen chosen = choose_atoms(mixed(), {}, "f");
    EXPECT_EQ(chosen.atoms, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(chosen.dropped.at("waters"), 1U);
    EXPECT_EQ(chosen.dropped.at("hetero"), 7U);
    const std::vector<std::string> expected{"1 water left out (keep it with keep_waters = true)",
                                            "2 HEM left out (keep them with hetero = ligands)",
                                            "1 ZN left out (keep it with hetero = all)"};
    EXPECT_EQ(chosen.notes, expected);
    EXPECT_TRUE(chosen.warnings.empty());
    EXPECT_EQ(chosen.ligands, (std::map<std::string, std::size_t>{{"HEM", 2}}));
}

TEST(ChooseAtoms, OptionsBringThemBack) {
    EXPECT_EQ(choose_atoms(mixed(), {.hetero = HeteroPolicy::Ligands}, "f").atoms.size(), 8U);
    EXPECT_EQ(choose_atoms(mixed(), {.hetero = HeteroPolicy::All}, "f").atoms.size(), 9U);
    const Chosen all = choose_atoms(mixed(), {.hetero = HeteroPolicy::All, .keep_waters = true}, "f");
    EXPECT_EQ(all.atoms.size(), 10U);
    EXPECT_TRUE(all.notes.empty());
    EXPECT_TRUE(all.warnings.empty());
    EXPECT_TRUE(all.ligands.empty());
    EXPECT_TRUE(all.dropped.empty());
}

TEST(ChooseAtoms, ChainsGoByAuthorOrLabelName) {
    RawModel model = mixed();
    model.residues[0].label_chain = "L";
    model.residues[1].chain = "B";
    model.residues[1].kind = ResidueKind::Polymer;
    EXPECT_EQ(choose_atoms(model, {.chains = {"B"}}, "f").atoms, (std::vector<std::uint32_t>{2, 3, 4}));
    EXPECT_EQ(choose_atoms(model, {.chains = {"label:L"}}, "f").atoms, (std::vector<std::uint32_t>{0, 1}));
    EXPECT_EQ(choose_atoms(model, {.chains = {"label:L", "B"}}, "f").atoms.size(), 5U);
    try {
        choose_atoms(model, {.chains = {"Q"}}, "f");
        FAIL();
    } catch (const InputError& error) {
        expect_contains(error.what(), "f: no chain Q; chains of the file: A B");
    }
}

TEST(ChooseAtoms, ChainsOfOtherModelsAreNamedWhereOneIsMissing) {
    RawModel model = mixed();
    model.left_out = "chain B follows it";
    try {
        choose_atoms(model, {.chains = {"B"}}, "f");
        FAIL();
    } catch (const InputError& error) {
        expect_contains(error.what(), "f: no chain B; chains of the file: A (chain B follows it)");
    }
}

TEST(ChooseAtoms, IonsInAtomRecordsAreKeptWithAWarning) {
    RawModel model;
    add_residue(model, "ALA", 1, {"N", "C"});
    add_residue(model, "NA", 2, {"NA"});
    add_residue(model, "NA", 3, {"NA"});
    add_residue(model, "CL", 4, {"CL"});
    add_residue(model, "ALA", 5, {"CA"});
    const Chosen chosen = choose_atoms(model, {}, "f");
    EXPECT_EQ(chosen.atoms.size(), 6U);
    EXPECT_EQ(chosen.warnings,
              std::vector<std::string>{"ions in ATOM records kept, as parts of the polymer: 2 NA, 1 CL "
                                       "(leave them out with select = (!CL,NA))"});
    EXPECT_TRUE(choose_atoms(model, {.select = "(!CL,NA)"}, "f").warnings.empty());
    for (reading::RawResidue& residue : model.residues) residue.in_sequence = true;
    EXPECT_TRUE(choose_atoms(model, {}, "f").warnings.empty()) << "SEQRES tells what the polymer is";
}

TEST(ChooseAtoms, ModelsWithTheirOwnRadiiKeepEveryAtom) {
    RawModel model = mixed();
    model.has_radii = true;
    const Chosen chosen = choose_atoms(model, {}, "f");
    EXPECT_EQ(chosen.atoms.size(), 10U);
    EXPECT_EQ(chosen.warnings,
              std::vector<std::string>{"1 water of the file kept as part of the molecule (leave it out "
                                       "with keep_waters = false, or keep it without this warning "
                                       "with keep_waters = true)"});
    EXPECT_EQ(choose_atoms(model, {.select = "(HEM)"}, "f").atoms.size(), 6U);
    EXPECT_TRUE(choose_atoms(model, {.select = "(HEM)"}, "f").warnings.empty());
}

TEST(ChooseAtoms, ModelsWithTheirOwnRadiiLoseWhatTheyAreToldToLose) {
    RawModel model = mixed();
    model.has_radii = true;
    EXPECT_EQ(choose_atoms(model, {.keep_waters = false}, "f").atoms.size(), 9U);
    EXPECT_EQ(choose_atoms(model, {.keep_waters = false}, "f").dropped.at("waters"), 1U);
    EXPECT_EQ(choose_atoms(model, {.keep_waters = true}, "f").atoms.size(), 10U);
    EXPECT_TRUE(choose_atoms(model, {.keep_waters = true}, "f").warnings.empty());
    EXPECT_EQ(choose_atoms(model, {.hetero = HeteroPolicy::None, .keep_waters = true}, "f").atoms.size(), 3U);
    EXPECT_EQ(choose_atoms(model, {.hetero = HeteroPolicy::Ligands, .keep_waters = true}, "f").atoms.size(), 9U);
    EXPECT_EQ(choose_atoms(model, {.hetero = HeteroPolicy::All, .keep_waters = true}, "f").atoms.size(), 10U);
}

TEST(ChooseAtoms, ANoteSaysHowASelectionWasUnderstood) {
    const auto notes_of = [](const std::string& select) {
        return choose_atoms(mixed(), {.select = select}, "f").notes;
    };
    expect_contains(notes_of("chain A").at(0), "select = chain A: understood as //A");
    expect_contains(notes_of("HEM").at(0), "select = HEM: understood as (HEM)");
    for (const std::string& note : notes_of("//A")) EXPECT_EQ(note.find("understood"), std::string::npos);
}

TEST(ChooseAtoms, AnAltlocThatIsNotThereIsAWarning) {
    const Chosen chosen = choose_atoms(mixed(), {.altloc = "B"}, "f");
    expect_contains(chosen.warnings.at(0), "no alternative location B");
}

TEST(ChooseAtoms, AtomsThatLackAnAltlocAreTold) {
    RawModel model;
    add_residue(model, "SER", 1, {"N", "C", "C", "O", "O"});
    for (const std::size_t atom : {1U, 3U}) model.atoms[atom].altloc = 'A';
    model.atoms[2].altloc = 'B';
    model.atoms[4].altloc = 'C';
    model.atoms[4].occupancy = 5.0;
    const Chosen best = choose_atoms(model, {}, "f");
    EXPECT_EQ(best.atoms, (std::vector<std::uint32_t>{0, 1, 4}));
    EXPECT_EQ(best.notes, (std::vector<std::string>{"2 atoms of alternative locations left out (choose one with altloc "
                                                    "= ID)",
                                                    "1 atom lacks its residue's alternative location: its own best one "
                                                    "taken"}));
    const Chosen b = choose_atoms(model, {.altloc = "B"}, "f");
    EXPECT_EQ(b.atoms, (std::vector<std::uint32_t>{0, 2, 4}));
    EXPECT_EQ(b.notes, (std::vector<std::string>{"1 atom lacks alternative location B: its own best one taken"}));
    EXPECT_TRUE(choose_atoms(model, {.altloc = "Z"}, "f").notes.empty());
}

// Two molecules, an ion and a water, in the order of mixed().
RawModel without_polymer() {
    RawModel model = mixed();
    model.residues[0].kind = ResidueKind::Ligand;
    model.residues[0].name = "UNL";
    return model;
}

TEST(ChooseAtoms, WithoutPolymerHeteroGroupsAreKept) {
    const Chosen chosen = choose_atoms(without_polymer(), {}, "f");
    EXPECT_EQ(chosen.atoms.size(), 9U);
    EXPECT_EQ(chosen.notes,
              (std::vector<std::string>{"1 water left out (keep it with keep_waters = true)",
                                        "neither protein nor nucleic acid here, so hetero groups are kept: 2 HEM, 1 "
                                        "UNL, 1 ZN"}));
    EXPECT_TRUE(chosen.warnings.empty());
    EXPECT_TRUE(chosen.ligands.empty());
}

TEST(ChooseAtoms, WithoutPolymerAnExplicitWordHolds) {
    EXPECT_TRUE(choose_atoms(without_polymer(), {.hetero = HeteroPolicy::None}, "f").atoms.empty());
    const Chosen ligands = choose_atoms(without_polymer(), {.hetero = HeteroPolicy::Ligands}, "f");
    EXPECT_EQ(ligands.atoms.size(), 8U);
    EXPECT_EQ(ligands.notes.size(), 2U);
    EXPECT_EQ(choose_atoms(without_polymer(), {.hetero = HeteroPolicy::All}, "f").notes.size(), 1U);
}

TEST(ListOfCounts, MostFrequentFirstAndNoMoreThanSix) {
    EXPECT_EQ(list_of_counts({{"CA", 1}, {"HEM", 4}}), "4 HEM, 1 CA");
    EXPECT_EQ(list_of_counts({{"", 2}}), "2 nameless");
    expect_contains(list_of_counts({{"A", 1}, {"B", 1}, {"C", 1}, {"D", 1}, {"E", 1}, {"F", 1}, {"G", 1}}),
                    "1 F and 1 more kind");
}

}  // namespace
}  // namespace meniscus::reading
