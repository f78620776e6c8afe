// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "meniscus/errors.h"
#include "meniscus/tables.h"
#include "small_complex.h"
#include "support/arrangements.h"

namespace meniscus {
namespace {

using testing::small_complex;

std::size_t column_of(const Table& table, const std::string& name) {
    const auto found = std::find(table.columns.begin(), table.columns.end(), name);
    EXPECT_NE(found, table.columns.end()) << name;
    return static_cast<std::size_t>(found - table.columns.begin());
}

double sum_of(const Table& table, const std::string& name) {
    double sum = 0.0;
    for (const auto& row : table.rows) sum += std::get<double>(row[column_of(table, name)]);
    return sum;
}

void expect_even(const Table& table) {
    for (const auto& row : table.rows) EXPECT_EQ(row.size(), table.columns.size());
}

// Atoms round a ball of solvent, as in a fullerene: one cavity.
Structure hollow_sphere() {
    Structure s;
    s.residues = {{.chain = "A", .name = "LEU", .number = 12, .insertion_code = ' '},
                  {.chain = "A", .name = "VAL", .number = 15, .insertion_code = 'A'}};
    for (const Vec3& centre : testing::hollow_shell(150, 6.0, 1.5).centres)
        testing::add_atom(s, centre, 1.5, centre.z > 0.0 ? 0 : 1, "C");
    return s;
}

TEST(MeasuresTable, EveryTableOfAreasSumsToTheTotals) {
    const Structure s = small_complex();
    const Measures measures = measure(s.atoms);
    const std::pair<RowsPer, std::size_t> expected[] = {{RowsPer::Atom, 6}, {RowsPer::Residue, 4}, {RowsPer::Chain, 3}};
    for (const auto& [per, rows] : expected) {
        const Table table = measures_table(s, measures, per);
        EXPECT_EQ(table.rows.size(), rows);
        expect_even(table);
        EXPECT_NEAR(sum_of(table, "sas_area"), measures.totals.sas_area, 1e-11 * measures.totals.sas_area);
        EXPECT_NEAR(sum_of(table, "ses_area"), measures.totals.ses_area, 1e-11 * measures.totals.ses_area);
        EXPECT_NEAR(sum_of(table, "reentrant_area"), measures.totals.reentrant_area, 1e-11 * measures.totals.ses_area);
    }
}

TEST(MeasuresTable, BuriedAtomsAreListedWithZero) {
    const Structure s = small_complex();
    const Table table = measures_table(s, measure(s.atoms, {.depth = true}), RowsPer::Atom);
    const auto& row = table.rows[3];
    for (const char* name : {"sas_area", "ses_area", "contact_area", "toroidal_area", "reentrant_area"})
        EXPECT_EQ(std::get<double>(row[column_of(table, name)]), 0.0) << name;
    EXPECT_TRUE(std::get<bool>(row[column_of(table, "buried")]));
    EXPECT_FALSE(std::get<bool>(table.rows[0][column_of(table, "buried")]));
    EXPECT_GT(std::get<double>(row[column_of(table, "depth")]), 0.5);
}

TEST(MeasuresTable, WhatIsNotKnownIsEmpty) {
    const Structure s = small_complex();
    const Table residues = measures_table(s, measure(s.atoms), RowsPer::Residue);
    EXPECT_TRUE(std::holds_alternative<std::monostate>(residues.rows[1][column_of(residues, "rsa")]));
    EXPECT_TRUE(std::holds_alternative<std::monostate>(residues.rows[0][column_of(residues, "max_depth")]));
    EXPECT_GT(std::get<double>(residues.rows[3][column_of(residues, "rsa")]), 0.6);
}

TEST(MeasuresTable, OneRowPerCavity) {
    const Structure s = hollow_sphere();
    const Measures measures = measure(s.atoms);
    ASSERT_EQ(measures.components.size(), 2u);
    const Table table = measures_table(s, measures, RowsPer::Cavity);
    ASSERT_EQ(table.rows.size(), 1u);
    expect_even(table);
    const auto number = [&](const char* name) { return std::get<double>(table.rows[0][column_of(table, name)]); };
    EXPECT_EQ(std::get<std::int64_t>(table.rows[0][column_of(table, "component")]), 1);
    EXPECT_EQ(std::get<std::int64_t>(table.rows[0][column_of(table, "inside_of")]), 0);
    EXPECT_EQ(std::get<std::string>(table.rows[0][column_of(table, "residues")]), "A:LEU12 A:VAL15A");
    EXPECT_NEAR(number("inscribed_radius"), 4.5, 0.05);
    EXPECT_NEAR(number("centre_x"), 0.0, 0.1);
    EXPECT_GT(number("ses_volume"), 4.0 / 3.0 * 3.1415 * std::pow(4.5, 3));
    EXPECT_TRUE(measures_table(small_complex(), measure(small_complex().atoms), RowsPer::Cavity).rows.empty());
}

TEST(MeasuresTable, MeasuresOfOtherAtomsAreRefused) {
    EXPECT_THROW(measures_table(small_complex(), Measures{}, RowsPer::Atom), UsageError);
}

}  // namespace
}  // namespace meniscus
