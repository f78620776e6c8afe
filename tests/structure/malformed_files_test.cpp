// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Every file of the collection of malformed inputs, with what becomes of it.
#include <algorithm>
#include <array>
#include <set>

#include "fragments.h"
#include "support/test_data.h"

namespace meniscus {
namespace {

struct Expected {
    const char* file;
    std::size_t atoms;      ///< 0: an error
    const char* says = "";  ///< part of the error, of a note or of a warning
};

constexpr auto kFiles = std::to_array<Expected>({
    {"biotite/altloc.cif", 14, "20 atoms of alternative locations left out"},
    {"biotite/hetatm.pdb", 5, "hetero groups are kept: 1 LIG"},
    {"biotite/res_ids.cif", 23, "12 NAG, 6 FUC left out (keep "},
    {"chemfiles/MOF-5.pdb", 53, "hetero groups are kept: 1 LIG"},
    {"chemfiles/atom-id-0.pdb", 2, "hetero groups are kept: 1 EST"},
    {"chemfiles/crystal-maker.pdb", 8, "8 MOL XE"},
    {"chemfiles/end-endmdl.pdb", 2, "line 13: this MODEL number occurs more than once"},
    {"chemfiles/hemo.pdb", 449, "1 HEM left out (keep "},
    {"chemfiles/insertion-code.pdb", 3, "2 atoms at exactly the position of another atom"},
    {"chemfiles/model.pdb", 2223, "model 1 of 2 taken"},
    {"chemfiles/odd-start.pdb", 20, "hetero groups are kept: 1 EST"},
    {"chemfiles/psfgen-output.pdb", 26, "7 elements taken from atom names"},
    {"chemfiles/short-atom.pdb", 9, "9 elements in non-standard residues guessed"},
    {"chemfiles/short-cryst1.pdb", 9, "9 elements in non-standard residues guessed"},
    {"freesasa/1ubq.occ.pdb", 3, "3 elements taken from atom names"},
    {"freesasa/alt_model_twochain.pdb", 36, "1 atom of alternative locations left out"},
    {"freesasa/dummy.pdb", 0, "no atoms in this file"},
    {"freesasa/empty.pdb", 0, "no atoms in this file"},
    {"freesasa/empty_model.pdb", 0, "no atoms in this file"},
    {"freesasa/icode.pdb", 5},
    {"freesasa/model_mismatch.pdb", 1, "line 5: atoms outside MODEL and ENDMDL"},
    {"pdb-tools/anisou.pdb", 12},
    {"pdb-tools/anisou_altloc.pdb", 12, "3 atoms of alternative locations left out"},
    {"pdb-tools/anisou_missing.pdb", 4},
    {"pdb-tools/dummy.pdb", 175, "8 waters left out (keep "},
    {"pdb-tools/dummy_altloc.pdb", 21, "5 atoms of alternative locations left out"},
    {"pdb-tools/dummy_altloc2.pdb", 21, "9 atoms of alternative locations left out"},
    {"pdb-tools/dummy_altloc3.pdb", 25, "10 atoms of alternative locations left out"},
    {"pdb-tools/dummy_az09.pdb", 175, "1 CA left out (keep "},
    {"pdb-tools/dummy_insertions.pdb", 223, "8 waters left out"},
    {"pdb-tools/dummy_nohead.pdb", 13, "5 elements taken from atom names"},
    {"pdb-tools/ensemble_OK.cif", 2, "model 1 of 2 taken"},
    {"pdb-tools/ensemble_OK.pdb", 2, "model 1 of 2 taken"},
    {"pdb-tools/ensemble_error_1.pdb", 2, "line 8: this model has a different number of atoms"},
    {"pdb-tools/ensemble_error_2.pdb", 2, "line 4: atoms outside MODEL and ENDMDL"},
    {"pdb-tools/ensemble_error_3.pdb", 2, "line 8: this MODEL is never closed"},
    {"pdb-tools/ensemble_error_4.pdb", 2, "line 4: this MODEL is never closed"},
    {"pdb-tools/ensemble_error_MODEL.pdb", 2, "line 10: MODEL without a number"},
    {"pdb-tools/ensemble_more_OK.pdb", 4, "line 9: this model has a different number of atoms"},
    {"pdb-tools/hetatm.pdb", 2, "3 UNK left out (keep "},
    {"pdb-tools/hetatm_bad.pdb", 2, "hetero groups are kept: 1 UNK"},
    {"pdb-tools/hetatm_ensemble.pdb", 20, "hetero groups are kept: 1 G39"},
    {"pdb-tools/vu7.pdb", 30, "hetero groups are kept: 1 VU7"},
});

std::filesystem::path folder() { return *testing::test_data() / "malformed"; }

TEST(MalformedFiles, EndAsTheyShould) {
    MENISCUS_NEED_TEST_DATA();
    for (const Expected& expected : kFiles) {
        try {
            const Structure s = read_structure((folder() / expected.file).string());
            EXPECT_EQ(s.atoms.size(), expected.atoms) << expected.file;
            const std::string says = expected.says;
            EXPECT_TRUE(says.empty() || testing::has_note(s, says) || testing::has_warning(s, says)) << expected.file;
            EXPECT_TRUE(std::all_of(s.atoms.centres.begin(), s.atoms.centres.end(), is_finite)) << expected.file;
        } catch (const InputError& error) {
            EXPECT_EQ(expected.atoms, 0U) << error.what();
            testing::expect_contains(error.what(), expected.says);
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << "one line";
        }
    }
}

TEST(MalformedFiles, ReadWithEverythingKeptWheneverThereAreAtoms) {
    MENISCUS_NEED_TEST_DATA();
    for (const Expected& expected : kFiles) {
        const ReadOptions all{.hetero = HeteroPolicy::All, .keep_waters = true};
        try {
            EXPECT_GE(read_structure((folder() / expected.file).string(), all).atoms.size(), 1U) << expected.file;
        } catch (const InputError& error) {
            testing::expect_contains(error.what(), "no atoms in this file");
        }
    }
}

TEST(MalformedFiles, AreAllListedHere) {
    MENISCUS_NEED_TEST_DATA();
    std::set<std::string> listed{"INDEX.md"};
    for (const Expected& expected : kFiles) listed.insert(expected.file);
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder())) {
        const std::string name = std::filesystem::relative(entry.path(), folder()).string();
        if (name.starts_with("reports/")) continue;  // what users have reported is a list of its own
        EXPECT_TRUE(!entry.is_regular_file() || listed.contains(name)) << name;
    }
}

}  // namespace
}  // namespace meniscus
