// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "summary_text.h"

#include <gtest/gtest.h>

namespace meniscus::cli {

TEST(SummaryText, CountsInWords) {
    EXPECT_EQ(counted(1, "atom", "atoms"), "1 atom");
    EXPECT_EQ(counted(0, "atom", "atoms"), "0 atoms");
}

TEST(SummaryText, LinesAreIndentedAndEnded) {
    EXPECT_EQ(summary_line("time", "now"), "  time        now\n");
    EXPECT_EQ(describe_run({.threads = 1, .peak_memory_mb = 12.0, .seconds = {.total = 1.5}}),
              "  time        1.50 s on 1 thread, 12 MB\n");
    EXPECT_EQ(describe_files({{"a.csv", OutputKind::Table}, {"b\n.pdb", OutputKind::StructureCopy}}),
              "  written     a.csv, b .pdb\n");
    EXPECT_EQ(describe_files({}), "");
}

TEST(SummaryText, TellsRadiiOfTheFileFromASet) {
    EXPECT_EQ(describe_radii("file"), "radii of the file");
    EXPECT_EQ(describe_radii("bondi"), "radii bondi");
}

TEST(SummaryText, ChecksAreOneLineWithTheFailedOnesFirst) {
    const std::vector<Check> checks{{"closed", true, 1, 1}, {"volume", false, 3, 2}, {"pieces", true, 0, 0}};
    EXPECT_EQ(describe_checks(checks), "  checks      FAILED: volume; passed: closed, pieces\n");
    EXPECT_EQ(describe_checks(std::span(checks).first(1)), "  checks      passed: closed\n");
    EXPECT_EQ(describe_checks(std::span(checks).subspan(1, 1)), "  checks      FAILED: volume\n");
    EXPECT_EQ(describe_checks({}), "");
}

TEST(SummaryText, DisputedPatchesAreNamed) {
    const std::vector<std::string> names{"patches of atom 1", "patches of atom 2"};
    EXPECT_EQ(disputed_patches(true, names), "");
    EXPECT_EQ(disputed_patches(false, names), "exact_agreement (patches of atom 1; patches of atom 2)");
    Measures measures;
    EXPECT_TRUE(agreement_check(measures).passed);
    measures.agreed = false;
    EXPECT_FALSE(agreement_check(measures).passed);
    EXPECT_EQ(agreement_check(measures).name, "exact_agreement");
}

}  // namespace meniscus::cli
