// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "meniscus/errors.h"
#include "meniscus/vertex_values.h"
#include "support/scratch_folder.h"
#include "tables/small_complex.h"

namespace meniscus {
namespace {

using testing::small_complex;

ValueTable table_of(const std::string& text, const Structure& structure = small_complex()) {
    const testing::ScratchFolder folder;
    std::ofstream(folder / "t.csv", std::ios::binary) << text;
    return read_value_table(folder / "t.csv", structure);
}

/// What is said of a table, without the folder.
std::string message_of(const std::string& text, const Structure& structure = small_complex()) {
    try {
        table_of(text, structure);
    } catch (const InputError& error) {
        const std::string message = error.what();
        return message.substr(message.find("t.csv"));
    }
    return "";
}

void expect_values(const std::vector<double>& values, const std::vector<double>& expected) {
    ASSERT_EQ(values.size(), expected.size());
    for (std::size_t i = 0; i < values.size(); ++i)
        EXPECT_TRUE(values[i] == expected[i] || (std::isnan(values[i]) && std::isnan(expected[i])))
            << i << ": " << values[i];
}

const double kNone = std::nan("");

TEST(ValueTable, RowsOfResiduesAreAboutAllTheirAtoms) {
    const ValueTable table =
        table_of("chain,resnum,icode,resname,score,buried\r\nA,1,,ALA,1.5,true\r\nA,2,B,MSE,-2,false\r\n");
    ASSERT_EQ(table.columns.size(), 2U);
    EXPECT_EQ(table.columns[0].name, "score");
    expect_values(table.columns[0].of_atom, {1.5, 1.5, -2, -2, kNone, kNone});
    expect_values(table.columns[1].of_atom, {1, 1, 0, 0, kNone, kNone});
    EXPECT_EQ(table.rows, 2U);
    EXPECT_EQ(table.strange_rows, 0U);
}

TEST(ValueTable, RowsOfAtomsAreToldByIndexByNameOrBySerial) {
    const std::vector<double> expected{kNone, 7, kNone, kNone, kNone, 8};
    expect_values(table_of("index,x,y,z,v\n1,0,0,0,7\n5,0,0,0,8\n").columns[0].of_atom, expected);
    expect_values(table_of("chain,resnum,name,v\nA,1,CB,7\nLONG,7,NE2,8\n").columns[0].of_atom, expected);
    expect_values(table_of("serial,v\n2,7\n6,8\n").columns[0].of_atom, expected);
}

TEST(ValueTable, RowsOfChainsAreAboutAllTheirAtoms) {
    expect_values(table_of("chain,v\nB,3\n").columns[0].of_atom, {kNone, kNone, kNone, kNone, 3, kNone});
}

TEST(ValueTable, CellsWithoutAValueAreNone) {
    expect_values(table_of("serial,v\n1,\n2,NA\n3,nan\n4,1e3\n").columns[0].of_atom,
                  {kNone, kNone, kNone, 1000, kNone, kNone});
}

TEST(ValueTable, CopiesInAnAssemblyHaveTheValuesOfTheOriginalUnlessTheyHaveTheirOwn) {
    Structure twice = small_complex();
    twice.residues[2].chain = "A-2";
    twice.labels[4].name = "CA";
    expect_values(table_of("chain,resnum,v\nA,1,5\n", twice).columns[0].of_atom, {5, 5, kNone, kNone, 5, kNone});
    expect_values(table_of("chain,resnum,v\nA,1,5\nA-2,1,6\n", twice).columns[0].of_atom,
                  {5, 5, kNone, kNone, 6, kNone});
}

TEST(ValueTable, RowsOfWhatIsNotKeptAreCounted) {
    const ValueTable table = table_of("chain,resnum,v\nA,1,1\nZ,1,1\nA,99,1\n");
    EXPECT_EQ(table.rows, 3U);
    EXPECT_EQ(table.strange_rows, 2U);
    EXPECT_NO_THROW(refuse_strange_table(table, "t.csv", small_complex()));
    EXPECT_THROW(refuse_strange_table(table_of("chain,resnum,v\nZ,1,1\n"), "t.csv", small_complex()), InputError);
}

TEST(ValueTable, ATableOfAnotherStructureIsRefused) {
    EXPECT_EQ(
        message_of("chain,resnum,resname,v\nA,1,GLY,1\n"),
        "t.csv:2:5: resname is 'GLY' here, but 'ALA' in the structure; does the table belong to another structure?");
    EXPECT_NE(message_of("index,chain,v\n0,B,1\n").find("t.csv:2:3: chain is 'B' here, but 'A'"), std::string::npos);
}

TEST(ValueTable, MistakesAreToldWithTheirPlace) {
    EXPECT_NE(message_of("").find("is empty"), std::string::npos);
    EXPECT_EQ(message_of("chain,resnum\nA,1\n").substr(0, 34), "t.csv:1:1: no column of values; ad");
    EXPECT_EQ(message_of("v\n1\n").substr(0, 40), "t.csv:1:1: no column says which atoms or");
    EXPECT_EQ(message_of("resnum,v\n1,1\n").substr(0, 28), "t.csv:1:1: no column 'chain'");
    EXPECT_EQ(message_of("chain,resnum,v\nA,1,high\nB,1,2\n").substr(0, 38), "t.csv:2:5: column 'v' holds 'high', wh");
    EXPECT_EQ(message_of("chain,resnum,v\nA,1,high\n"),
              "t.csv:1:1: no column of values: no cell of column 'v' is a number");
    EXPECT_EQ(message_of("chain,resnum,v\nA,one,1\n"), "t.csv:2:3: resnum 'one' is not a whole number");
    EXPECT_EQ(message_of("chain,resnum,v\nA,1\n"), "t.csv:2:1: has 2 cells under 3 names");
    EXPECT_TRUE(
        message_of("serial,v\n1,1e39\n").starts_with("t.csv:2:3: column 'v' holds '1e39', which is not a number"));
    EXPECT_EQ(message_of("serial,v,v\n1,1,1\n"), "t.csv:1:10: a second column 'v'; rename one of them");
    EXPECT_EQ(message_of("serial,v\n1,1\n1,2\n"),
              "t.csv:3:1: repeats the atoms or residue of line 2; leave one of them out");
    for (const char* name : {"area", "two words", "Atom", "1st"})
        EXPECT_NE(message_of(std::string("serial,") + name + "\n1,1\n").find("cannot be the name"), std::string::npos)
            << name;
}

TEST(ValueTable, TablesOfOtherKindsAreCalledByTheirName) {
    const std::string what =
        "; values are read from comma-separated tables (.csv) with a row for each atom, residue or chain";
    EXPECT_EQ(message_of("component,ses_area,inscribed_radius\n1,2,3\n"), "t.csv: is a table of cavities" + what);
    EXPECT_EQ(message_of(" [\n{\"a\": 1}]"), "t.csv: is JSON" + what);
    EXPECT_EQ(message_of("{\"a\": [1, 2]}"), "t.csv: is JSON" + what);
}

TEST(ValueTable, SemicolonsAndTabsOfSpreadsheetsAreTaken) {
    for (const char* text : {"chain;resnum;v\nA;1;0.5\n", "chain\tresnum\tv\nA\t1\t0.5\n"})
        expect_values(table_of(text).columns[0].of_atom, {0.5, 0.5, kNone, kNone, kNone, kNone});
    const std::string what = "column 'v' holds '0,5'; write decimals with a point";
    EXPECT_EQ(message_of("chain;resnum;v\nA;1;0,5\n"), "t.csv:2:5: " + what);
    EXPECT_EQ(message_of("chain;resnum;v\nB;1;1\nA;1;0,5\n"), "t.csv:3:5: " + what);
    EXPECT_EQ(table_of("chain,resnum,note,v\nA,1,\"1,2\",1\nB,1,x,2\n").texts, (std::vector<std::string>{"note"}));
}

TEST(ValueTable, ColumnsThatWereMeantToIdentifyAreTold) {
    EXPECT_TRUE(message_of("Chain,Residue,v\nA,1,1\n")
                    .ends_with("columns that say what a row is about are index, chain, resname, resnum, icode, name, "
                               "altloc, serial, in small letters"));
    EXPECT_TRUE(message_of("Chain,Resnum,v\nA,1,1\n").ends_with("or serial, in small letters"));
    EXPECT_EQ(message_of("serial,area\n1,1\n").find("small letters"), std::string::npos);
}

TEST(ValueTable, AtomsOfOneNameInAResidueAreNotCopiesOfEachOther) {
    Structure nameless = small_complex();
    nameless.residues = {{}};
    for (AtomLabel& label : nameless.labels) label.residue = 0;
    for (AtomLabel& label : nameless.labels) label.name = "X";
    expect_values(table_of("index,v\n0,1\n2,3\n", nameless).columns[0].of_atom, {1, kNone, 3, kNone, kNone, kNone});
}

TEST(ValueTable, ColumnsOfTextAreLeftAlone) {
    const ValueTable table = table_of("chain,resnum,two words,v,empty\nA,1,core,1,\nB,1,,2,\n");
    EXPECT_EQ(table.texts, (std::vector<std::string>{"two words"}));
    ASSERT_EQ(table.columns.size(), 2U);
    EXPECT_EQ(table.columns[0].name, "v");
    EXPECT_EQ(table.columns[1].name, "empty");
}

TEST(ValueTable, ColumnsWithoutANameAreLeftAlone) {
    const ValueTable table = table_of(",chain,resnum,v,\n0,A,1,5,\n1,B,1,6,\n");
    ASSERT_EQ(table.columns.size(), 1U);
    EXPECT_EQ(table.columns[0].name, "v");
}

TEST(ValueTable, TheTableOfOneInterfaceHasPlainNames) {
    const ValueTable table =
        table_of("interface,side,chain,resnum,icode,resname,buried_sas\nA:B,a,A,1,,ALA,3\nA:B,b,B,1,,GLY,4\n");
    ASSERT_EQ(table.columns.size(), 1U);
    EXPECT_EQ(table.columns[0].name, "buried_sas");
    EXPECT_EQ(table.texts, (std::vector<std::string>{"interface", "side"}));
    expect_values(table.columns[0].of_atom, {3, 3, kNone, kNone, 4, kNone});
}

TEST(ValueTable, EveryOneOfSeveralInterfacesHasArraysOfItsOwn) {
    const ValueTable table =
        table_of("interface,side,chain,resnum,v\nA:B,a,A,1,3\n\"A:B,LONG\",a,A,1,5\nA:B,b,B,1,4\nA:b,b,B,1,6\n");
    ASSERT_EQ(table.columns.size(), 3U);
    EXPECT_EQ(table.columns[0].name, "v_A_B");
    EXPECT_EQ(table.columns[1].name, "v_A_B_LONG");
    EXPECT_EQ(table.columns[2].name, "v_A_b_2");
    expect_values(table.columns[0].of_atom, {3, 3, kNone, kNone, 4, kNone});
    expect_values(table.columns[1].of_atom, {5, 5, kNone, kNone, kNone, kNone});
    EXPECT_EQ(table.texts, (std::vector<std::string>{"side"}));
    EXPECT_EQ(message_of("interface,side,chain,resnum,v\nA:B,a,A,1,3\nA:C,a,A,1,3\nA:B,a,A,1,5\n"),
              "t.csv:4:1: repeats the atoms or residue of line 2; leave one of them out");
}

TEST(ValueTable, NoArrayOfAnInterfaceHasANameThatIsTaken) {
    const ValueTable table =
        table_of("interface,side,serial,mean,v,v_A\ncurvature,a,1,3,1,1\nA:B,a,1,5,1,1\nB,a,2,5,1,1\n");
    ASSERT_EQ(table.columns.size(), 9U);
    EXPECT_EQ(table.columns[0].name, "mean_curvature_2");
    EXPECT_EQ(table.columns[4].name, "v_A_B");
    EXPECT_EQ(table.columns[8].name, "v_A_B_2");
    std::string many = "interface,side,serial,v\n";
    for (int i = 0; i < 1001; ++i) many += "I" + std::to_string(i) + ",a,1,1\n";
    EXPECT_TRUE(message_of(many).starts_with("t.csv:1:1: names 1001 interfaces"));
}

TEST(ValueTable, OneChainNeedsNoName) {
    Structure one = small_complex();
    for (Residue& residue : one.residues) residue.chain = "A";
    expect_values(table_of("resnum,v\n7,4\n", one).columns[0].of_atom, {kNone, kNone, kNone, kNone, kNone, 4});
}

}  // namespace
}  // namespace meniscus
