// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "values/identity_index.h"

#include <gtest/gtest.h>

#include "tables/small_complex.h"

namespace meniscus {
namespace {

TEST(IdentityIndex, ColumnsMustTellAtomsApart) {
    const Structure structure = testing::small_complex();
    const IdentityIndex index(structure);
    for (const IdentityColumns& enough :
         {IdentityColumns{{"index", 0}}, {{"serial", 0}}, {{"chain", 0}}, {{"chain", 0}, {"resnum", 1}, {"name", 2}}})
        EXPECT_EQ(index.missing_columns(enough), "");
    for (const IdentityColumns& wanting :
         {IdentityColumns{}, {{"resname", 0}}, {{"resnum", 0}}, {{"chain", 0}, {"name", 1}}})
        EXPECT_NE(index.missing_columns(wanting), "");
}

TEST(IdentityIndex, CopiesKnowTheirOriginal) {
    Structure structure = testing::small_complex();
    const IdentityIndex alone(structure);
    for (std::uint32_t atom = 0; atom < 6; ++atom) EXPECT_FALSE(alone.original_of(atom)) << atom;
    structure.residues[2].chain = "A-2";
    EXPECT_EQ(IdentityIndex(structure).original_of(4), 0U);
}

}  // namespace
}  // namespace meniscus
