// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/element.h"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

namespace meniscus::reading {
namespace {

TEST(Element, AlignmentTellsCalciumFromCarbon) {
    EXPECT_EQ(element_from_columns(" CA ", "LIG"), "C");
    EXPECT_EQ(element_from_columns("CA  ", "LIG"), "CA");
    EXPECT_EQ(element_from_columns("CA  ", "CA"), "CA");
    EXPECT_EQ(element_from_columns(" CA ", "CA"), "CA");
    EXPECT_EQ(element_from_columns("ZN  ", "ZN"), "ZN");
    EXPECT_EQ(element_from_columns("FE  ", "HEM"), "FE");
}

TEST(Element, InAminoAcidsAndNucleotidesTheFirstLetterTells) {
    EXPECT_EQ(element_from_columns("CA  ", "LEU"), "C");
    EXPECT_EQ(element_from_columns("CD1 ", "LEU"), "C");
    EXPECT_EQ(element_from_columns("HG11", "VAL"), "H");
    EXPECT_EQ(element_from_columns("1HB ", "ALA"), "H");
    EXPECT_EQ(element_from_columns("NE2 ", "HSD"), "N");
    EXPECT_EQ(element_from_columns("SE  ", "MSE"), "SE");
    EXPECT_EQ(element_from_columns(" O5'", "DA"), "O");
    EXPECT_EQ(element_from_columns(" OH2", "TIP3"), "O");
    EXPECT_EQ(element_from_columns("SG  ", "CYS"), "S");
}

TEST(Element, LigandsWithLongNames) {
    EXPECT_EQ(element_from_columns(" C12", "LIG"), "C");
    EXPECT_EQ(element_from_columns("C123", "LIG"), "C");
    EXPECT_EQ(element_from_columns("CL12", "LIG"), "CL");
    EXPECT_EQ(element_from_columns("BR1 ", "LIG"), "BR");
    EXPECT_EQ(element_from_columns("HC12", "LIG"), "H");
    EXPECT_EQ(element_from_columns("1C4A", "LIG"), "C");
}

TEST(Element, HalogensAndIronOfLigandsWhereverTheNameStarts) {
    for (const char* residue : {"LIG", "MOL", "UNL", "UNK"}) {
        for (const char* name : {" CL1", "CL1 ", " Cl1", "CL12", "  CL", " CL "})
            EXPECT_EQ(element_from_columns(name, residue), "CL") << name << residue;
        for (const char* name : {" BR ", "BR  ", "BR2 ", " Br2"})
            EXPECT_EQ(element_from_columns(name, residue), "BR") << name;
        for (const char* name : {" F1 ", "F12 ", "F   ", " F  "})
            EXPECT_EQ(element_from_columns(name, residue), "F") << name;
        for (const char* name : {" I1 ", "I1  ", " I  "}) EXPECT_EQ(element_from_columns(name, residue), "I") << name;
        for (const char* name : {" C1 ", " CA ", " C12"}) EXPECT_EQ(element_from_columns(name, residue), "C") << name;
        EXPECT_EQ(element_from_columns(" SE ", residue), "SE");
        EXPECT_EQ(element_from_columns(" SI1", residue), "SI");
        EXPECT_EQ(element_from_columns(" S1 ", residue), "S");
    }
    for (const char* name : {"FE  ", " FE ", "  FE"}) EXPECT_EQ(element_from_columns(name, "HEM"), "FE") << name;
    EXPECT_EQ(element_from_columns(" MG ", "CLA"), "MG");
    EXPECT_EQ(element_from_columns(" NA ", "HEM"), "N");
    EXPECT_EQ(element_from_columns(" D1 ", "LIG"), "D");
}

TEST(Element, AnUnknownAminoAcidHasAtomsOfAminoAcids) {
    EXPECT_EQ(element_from_columns("CA  ", "UNK"), "C");
    EXPECT_EQ(element_from_columns(" CD ", "UNK"), "C");
    EXPECT_EQ(element_from_columns("HG11", "UNK"), "H");
    EXPECT_EQ(element_from_name("BR1", "UNK"), "BR");
}

TEST(Element, IonsByTheNamesOfForceFields) {
    EXPECT_EQ(element_from_columns("SOD ", "SOD"), "NA");
    EXPECT_EQ(element_from_columns(" CLA", "CLA"), "CL");
    EXPECT_EQ(element_from_name("POT", "POT"), "K");
    EXPECT_EQ(element_from_name("NA+", "NA+"), "NA");
}

TEST(Element, IonsMayBeNamedWithTheirCharge) {
    for (const auto& [residue, name] : std::vector<std::pair<const char*, const char*>>{
             {"NA+", "NA"}, {"CL-", "CL"}, {"K+", "K"}, {"MG2+", "MG"}, {"CA2+", "CA"}, {"CS+", "CS"}, {"CD+2", "CD"}})
        EXPECT_EQ(element_from_name(name, residue), name) << residue;
    EXPECT_EQ(element_from_columns(" NA ", "NA+"), "NA");
    EXPECT_EQ(element_from_name("CA", "LIG+"), "C");
    EXPECT_EQ(element_from_name("NA", "NA2"), "N");  // which may be a ligand
}

TEST(Element, AnAtomAloneMayBeAnIonByItsResidue) {
    EXPECT_EQ(element_of_ion("NA", "NA2"), "NA");
    EXPECT_EQ(element_of_ion("CS", "CS1"), "CS");
    EXPECT_EQ(element_of_ion("CA", "ION"), "CA");
    EXPECT_EQ(element_of_ion("CL-", "ION"), "CL");
    EXPECT_EQ(element_of_ion("SOD", "ION"), "NA");
    EXPECT_EQ(element_of_ion("CLA", "ION"), "CL");
    for (const char* residue : {"LIG", "ALA", "UNK", "HOH", "CAX"})
        EXPECT_EQ(element_of_ion("CA", residue), "") << residue;
    EXPECT_EQ(element_of_ion("C1", "LIG"), "");
}

TEST(Element, WithoutAlignmentOnlyPlainCasesAreTwoLetters) {
    EXPECT_EQ(element_from_name("CA", "ALA"), "C");
    EXPECT_EQ(element_from_name("CA", "CA"), "CA");
    EXPECT_EQ(element_from_name("HT1", "MET"), "H");
    EXPECT_EQ(element_from_name("FE", "HEM"), "FE");
    EXPECT_EQ(element_from_name("CD", "LIG"), "C");
    EXPECT_EQ(element_from_name("", "LIG"), "");
    EXPECT_EQ(element_from_name("123", "LIG"), "");
}

TEST(Element, SymbolsInAnyCase) {
    EXPECT_EQ(element_symbol(" Xe"), "XE");
    EXPECT_EQ(element_symbol("c "), "C");
    EXPECT_EQ(element_symbol("D"), "D");
    EXPECT_EQ(element_symbol("A"), "");
    EXPECT_EQ(element_symbol("89"), "");
    EXPECT_EQ(element_symbol("  "), "");
}

}  // namespace
}  // namespace meniscus::reading
