// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/steady_state.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "flow/small_flow.h"
#include "flow/spline_system.h"

namespace meniscus::testing {
namespace {

constexpr double kProbeRadius = 1.4;

TEST(SteadyState, IsOneSolveOnlyWhereTheStartDoesNotMatter) {
    EXPECT_TRUE(is_one_solve(kAnchoredFlow));
    EXPECT_TRUE(is_one_solve({.curvature = CurvatureField::Sharp, .anchor = 4.0, .solver = Solver::Gmres}));
    EXPECT_FALSE(is_one_solve({.time_step = 16.0}));
    EXPECT_FALSE(is_one_solve({.slope = Slope::Computed}));
    EXPECT_FALSE(is_one_solve({.reinitialiser = Reinitialiser::ClosestPoint}));
    EXPECT_FALSE(is_one_solve(kParallelFlow));
}

TEST(SteadyState, SolvesItsEquationNearTheSurfaceAndKeepsTheDistanceElsewhere) {
    const FlowProblem problem(two_spheres(3.0), kProbeRadius, 0.5);
    const FlowOptions options;
    const EvolutionResult result = solve_steady_state(*problem.grid, problem.band, options);
    EXPECT_TRUE(result.converged());
    EXPECT_EQ(result.steps, 1);
    const double h = problem.grid->spacing();
    const double lambda = options.anchor / (h * h);
    const BlockFill fill = fill_by_sign(*problem.grid, problem.band.distance, problem.margin);
    NodeField image(problem.grid->node_count(), 0.0F);
    apply_everywhere(lambda * spline_value() - spline_laplacian(h), {*problem.grid, result.state.coefficients, fill},
                     image);
    double squares = 0.0;
    double count = 0.0;
    for (std::size_t n = 0; n < image.size(); ++n) {
        const float s = problem.band.distance[n];
        if (std::abs(s) < options.half_width * h) {
            squares += std::pow((image[n] + 2.0 * problem.band.curvature[n]) / lambda - s, 2);
            count += 1.0;
        } else {
            ASSERT_EQ(result.state.values[n], s);
        }
    }
    EXPECT_LT(std::sqrt(squares / count), 1.1 * kSolverAccuracy * h);
}

// evolve() with a step so long that nothing is left of the start.
TEST(SteadyState, IsWhereLongStepsEnd) {
    const FlowProblem problem(two_spheres(3.0), kProbeRadius, 0.5);
    const EvolutionResult one = solve_steady_state(*problem.grid, problem.band, {});
    const EvolutionResult steps = problem.evolve(-0.5, {.time_step = 1e6, .tolerance = 1e-6});
    for (std::size_t n = 0; n < one.state.values.size(); ++n)
        if (std::abs(problem.band.distance[n]) < problem.grid->spacing()) {
            ASSERT_NEAR(one.state.values[n], steps.state.values[n], 2e-4);
        }
}

TEST(SteadyState, VanishesWhereThereIsNoSurface) {
    const FlowProblem problem(two_spheres(3.0), kProbeRadius, 0.5);
    DistanceBand empty = problem.band;
    std::ranges::fill(empty.distance, static_cast<float>(empty.margin));
    EXPECT_EQ(solve_steady_state(*problem.grid, empty, {}).end, FlowEnd::Vanished);
}

}  // namespace
}  // namespace meniscus::testing
