// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "compare_report.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace meniscus::cli {

namespace {

CompareFacts facts() {
    CompareFacts facts;
    facts.a.file = "a.obj";
    facts.a.surface.area = 10.0;
    facts.a.surface.merged_vertices = 7;
    facts.b.file = "1abc.pdb";
    facts.b.structure.emplace();
    facts.b.structure->radii_set = "bondi";
    facts.b.surface.closed = true;
    facts.comparison.a_to_b = {.mean = 0.25, .p99 = 0.5, .max = 1.0, .signed_mean = -0.125, .points = 4};
    facts.comparison.b_to_a.max = 2.0;
    return facts;
}

}  // namespace

TEST(CompareReport, SummaryTellsBothWays) {
    const std::string text = make_summary({}, facts());
    for (const char* part : {"A: a.obj, mesh", "7 coincident vertices merged", "B: 1abc.pdb, exact surface",
                             "radii bondi", "0.2500", "-0.1250", "Hausdorff", "2.0000"})
        EXPECT_NE(text.find(part), std::string::npos) << part << '\n' << text;
}

TEST(CompareReport, BlocksOfAMeshAndOfAStructure) {
    const auto report = make_report({}, facts());
    EXPECT_EQ(report["a"]["kind"], "mesh");
    EXPECT_EQ(report["a"]["merged_vertices"], 7);
    EXPECT_TRUE(report["a"]["radii"].is_null());
    EXPECT_EQ(report["b"]["kind"], "structure");
    EXPECT_EQ(report["b"]["radii"], "bondi");
    EXPECT_EQ(report["a_to_b"]["signed_mean"], -0.125);
    EXPECT_EQ(report["hausdorff"], 2.0);
}

TEST(CompareReport, WarnsOfMeshesThatAreOpenOrInsideOut) {
    ComparedInput input;
    EXPECT_NE(warnings_of(input).at(0).find("not closed"), std::string::npos);
    input.surface.closed = true;
    EXPECT_NE(warnings_of(input).at(0).find("face inwards"), std::string::npos);
    input.surface.outer_pieces = 1;
    EXPECT_TRUE(warnings_of(input).empty());
    EXPECT_TRUE(notes_of(input).empty());
}

TEST(CompareReport, TellsNotesOfAStructureFromWarnings) {
    CompareFacts both = facts();
    both.b.structure->notes = {"58 waters left out (keep them with --waters)"};
    both.b.structure->warnings = {"1 atom at exactly the position of another atom"};
    const auto report = make_report({}, both);
    EXPECT_EQ(report["b"]["notes"], nlohmann::ordered_json(both.b.structure->notes));
    EXPECT_EQ(report["b"]["warnings"], nlohmann::ordered_json(both.b.structure->warnings));
    EXPECT_TRUE(report["a"]["notes"].empty());
}

}  // namespace meniscus::cli
