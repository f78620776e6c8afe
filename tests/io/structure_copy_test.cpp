// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "meniscus/errors.h"
#include "meniscus/write.h"
#include "support/scratch_folder.h"

namespace meniscus {
namespace {

using testing::ScratchFolder;

// Two chains, an insertion code, an alternative location, a charged hetero atom.
Structure sample() {
    Structure s;
    s.name = "sample";
    s.residues = {{.chain = "A", .name = "GLY", .number = -3, .insertion_code = 'B'},
                  {.chain = "A", .name = "ALA", .number = 12, .insertion_code = ' '},
                  {.chain = "B", .name = "CA", .number = 101, .insertion_code = ' '}};
    s.atoms.centres = {{1.5, -2.25, 0.125}, {3.0, 0.0, -0.5}, {100.001, 0.0, -3.0}};
    s.atoms.radii = {1.7, 1.8, 1.2};
    const auto label = [](std::uint32_t residue, const char* name, const char* element, char altloc, double charge) {
        return AtomLabel{.residue = residue,
                         .name = name,
                         .element = element,
                         .altloc = altloc,
                         .serial = 17,
                         .b_factor = 99.0,
                         .occupancy = 0.5,
                         .charge = charge};
    };
    s.labels = {label(0, "CA", "C", 'A', 0.0), label(1, "CB", "C", ' ', 0.25), label(2, "CA", "CA", ' ', 2.0)};
    return s;
}

Structure read_back(const std::string& path) {
    return read_structure(path, {.radii = "bondi", .hetero = HeteroPolicy::All});
}

void expect_same_atoms(const Structure& found, const Structure& s, const std::vector<double>& values, double rounding) {
    ASSERT_EQ(found.atoms.size(), s.atoms.size());
    for (std::size_t i = 0; i < s.atoms.size(); ++i) {
        EXPECT_EQ(found.labels[i].name, s.labels[i].name);
        EXPECT_EQ(found.labels[i].element, s.labels[i].element);
        EXPECT_EQ(found.labels[i].altloc, s.labels[i].altloc);
        EXPECT_EQ(found.labels[i].charge, std::round(s.labels[i].charge));
        EXPECT_NEAR(found.labels[i].b_factor, values[i], rounding);
        EXPECT_NEAR(norm(found.atoms.centres[i] - s.atoms.centres[i]), 0.0, 1e-3);
        const Residue& residue = found.residues[found.labels[i].residue];
        const Residue& expected = s.residues[s.labels[i].residue];
        EXPECT_EQ(residue.chain, expected.chain);
        EXPECT_EQ(residue.name, expected.name);
        EXPECT_EQ(residue.number, expected.number);
        EXPECT_EQ(residue.insertion_code, expected.insertion_code);
    }
}

TEST(StructureCopy, PdbReadsBackWithTheValues) {
    const ScratchFolder folder;
    const std::vector<double> values{0.0, -1.0, 123.456};
    write_structure_copy(folder / "a.pdb", sample(), values);
    expect_same_atoms(read_back(folder / "a.pdb"), sample(), values, 0.005001);
}

TEST(StructureCopy, MmcifReadsBackWithTheValuesAndLongNames) {
    const ScratchFolder folder;
    Structure s = sample();
    s.residues[0].chain = s.residues[1].chain = "A-2";
    const std::vector<double> values{0.0, -1.0, 123456.7};
    write_structure_copy(folder / "a.cif", s, values);
    expect_same_atoms(read_back(folder / "a.cif"), s, values, 0.5);  // six digits
}

TEST(StructureCopy, SpheresWithoutNamesGetSome) {
    const ScratchFolder folder;
    Structure s = sample();
    s.residues.clear();
    s.labels.assign(3, AtomLabel());
    const std::vector<double> values{1.0, 2.0, 3.0};
    for (const char* name : {"a.pdb", "a.cif"}) {
        write_structure_copy(folder / name, s, values);
        const std::string text = testing::read_file(folder / name);
        EXPECT_NE(text.find("UNK"), std::string::npos) << text;
        EXPECT_NE(text.find("100.001"), std::string::npos) << text;
    }
}

TEST(StructureCopy, LargeNumbersAreHybrid36) {
    const ScratchFolder folder;
    Structure s = sample();
    s.residues[2].number = 10000;
    write_structure_copy(folder / "a.pdb", s, std::vector<double>(3, 1.0));
    EXPECT_NE(testing::read_file(folder / "a.pdb").find("BA000 "), std::string::npos);
}

TEST(StructureCopy, PdbRefusesWhatDoesNotFit) {
    const ScratchFolder folder;
    const std::vector<std::function<void(Structure&, std::vector<double>&)>> changes = {
        [](Structure& s, auto&) { s.residues[0].chain = "AA"; },
        [](Structure& s, auto&) { s.residues[0].name = "ALAX"; },
        [](Structure& s, auto&) { s.residues[0].number = -1000; },
        [](Structure& s, auto&) { s.residues[0].number = 3000000; },
        [](Structure& s, auto&) { s.labels[0].name = "CABCD"; },
        [](Structure& s, auto&) { s.atoms.centres[0].x = 10000.0; },
        [](Structure& s, auto&) { s.atoms.centres[0].z = -1000.0; },
        [](Structure&, auto& values) { values[0] = 1000.0; },
        [](Structure&, auto& values) { values[0] = -100.0; },
    };
    for (const auto& change : changes) {
        Structure s = sample();
        std::vector<double> values(3, 999.99);
        change(s, values);
        try {
            write_structure_copy(folder / "a.pdb", s, values);
            ADD_FAILURE();
        } catch (const OutputError& error) {
            EXPECT_NE(std::string(error.what()).find("write .cif instead"), std::string::npos) << error.what();
        }
        EXPECT_TRUE(folder.listing().empty());
        EXPECT_NO_THROW(write_structure_copy(folder / "a.cif", s, values));
        std::filesystem::remove(folder / "a.cif");
    }
}

TEST(StructureCopy, RefusesOtherSuffixesAndNumbersOfValues) {
    const ScratchFolder folder;
    EXPECT_THROW(write_structure_copy(folder / "a.ent", sample(), std::vector<double>(3)), UsageError);
    EXPECT_THROW(write_structure_copy(folder / "a.pdb", sample(), std::vector<double>(2)), UsageError);
    EXPECT_TRUE(folder.listing().empty());
}

}  // namespace
}  // namespace meniscus
