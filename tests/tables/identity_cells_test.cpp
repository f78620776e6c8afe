// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "tables/identity_cells.h"

#include <gtest/gtest.h>

#include "meniscus/errors.h"
#include "small_complex.h"

namespace meniscus {
namespace {

using testing::small_complex;

TEST(IdentityCells, MatchTheirColumns) {
    const Structure s = small_complex();
    EXPECT_EQ(atom_identity(s, 2).size(), identity_columns(RowsPer::Atom).size());
    EXPECT_EQ(residue_identity(s.residues[1]).size(), identity_columns(RowsPer::Residue).size());
    EXPECT_EQ(std::get<std::string>(residue_identity(s.residues[1])[2]), "B");
    EXPECT_EQ(std::get<std::string>(residue_identity(s.residues[0])[2]), "");
    EXPECT_EQ(std::get<std::int64_t>(atom_identity(s, 2)[0]), 2);
    EXPECT_EQ(std::get<std::string>(atom_identity(s, 2)[5]), "SE");
}

TEST(IdentityCells, LabelsReadAsPeopleWriteThem) {
    EXPECT_EQ(residue_label(small_complex().residues[1]), "A:MSE2B");
    EXPECT_EQ(residue_label({.chain = "", .name = "GLY", .number = -3, .insertion_code = ' '}), "GLY-3");
    EXPECT_EQ(residue_label({}), "");
}

TEST(IdentityCells, RefuseStructuresThatDoNotMatch) {
    Structure s = small_complex();
    EXPECT_NO_THROW(check_match(s, 6));
    EXPECT_THROW(check_match(s, 5), UsageError);
    s.labels[0].residue = 4;
    EXPECT_THROW(check_match(s, 6), UsageError);
}

}  // namespace
}  // namespace meniscus
