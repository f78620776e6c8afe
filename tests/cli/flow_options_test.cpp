// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>

#include "meniscus/errors.h"
#include "parse_options.h"
#include "surface_request.h"

namespace meniscus::cli {

namespace {

FlowOptions parsed(std::vector<std::string> words) {
    words.insert(words.begin(), "1abc.pdb");
    return request_of(words, add_surface_options).surface.flow;
}

}  // namespace

TEST(FlowOptions, NamesThreeFlows) {
    EXPECT_EQ(parsed({}), kAnchoredFlow);
    EXPECT_EQ(parsed({"--flow", "anchored"}), FlowOptions{});
    EXPECT_EQ(parsed({"--flow", "parallel"}), kParallelFlow);
    EXPECT_EQ(parsed({"--flow", "paper"}), kPaperFlow);
}

TEST(FlowOptions, PiecesReplaceThoseOfTheFlowWhateverTheOrder) {
    FlowOptions expected = kPaperFlow;
    expected.solver = Solver::Cg;
    expected.half_width = 3.5;
    EXPECT_EQ(parsed({"--flow", "paper", "--solver", "cg", "--half-width", "3.5"}), expected);
    EXPECT_EQ(parsed({"--solver", "cg", "--half-width", "3.5", "--flow", "paper"}), expected);
}

TEST(FlowOptions, TakesEveryPiece) {
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

TEST(FlowOptions, RefusesWhatMakesNoSense) {
    EXPECT_THROW(parsed({"--curvature", "flat"}), UsageError);
    EXPECT_THROW(parsed({"--reinitialise", "often"}), UsageError);
    EXPECT_THROW(parsed({"--solver", "direct"}), UsageError);
    EXPECT_THROW(parsed({"--anchor=-1"}), UsageError);
    EXPECT_THROW(parsed({"--time-step=-inf"}), UsageError);
    EXPECT_THROW(parsed({"--time-step", "0"}), UsageError);
    EXPECT_THROW(parsed({"--snapshots", "0"}), UsageError);
}

}  // namespace meniscus::cli
