// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pdb_line.h"

#include "fragments.h"
#include "structure/element.h"

namespace meniscus {
namespace {

using reading::ChainWidth;
using testing::error_of;
using testing::expect_contains;
using testing::has_warning;
using testing::pdb_line;
using testing::read_text;

const ReadOptions kAll{.hydrogens = HydrogenPolicy::Keep, .hetero = HeteroPolicy::All};

// A hetero atom with a text from column 75 on.
std::string hetero_line(const std::string& name, const std::string& residue, const std::string& from_75) {
    std::string line = pdb_line({.name = name, .residue = residue, .record = "HETATM"});
    line.pop_back();
    line.resize(74, ' ');
    return line + from_75 + "\n";
}

std::string element_of(const std::string& name, const std::string& residue, const std::string& from_75) {
    return read_text(hetero_line(name, residue, from_75), "e.pdb", kAll).labels.at(0).element;
}

TEST(PdbLine, ElementsOneColumnBesideTheirColumnsAreRead) {
    for (const char* symbol : {"ZN", "CU", "NI", "CO", "AS", "MN", "CD", "SI", "CL", "BR", "NA", "CA", "Cl", "Mn"}) {
        const std::string upper = reading::upper_case(symbol);
        for (const std::string& columns : {std::string(" ") + symbol, std::string("   ") + symbol})
            EXPECT_EQ(element_of(upper + "  ", " " + upper, columns), upper) << columns;
    }
    EXPECT_EQ(element_of(" CO1", "LIG", " CO"), "CO");
    EXPECT_EQ(element_of("CL1 ", "LIG", "   CL"), "CL");
}

TEST(PdbLine, ShiftedElementsAreOneWarning) {
    const std::string line = hetero_line("MN  ", " MN", " MN2+");
    const Structure s = read_text(pdb_line({.element = " C"}) + line + line + line, "e.pdb", kAll);
    EXPECT_EQ(s.labels.at(1).charge, 2.0);
    EXPECT_TRUE(has_warning(
        s, "line 2: element 'MN' stands one column beside columns 77-78; read from where it stands (3 times)"));
}

TEST(PdbLine, WhatIsBesideTheElementsColumnsIsOtherwiseLeftThere) {
    EXPECT_EQ(element_of(" C1 ", "LIG", "  C"), "C");
    EXPECT_EQ(element_of(" CA ", "ALA", "   CA"), "C") << "no calcium in an amino acid";
    EXPECT_EQ(element_of(" CL ", "LIG", "  CL"), "CL");
    EXPECT_EQ(element_of(" N1 ", "LIG", "AMN"), "N") << "a segment that ends in M";
    EXPECT_EQ(element_of(" CO1", "LIG", "  C O"), "C");
    EXPECT_EQ(element_of(" CD1", "LIG", "   cd"), "C") << "an atom type of GAFF";
}

std::string with_number(const std::string& from_23, const std::string& file = "n.pdb") {
    std::string line = pdb_line({});
    line.replace(22, from_23.size(), from_23);
    return error_of(line, file);
}

int number_of(const std::string& from_23) {
    std::string line = pdb_line({});
    line.replace(22, from_23.size(), from_23);
    return read_text(line, "n.pdb").residues.at(0).number;
}

TEST(PdbLine, ResidueNumbersThatAreNoneAreRefused) {
    for (const char* text : {"X1?*", "***1", " 1 1", "1.0 ", "271G", "A1  ", "Aa00", "A0001", "  --"}) {
        const std::string error = with_number(text);
        EXPECT_TRUE(error.starts_with("n.pdb:1:23: residue number '")) << error << text;
    }
    expect_contains(with_number("X1?*"), "residue number 'X1?*' is not an integer; correct it");
    expect_contains(with_number("100001"), "residue number '100001' has no room in columns 23-27");
    EXPECT_TRUE(with_number("***1", "n.pdbqt").starts_with("n.pdbqt:1:23: "));
}

TEST(PdbLine, ResidueNumbersInTheirColumns) {
    for (const auto& [text, number] : {std::pair("   7", 7),
                                       {"7   ", 7},
                                       {"  -7", -7},
                                       {"  +7", 7},
                                       {"   7A", 7},
                                       {"12345", 12345},
                                       {"-1234", -1234},
                                       {"    7", 7},
                                       {"A000", 10000},
                                       {"ZZZZ", 1223055},
                                       {"a000", 1223056},
                                       {"271a", 10010},
                                       {"****", 0},
                                       {"     ", 0}})
        EXPECT_EQ(number_of(text), number) << text;
}

TEST(PdbLine, CoordinatesBeyondEverySizeAreRefused) {
    std::string line = pdb_line({});
    line.replace(38, 8, "  1e+300");
    EXPECT_EQ(error_of(pdb_line({}) + line, "c.pdb"),
              "c.pdb:2:39: y coordinate '  1e+300' is more than 1e12 Å; correct it or leave the atom out");
}

std::string with_residue(const std::string& from_18) {
    std::string line = pdb_line({.record = "HETATM"});
    return line.replace(17, from_18.size(), from_18);
}

std::string last_residue(const std::string& text, bool* warned = nullptr) {
    const Structure s = read_text(text, "r.pdb", kAll);
    if (warned != nullptr) *warned = has_warning(s, "in columns 18-22 is read as a residue name of four letters");
    return s.residues.back().name + "/" + s.residues.back().chain;
}

TEST(PdbLine, NamesOfFourLettersMayHaveAChain) {
    bool warned = true;
    EXPECT_EQ(last_residue(pdb_line({}) + with_residue("POPCL"), &warned), "POPC/L");
    EXPECT_FALSE(warned) << "alanine leaves column 21 blank";
    EXPECT_EQ(last_residue(with_residue("POPCL"), &warned), "POPC/L");
    EXPECT_TRUE(warned);
    EXPECT_EQ(last_residue(with_residue("ALAAB") + with_residue("HEMCD"), &warned), "HEM/CD");
    EXPECT_FALSE(warned);
    EXPECT_EQ(last_residue(pdb_line({}) + with_residue("HISEA")), "HISE/A");
    EXPECT_EQ(last_residue(pdb_line({}) + with_residue(" ZNAB")), "ZN/AB");
    EXPECT_EQ(last_residue(pdb_line({}) + with_residue("POPC ")), "POPC/");
}

TEST(PdbLine, KnownResiduesTellHowWideChainsAre) {
    const auto width = [](const char* columns, ChainWidth known) {
        return reading::chain_width_of_record(with_residue(columns), known);
    };
    EXPECT_EQ(width("ALA A", ChainWidth::Unknown), ChainWidth::One);
    EXPECT_EQ(width(" DAAB", ChainWidth::One), ChainWidth::Two);
    EXPECT_EQ(width("ALA A", ChainWidth::Two), ChainWidth::Two);
    EXPECT_EQ(width("HEMAB", ChainWidth::Unknown), ChainWidth::Unknown);
    EXPECT_EQ(width("ASPPA", ChainWidth::Unknown), ChainWidth::Unknown) << "protonated";
    EXPECT_EQ(width("TIP3W", ChainWidth::One), ChainWidth::One);
}

}  // namespace
}  // namespace meniscus
