// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Files that users have reported: residues, models and alternatives, and molecules without a polymer.
#include "fragments.h"
#include "support/test_data.h"

namespace meniscus {
namespace {

Structure reported(const std::string& name, const ReadOptions& options = {}) {
    return read_structure((*testing::test_data() / "malformed/reports" / name).string(), options);
}

TEST(ReportedModels, ASegmentOnSomeAtomsPartsNoResidue) {
    MENISCUS_NEED_TEST_DATA();
    const Structure s = reported("segid_mixed.pdb");
    EXPECT_EQ(s.atoms.size(), 7U);
    EXPECT_EQ(s.residues.size(), 1U);
}

TEST(ReportedModels, ABiologicalUnitHasBothCopies) {
    MENISCUS_NEED_TEST_DATA();
    EXPECT_EQ(reported("bio.pdb1").atoms.size(), 67U);
    const Structure both = reported("bio.pdb1", {.join_models = true});
    EXPECT_EQ(both.atoms.size(), 134U);
    EXPECT_EQ(both.residues.back().chain, "A-2");
}

TEST(ReportedModels, ADockedLigandIsAPartner) {
    MENISCUS_NEED_TEST_DATA();
    const Structure receptor = reported("cluspro_like.pdb");
    EXPECT_EQ(receptor.atoms.size(), 67U);
    EXPECT_TRUE(testing::has_warning(receptor, "chain A taken, before END in line 69; chain B follows it"));
    EXPECT_EQ(reported("cluspro_like.pdb", {.join_models = true}).atoms.size(), 134U);
}

TEST(ReportedModels, LettersOfOneAtomCostNoOther) {
    MENISCUS_NEED_TEST_DATA();
    EXPECT_EQ(reported("alt_mixed.pdb").atoms.size(), 6U);
    EXPECT_EQ(reported("alt_mixed.pdb", {.altloc = "B"}).atoms.size(), 6U);
}

TEST(ReportedModels, ASmallMoleculeIsKept) {
    MENISCUS_NEED_TEST_DATA();
    EXPECT_EQ(reported("rdkit_lig.pdb").atoms.size(), 3U);
    EXPECT_THROW(reported("rdkit_lig.pdb", {.hetero = HeteroPolicy::None}), InputError);
}

}  // namespace
}  // namespace meniscus
