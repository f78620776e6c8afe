// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "meniscus/errors.h"
#include "meniscus/tables.h"
#include "small_complex.h"

namespace meniscus {
namespace {

using testing::small_complex;

class InterfaceTable : public ::testing::Test {
protected:
    Structure structure_ = small_complex();
    std::vector<ChainInterface> interfaces_ =
        chain_interfaces(structure_, std::vector<ChainPair>{{{"A", "LONG"}, {"B"}}});

    Table table(RowsPer per) const { return interface_table(structure_, interfaces_, per); }
};

TEST_F(InterfaceTable, HasOneRowPerMemberOfEitherSide) {
    EXPECT_EQ(table(RowsPer::Atom).rows.size(), 6u);
    EXPECT_EQ(table(RowsPer::Residue).rows.size(), 4u);
    EXPECT_EQ(table(RowsPer::Chain).rows.size(), 3u);
    const Table chains = table(RowsPer::Chain);
    EXPECT_EQ(std::get<std::string>(chains.rows[0][0]), "A,LONG:B");
    EXPECT_EQ(std::get<std::string>(chains.rows[0][1]), "a");
    EXPECT_EQ(std::get<std::string>(chains.rows[2][1]), "b");
    EXPECT_EQ(std::get<std::string>(chains.rows[1][2]), "LONG");
}

TEST_F(InterfaceTable, SumsToTheTotals) {
    const Interface& areas = interfaces_[0].areas;
    for (const RowsPer per : {RowsPer::Atom, RowsPer::Residue, RowsPer::Chain}) {
        const Table found = table(per);
        const std::size_t last = found.columns.size();
        double buried_sas = 0.0;
        double buried_ses = 0.0;
        for (const auto& row : found.rows) {
            ASSERT_EQ(row.size(), last);
            buried_sas += std::get<double>(row[last - 4]);
            buried_ses += std::get<double>(row[last - 1]);
        }
        EXPECT_NEAR(buried_sas, areas.buried_sas(), 1e-11 * areas.sas_ab);
        EXPECT_NEAR(buried_ses, areas.buried_ses(), 1e-11 * areas.ses_ab);
    }
}

TEST_F(InterfaceTable, HasNoCavities) { EXPECT_THROW(table(RowsPer::Cavity), UsageError); }

}  // namespace
}  // namespace meniscus
