// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow_request.h"

#include <gtest/gtest.h>

#include <cmath>

#include "meniscus/errors.h"
#include "parse_options.h"

namespace meniscus::cli {

namespace {

FlowRequest parse_flow(const std::vector<std::string>& words) { return request_of(words, add_flow_options); }

FlowOptions parsed(const std::vector<std::string>& arguments) { return resolve(parse_flow(arguments)); }

}  // namespace

TEST(FlowRequest, NamesThreeFlows) {
    EXPECT_EQ(parsed({}), kAnchoredFlow);
    EXPECT_EQ(parsed({"--flow", "anchored"}), FlowOptions{});
    EXPECT_EQ(parsed({"--flow", "parallel"}), kParallelFlow);
    EXPECT_EQ(parsed({"--flow", "paper"}), kPaperFlow);
}

TEST(FlowRequest, PiecesReplaceThoseOfTheFlowWhateverTheOrder) {
    FlowOptions expected = kPaperFlow;
    expected.solver = Solver::Cg;
    expected.half_width = 3.5;
    EXPECT_EQ(parsed({"--flow", "paper", "--solver", "cg", "--half-width", "3.5"}), expected);
    EXPECT_EQ(parsed({"--solver", "cg", "--half-width", "3.5", "--flow", "paper"}), expected);
}

TEST(FlowRequest, TakesEveryPiece) {
    const FlowOptions flow =
        parsed({"--curvature", "sharp", "--anchor", "4", "--reinitialise", "godunov", "--solver", "gmres", "--slope",
                "computed", "--time-step", "inf", "--half-width", "2", "--max-steps", "7", "--tolerance", "1e-3"});
    EXPECT_EQ(flow.curvature, CurvatureField::Sharp);
    EXPECT_EQ(flow.anchor, 4.0);
    EXPECT_EQ(flow.reinitialiser, Reinitialiser::Godunov);
    EXPECT_EQ(flow.solver, Solver::Gmres);
    EXPECT_EQ(flow.slope, Slope::Computed);
    EXPECT_TRUE(std::isinf(flow.time_step));
    EXPECT_EQ(flow.half_width, 2.0);
    EXPECT_EQ(flow.max_steps, 7);
    EXPECT_EQ(flow.tolerance, 1e-3);
}

TEST(FlowRequest, RefusesWhatMakesNoSense) {
    EXPECT_THROW(parse_flow({"--curvature", "flat"}), UsageError);
    EXPECT_THROW(parse_flow({"--reinitialise", "often"}), UsageError);
    EXPECT_THROW(parse_flow({"--solver", "direct"}), UsageError);
    EXPECT_THROW(parse_flow({"--anchor=-1"}), UsageError);
    EXPECT_THROW(parse_flow({"--time-step=-inf"}), UsageError);
    EXPECT_THROW(parse_flow({"--time-step", "0"}), UsageError);
    EXPECT_THROW(parse_flow({"--snapshots", "0"}), UsageError);
}

TEST(FlowRequest, NamesItsWords) {
    EXPECT_STREQ(name_of(FlowName::Paper), "paper");
    EXPECT_STREQ(name_of(CurvatureField::PaperLiteral), "paper-literal");
    EXPECT_STREQ(name_of(Reinitialiser::ClosestPoint), "closest-point");
    EXPECT_STREQ(name_of(Solver::Gmres), "gmres");
    EXPECT_STREQ(name_of(Slope::Unit), "unit");
    EXPECT_STREQ(name_of(FlowEnd::LeftBand), "left-band");
}

}  // namespace meniscus::cli
