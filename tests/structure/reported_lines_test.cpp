// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Lines of files that users have reported to other projects, and what becomes of them.
#include <map>

#include "fragments.h"
#include "support/test_data.h"

namespace meniscus {
namespace {

using testing::error_of;
using testing::expect_contains;
using testing::has_note;
using testing::has_warning;
using testing::pdb_line;
using testing::read_text;

std::string reported_lines_of(const std::string& name) {
    return (*testing::test_data() / "malformed/reports" / name).string();
}

struct Said {
    const char* file;
    const char* warning;
};

TEST(ReportedLines, AllAtomsAreReadWithOneWarning) {
    MENISCUS_NEED_TEST_DATA();
    for (const auto& [file, warning] :
         {Said{"zdock_marked.pdb", "line 1: B factor '1 1.' is not a number; taken as missing (67 times)"},
          {"bnan.pdb", "line 1: B factor 'nan' is not a number; taken as missing (67 times)"},
          {"charge_word.cif",
           "line 24: _atom_site.pdbx_formal_charge '1+' is not a number; taken as missing (67 times)"},
          {"packmol_leading.pdb", "line 31: 'ATOM': a record behind blanks"},
          {"nulpad.pdb", "line 69: zero bytes behind the last record, left out"}}) {
        const Structure s = read_structure(reported_lines_of(file));
        EXPECT_EQ(s.atoms.size(), 67U) << file;
        EXPECT_EQ(s.warnings.size(), 1U) << file;
        EXPECT_TRUE(has_warning(s, warning)) << file << ": " << s.warnings.at(0);
        EXPECT_EQ(s.atoms.centres.at(30).x, 25.288) << file;
    }
}

TEST(ReportedLines, ATwoLetterChainShiftsTheRest) {
    MENISCUS_NEED_TEST_DATA();
    try {
        read_structure(reported_lines_of("boltz_lig.pdb"));
        FAIL();
    } catch (const InputError& error) {
        expect_contains(error.what(),
                        "boltz_lig.pdb:69:22: columns are shifted by 1 to the right from the chain name 'B1' on");
    }
}

TEST(ReportedLines, HalogensWithoutColumnsOfTheirElements) {
    MENISCUS_NEED_TEST_DATA();
    const Structure s = read_structure(reported_lines_of("halogens_noelem.pdb"), {.hetero = HeteroPolicy::All});
    std::map<std::string, int> found;
    for (const AtomLabel& label : s.labels) ++found[label.element];
    EXPECT_EQ(found,
              (std::map<std::string, int>{{"CL", 7}, {"BR", 5}, {"SE", 1}, {"FE", 1}, {"F", 1}, {"I", 1}, {"SI", 1}}));
    EXPECT_TRUE(
        has_warning(s, "17 elements in non-standard residues guessed from atom names: 7 Cl, 5 Br, 1 F, 1 Fe, 1 I"));
}

const std::string kTwo = pdb_line({.x = 1.0}) + pdb_line({.name = " CB ", .x = 2.5});

TEST(ReportedLines, FieldsThatNoResultNeedsHaveTheirDefaults) {
    std::string text = kTwo;
    text.replace(54, 12, "  ****nan   ");
    const Structure s = read_text(text, "a.pdb");
    EXPECT_EQ(s.labels.at(0).occupancy, 1.0);
    EXPECT_EQ(s.labels.at(0).b_factor, 0.0);
    EXPECT_EQ(s.labels.at(1).b_factor, 10.0);
    EXPECT_TRUE(has_warning(s, "line 1: occupancy '****' is not a number; taken as missing"));
    EXPECT_TRUE(has_warning(s, "line 1: B factor 'nan' is not a number; taken as missing"));
}

TEST(ReportedLines, ModelsInLowerCaseAreModels) {
    std::string lower = kTwo;
    std::transform(lower.begin(), lower.end(), lower.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? c + 32 : c; });
    const Structure s = read_text("model 1\n" + lower + "endmdl\nmodel 2\n" + lower + "endmdl\nend\n", "a.pdb");
    EXPECT_EQ(s.atoms.centres, read_text(kTwo, "a.pdb").atoms.centres);
    EXPECT_EQ(s.residues.at(0).name, "ALA");
    EXPECT_EQ(s.labels.at(1).name, "CB");
    EXPECT_TRUE(has_note(s, "line 1: the name of a record in lower case"));
    EXPECT_TRUE(s.warnings.empty());
}

TEST(ReportedLines, AFileOfNoKnownRecordSaysWhatItHas) {
    std::string text = kTwo;
    text.replace(0, 4, "ATM ");
    EXPECT_EQ(read_text(text, "a.pdb").atoms.size(), 1U);
    EXPECT_TRUE(has_warning(read_text(text, "a.pdb"), "line 1: 'ATM' is not a record of the PDB format"));
    expect_contains(error_of(text.substr(0, text.find('\n') + 1), "a.pdb"),
                    "no atoms in this file; check that it is the right one (line 1: 'ATM' is not a record");
}

TEST(ReportedLines, ElementsThatAnMmcifFileDoesNotGiveAreTold) {
    const Structure s = read_text(
        "data_x\nloop_\n_atom_site.label_atom_id\n_atom_site.label_comp_id\n_atom_site.Cartn_x\n_atom_site.Cartn_y\n"
        "_atom_site.Cartn_z\nCA ALA 1 2 3\nCL1 LIG 5 6 7\nBR2 UNK 9 9 9\n",
        "a.cif");
    EXPECT_TRUE(has_note(s, "1 element taken from atom names: _atom_site.type_symbol is not given"));
    EXPECT_TRUE(has_warning(s, "guessed from atom names: 1 Br, 1 Cl (_atom_site.type_symbol is not given)"));
}

}  // namespace
}  // namespace meniscus
