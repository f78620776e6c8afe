// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/assign_radii.h"

#include "fragments.h"

namespace meniscus::reading {
namespace {

using meniscus::testing::add_residue;
using meniscus::testing::all_atoms;
using meniscus::testing::expect_contains;

Chosen all_of(const RawModel& model) {
    Chosen chosen;
    chosen.atoms = all_atoms(model);
    return chosen;
}

RawModel with_hydrogens() {
    RawModel model;
    add_residue(model, "ALA", 1, {"N", "C", "O", "H", "H", "H"});
    return model;
}

TEST(AssignRadii, AutoTakesBondiWithHydrogensElseUnited) {
    const RawModel full = with_hydrogens();
    Chosen chosen = all_of(full);
    EXPECT_EQ(assign_radii(full, {}, "f", chosen).set, "bondi");
    EXPECT_EQ(chosen.atoms.size(), 6U);

    RawModel bare;
    add_residue(bare, "ALA", 1, {"N", "C", "O"});
    chosen = all_of(bare);
    const AssignedRadii radii = assign_radii(bare, {}, "f", chosen);
    EXPECT_EQ(radii.set, "united");
    EXPECT_EQ(radii.values, (std::vector<double>{1.70, 1.74, 1.40}));
    EXPECT_TRUE(chosen.notes.empty());
    EXPECT_TRUE(chosen.warnings.empty());
}

TEST(AssignRadii, TooFewHydrogensAreDroppedWithOneLine) {
    RawModel model;
    add_residue(model, "ALA", 1, {"N", "C", "O", "C", "H"});
    Chosen chosen = all_of(model);
    EXPECT_EQ(assign_radii(model, {}, "f", chosen).set, "united");
    EXPECT_EQ(chosen.dropped["hydrogens"], 1U);
    ASSERT_EQ(chosen.warnings.size(), 1U);
    expect_contains(chosen.warnings[0], "1 hydrogen left out, too few");
    expect_contains(chosen.warnings[0], "hydrogens = keep");

    chosen = all_of(model);
    assign_radii(model, {.radii = "naccess"}, "f", chosen);
    EXPECT_TRUE(chosen.warnings.empty()) << "the set that was asked for leaves them out anyway";
    expect_contains(chosen.notes.at(0), "the radii of naccess already include them");

    chosen = all_of(model);
    EXPECT_EQ(assign_radii(model, {.hydrogens = HydrogenPolicy::Keep}, "f", chosen).set, "bondi");
    EXPECT_EQ(chosen.atoms.size(), 5U);
}

TEST(AssignRadii, UnitedSetsDropHydrogensAndSaySo) {
    const RawModel model = with_hydrogens();
    for (const char* set : {"united", "protor", "naccess"}) {
        Chosen chosen = all_of(model);
        EXPECT_EQ(assign_radii(model, {.radii = set}, "f", chosen).values.size(), 3U);
        ASSERT_EQ(chosen.notes.size(), 1U);
        expect_contains(chosen.notes[0], std::string("the radii of ") + set + " already include them");
        EXPECT_THROW(
            assign_radii(model, {.radii = set, .hydrogens = HydrogenPolicy::Keep}, "f", chosen = all_of(model)),
            UsageError);
    }
}

TEST(AssignRadii, AskedForDropIsDoneQuietly) {
    const RawModel model = with_hydrogens();
    Chosen chosen = all_of(model);
    EXPECT_EQ(assign_radii(model, {.hydrogens = HydrogenPolicy::Drop}, "f", chosen).set, "united");
    EXPECT_EQ(chosen.dropped["hydrogens"], 3U);
    EXPECT_TRUE(chosen.notes.empty());
    EXPECT_TRUE(chosen.warnings.empty());
}

TEST(AssignRadii, AnUnknownTypeIsOneLineAndAnElementRadius) {
    RawModel model;
    add_residue(model, "FE", 1, {"FE"});
    add_residue(model, "FE", 2, {"FE"});
    Chosen chosen = all_of(model);
    EXPECT_EQ(assign_radii(model, {.radii = "bondi"}, "f", chosen).values, (std::vector<double>{2.44, 2.44}));
    ASSERT_EQ(chosen.warnings.size(), 1U);
    expect_contains(chosen.warnings[0], "2 FE FE");
    EXPECT_THROW(assign_radii(model, {.radii = "bondi", .strict_radii = true}, "f", chosen), InputError);
}

TEST(AssignRadii, AnUnknownElementIsCountedAndGivenCarbons) {
    RawModel model;
    add_residue(model, "XXX", 1, {"Q"});
    model.atoms[0].element.clear();
    Chosen chosen = all_of(model);
    EXPECT_EQ(assign_radii(model, {}, "f", chosen).values, (std::vector<double>{1.70}));
    expect_contains(chosen.warnings.at(0), "1 of unknown element");
}

TEST(AssignRadii, ZeroRadiiDoNotExistAndAreCounted) {
    RawModel model;
    add_residue(model, "ALA", 1, {"N", "C", "O"});
    model.has_radii = true;
    model.atoms[0].radius = 1.5;
    model.atoms[2].radius = 1.4;
    Chosen chosen = all_of(model);
    const AssignedRadii radii = assign_radii(model, {}, "f", chosen);
    EXPECT_EQ(radii.set, "file");
    EXPECT_EQ(radii.values, (std::vector<double>{1.5, 1.4}));
    EXPECT_EQ(chosen.atoms, (std::vector<std::uint32_t>{0, 2}));
    EXPECT_EQ(chosen.dropped["zero_radius"], 1U);
    EXPECT_TRUE(chosen.notes.empty());
    expect_contains(chosen.warnings.at(0), "1 atom of radius 0 left out");
}

TEST(AssignRadii, BondedSulphursAreNoThiols) {
    RawModel model;
    add_residue(model, "CYS", 1, {"S"});
    add_residue(model, "CYS", 2, {"S"});
    add_residue(model, "CYS", 3, {"S"});
    for (RawAtom& atom : model.atoms) atom.name = "SG";
    model.atoms[1].centre = model.atoms[0].centre + Vec3{2.05, 0.0, 0.0};
    Chosen chosen = all_of(model);
    EXPECT_EQ(assign_radii(model, {.radii = "united"}, "f", chosen).values, (std::vector<double>{1.80, 1.80, 1.85}));
}

TEST(AssignRadii, ParseSeesTheChargedAminoEnd) {
    RawModel model;
    add_residue(model, "ALA", 1, {"N", "H1", "H2", "H3", "C"});
    add_residue(model, "ALA", 2, {"N", "H", "C"});
    for (const std::size_t i : {1, 2, 3}) model.atoms[i].element = "H";
    Chosen chosen = all_of(model);
    const ReadOptions options{.radii = "parse", .hydrogens = HydrogenPolicy::Keep};
    EXPECT_EQ(assign_radii(model, options, "f", chosen).values, (std::vector<double>{2.0, 1.7, 1.5, 1.0, 1.7}));
    EXPECT_EQ(chosen.dropped["zero_radius"], 3U);
    EXPECT_TRUE(chosen.warnings.empty()) << "force fields have hydrogens of radius 0";
    expect_contains(chosen.notes.at(0), "3 hydrogens of radius 0 left out");
}

TEST(AssignRadii, UnknownSetsAndNamelessSpheresAreUsageErrors) {
    RawModel model = with_hydrogens();
    Chosen chosen = all_of(model);
    EXPECT_THROW(assign_radii(model, {.radii = "bondy"}, "f", chosen), UsageError);
    model.has_names = false;
    model.has_radii = true;
    EXPECT_THROW(assign_radii(model, {.radii = "bondi"}, "f", chosen), UsageError);
}

}  // namespace
}  // namespace meniscus::reading
