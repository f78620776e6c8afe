// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>

#include "meniscus/page.h"
#include "support/small_structures.h"

namespace meniscus {
namespace {

std::string value_of(const std::vector<PageRow>& rows, std::string_view label, std::string_view section = "") {
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const PageRow& r) {
        return r.label == label && (section.empty() || r.section == section);
    });
    return found == rows.end() ? "" : found->value;
}

struct SmallRun {
    Structure structure = testing::two_atoms();
    Surface surface;
    Measures exact;
    std::vector<PageRow> rows() const { return page_rows(structure, surface, exact); }
};

TEST(PageRows, HoldAreasAndCountsOfPieces) {
    SmallRun run;
    run.exact.totals.ses_area = 123.456;
    run.exact.components.resize(3);
    run.exact.components[1].kind = ComponentKind::Cavity;
    const auto rows = run.rows();
    EXPECT_EQ(value_of(rows, "area", "Solvent-excluded surface, exact"), "123.5 Å²");
    EXPECT_EQ(value_of(rows, "cavities"), "1");
    EXPECT_EQ(value_of(rows, "outer pieces"), "2");
    EXPECT_EQ(value_of(rows, "atoms"), "2");
}

TEST(PageRows, HaveCommasBetweenThousands) {
    SmallRun run;
    run.exact.totals.ses_area = 1234567.89;
    run.exact.totals.ses_volume = 999.9;
    run.exact.totals.sas_area = 1000;
    run.surface.mesh.vertices.resize(12345);
    EXPECT_EQ(value_of(run.rows(), "area", "Solvent-excluded surface, exact"), "1,234,567.9 Å²");
    EXPECT_EQ(value_of(run.rows(), "volume", "Solvent-excluded surface, exact"), "999.9 Å³");
    EXPECT_EQ(value_of(run.rows(), "area", "Solvent-accessible surface, exact"), "1,000.0 Å²");
    EXPECT_EQ(value_of(run.rows(), "vertices"), "12,345");
}

TEST(PageRows, CanDoWithoutExactNumbers) {
    SmallRun run;
    run.surface.corrected_area = 123.456;
    run.surface.checks = {{"closed", true, 1, 1}};
    const auto rows = page_rows(run.structure, run.surface);
    for (const PageRow& row : rows) EXPECT_EQ(row.section.find(", exact"), std::string::npos) << row.section;
    EXPECT_EQ(value_of(rows, "area", "This mesh"), "123.5 Å²");
    EXPECT_EQ(value_of(rows, "passed"), "1 of 1");
}

TEST(PageRows, NameFilesWithoutTheirFolders) {
    SmallRun run;
    run.structure.file = "/somewhere/private/a\nb.pdb";
    run.structure.radii_set = "/somewhere/private/my.rules";
    for (const PageRow& row : run.rows()) {
        EXPECT_EQ(row.value.find("private"), std::string::npos) << row.label;
        EXPECT_EQ(row.value.find('\n'), std::string::npos) << row.label;
    }
    EXPECT_EQ(value_of(run.rows(), "radii"), "my.rules");
}

TEST(PageRows, TellWhatFailed) {
    SmallRun run;
    run.surface.checks = {{"closed", true, 1, 1}, {"converged", false, 0, 1}};
    EXPECT_EQ(value_of(run.rows(), "passed"), "2 of 3");
    EXPECT_EQ(value_of(run.rows(), "failed"), "converged");
}

}  // namespace
}  // namespace meniscus
