// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pdb_records.h"

#include "fragments.h"

namespace meniscus::reading {
namespace {

using meniscus::testing::expect_contains;
using meniscus::testing::pdb_line;

struct Tidied {
    std::string text;
    RecordOddities found;
};

Tidied tidied(std::string text) {
    RecordOddities found = tidy_records(text, "f.pdb");
    return {std::move(text), std::move(found)};
}

std::string tidy_error(std::string text) {
    try {
        tidy_records(text, "f.pdb");
    } catch (const InputError& error) {
        return error.what();
    }
    return "";
}

const std::string kOfRecords = pdb_line({.x = 1.0});

TEST(PdbRecords, OrdinaryFilesStayAsTheyAre) {
    const std::string text = "REMARK   1 ATOM      1  CA  ALA A   1       0.000   0.000   0.000\nMODEL        1\n" +
                             kOfRecords +
                             "ANISOU    1  CA  ALA A   1      100    200    300\nSIGATM    1  CA  ALA A   1       "
                             "0.100   0.100   0.100\nTER\nENDMDL\nCONECT    1    2\nEND\n\n  \n";
    const Tidied result = tidied(text);
    EXPECT_EQ(result.text, text);
    EXPECT_TRUE(result.found.notes.empty());
    EXPECT_TRUE(result.found.warnings.empty());
}

TEST(PdbRecords, BlanksInFrontAreTakenAway) {
    const std::string line = kOfRecords.substr(0, kOfRecords.size() - 1);
    const Tidied result = tidied(kOfRecords + " " + kOfRecords + "  " + kOfRecords + " TER\n");
    EXPECT_EQ(result.text, kOfRecords + line + " \n" + line + "  \nTER \n");
    ASSERT_EQ(result.found.warnings.size(), 1U);
    EXPECT_EQ(result.found.warnings[0],
              "line 2: 'ATOM': a record behind blanks; read as if it began in the first column (3 times)");
}

TEST(PdbRecords, WhereCoordinatesAreInPlaceOnlyTheNameMoves) {
    std::string line = kOfRecords;
    line.replace(0, 6, " ATOM ");
    EXPECT_EQ(tidied(line).text, kOfRecords);
    line.replace(0, 11, "  HETATM  1");
    std::string hetatm = kOfRecords;
    hetatm.replace(0, 11, "HETATM    1");
    EXPECT_EQ(tidied(line).text, hetatm);
}

TEST(PdbRecords, NamesInLowerCaseBecomeCapitals) {
    std::string lower = kOfRecords;
    lower.replace(0, 4, "atom");
    const Tidied result = tidied("model        1\n" + lower + "endmdl\nModel        2\n" + lower + "Endmdl\nend\n");
    EXPECT_EQ(result.text, "MODEL        1\n" + kOfRecords + "ENDMDL\nMODEL        2\n" + kOfRecords + "ENDMDL\nEND\n");
    ASSERT_EQ(result.found.notes.size(), 1U);
    EXPECT_EQ(result.found.notes[0], "line 1: the name of a record in lower case, 'model'; read as capitals (7 times)");
}

TEST(PdbRecords, WideSerialsReachIntoTheName) {
    for (const char* record : {"ATOM ", "ATOM\t", "ATOM", "ATOM123456", "ATOM 12345", "ATOM  *****", "HETATM1234"})
        EXPECT_TRUE(is_atom_record(record)) << record;
    for (const char* record : {"ATOMS ", "ATOMIC", "HETAT ", "ANISOU", "", "A"})
        EXPECT_FALSE(is_atom_record(record)) << record;
}

TEST(PdbRecords, LinesLikeAtomsUnderAnotherNameAreTold) {
    const std::string rest = kOfRecords.substr(4);
    for (const std::string name : {"#ATOM", "ATM ", "HETATOM", ">", "ATOMS", "TOM ", "A"}) {
        const Tidied result = tidied(kOfRecords + name + rest + name + rest + "END\n");
        ASSERT_EQ(result.found.warnings.size(), 1U) << name;
        EXPECT_TRUE(result.found.warnings[0].starts_with("line 2: ")) << result.found.warnings[0];
        expect_contains(result.found.warnings[0], "is not a record of the PDB format, but the line has coordinates");
        expect_contains(result.found.warnings[0], "(2 times)");
    }
    EXPECT_EQ(tidied("END\nATM 1 CA ALA 1 1.5 2.5 3.5\n").found.warnings.size(), 1U);
    // Rosetta's energies, a matrix of Swiss-PdbViewer, scores of CASP.
    for (const char* table : {"ALA:NtermProteinFull_1 -1.250 0.521 3.333\n", "SPDBVT     1.000   0.000   0.000\n",
                              "weights 1 0.55 0.94 1.25\n", "SCORE 0.912 0.855 0.801\n"})
        EXPECT_TRUE(tidied(kOfRecords + table).found.warnings.empty()) << table;
}

TEST(PdbRecords, FilesJoinedWithoutALineEndAreRefused) {
    std::string whole = kOfRecords.substr(0, kOfRecords.size() - 1);
    whole.resize(80, ' ');
    expect_contains(tidy_error(kOfRecords + "END" + kOfRecords), "f.pdb:2:4: an atom record begins within a line");
    expect_contains(tidy_error(kOfRecords + "ENDMDL" + kOfRecords), "f.pdb:2:7: an atom record begins within a line");
    expect_contains(tidy_error("TER       2      ALA A   1" + kOfRecords), "f.pdb:1:27: ");
    expect_contains(tidy_error(whole + kOfRecords), "f.pdb:1:81: ");
    expect_contains(tidy_error("CONECT    1    2" + kOfRecords), "f.pdb:1:17: ");
    EXPECT_EQ(tidy_error(whole + "  ATOM\nENDATOM\n"), "");
}

TEST(PdbRecords, AnAtomBehindAnyRecordIsSeenInAnyCase) {
    std::string whole = kOfRecords.substr(0, kOfRecords.size() - 1);
    whole.resize(80, ' ');
    std::string anisou = "ANISOU    1  CA  ALA A   1     1000   1000   1000    100    100    100       C  ";
    for (const char* name : {"ATOM ", "atom ", "Atom ", "HETATM", "hetatm"}) {
        const std::string atom = name + kOfRecords.substr(std::string(name).size());
        for (const std::string& before : {whole, anisou})
            expect_contains(tidy_error(before + atom), "f.pdb:1:81: an atom record begins within a line");
    }
    std::string wide = kOfRecords;
    for (const char* name : {"ATOM 100000", "ATOM1000000", "HETATM12345"})
        expect_contains(tidy_error(whole + wide.replace(0, 11, name)), "f.pdb:1:81: ");
    expect_contains(tidy_error("MODEL        2" + kOfRecords), "f.pdb:1:15: ");
    EXPECT_EQ(tidy_error(anisou + "\n" + whole + "  atomic 1.5 2.5 3.5\n"), "");
}

TEST(PdbRecords, AFormFeedIsABlankInFront) {
    const std::string line = kOfRecords.substr(0, kOfRecords.size() - 1);
    const Tidied result = tidied("\f" + kOfRecords + "\v" + kOfRecords + "\f\n");
    EXPECT_EQ(result.text, line + " \n" + line + " \n\f\n");
    ASSERT_EQ(result.found.warnings.size(), 1U);
    expect_contains(result.found.warnings[0], "line 1: 'ATOM': a record behind blanks");
}

}  // namespace
}  // namespace meniscus::reading
