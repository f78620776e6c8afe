// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/evolution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "flow/small_flow.h"
#include "flow/spline_system.h"
#include "meniscus/threads.h"

namespace meniscus::testing {
namespace {

constexpr double kProbe = 1.4;
constexpr double kAccurate = 1e-6;  // tolerance far below what is compared

const Atoms kOneSphere{{{0.1, -0.2, 0.3}}, {1.7}};

std::vector<Arrangement> few_spheres() {
    return {
        {"one", kOneSphere},
        {"two overlapping", two_spheres(1.23, 1.7, 1.52)},
        {"two bridged", two_spheres(4.5, 2.0, 1.4)},
        {"two spindle", two_spheres(5.9)},
        {"two apart", two_spheres(9.0)},
        {"four in a square", equal_spheres({{0, 0, 0}, {2.4, 0, 0}, {2.4, 2.4, 0}, {0, 2.4, 0}}, 1.5)},
        {"four in a tetrahedron", tetrahedral_spheres(2.4, 1.5)},
        {"four isolated", tetrahedral_spheres(9.6, 1.7)},
    };
}

struct Difference {
    double mean = 0.0;
    double max = 0.0;
};

// Of two fields over nodes with |s| below one spacing, in spacings.
Difference difference(const FlowProblem& problem, const NodeField& a, const NodeField& b) {
    const double h = problem.grid->spacing();
    Difference total;
    double count = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n) {
        if (std::abs(problem.band.distance[n]) >= h) continue;
        const double here = std::abs(double{a[n]} - b[n]) / h;
        total.max = std::max(total.max, here);
        total.mean += here;
        count += 1.0;
    }
    total.mean /= count;
    return total;
}

void expect_right_signs(const FlowProblem& problem, const EvolutionResult& result) {
    const double unclear = 0.4 * problem.grid->spacing();  // cusps are rounded
    for (std::size_t n = 0; n < result.state.values.size(); ++n) {
        const double s = problem.band.distance[n];
        if (std::abs(s) < unclear) continue;
        ASSERT_EQ(result.state.values[n] < 0.0F, s < 0.0) << "node " << n << ", s = " << s;
    }
}

struct Ratios {
    double distance;
    double curvature;
};

// How much smaller the mean errors become as h halves.
template <class Counts>
Ratios order_of(const Atoms& atoms, double h, const Counts& counts) {
    SurfaceErrors errors[2];
    for (int half = 0; half < 2; ++half) {
        const FlowProblem problem(atoms, kProbe, half == 0 ? h : 0.5 * h);
        errors[half] = errors_on_surface(problem, problem.level_set(problem.evolve(-1.0)), atoms, counts);
        EXPECT_GT(errors[half].count, 200);
    }
    return {std::log2(errors[0].mean_distance / errors[1].mean_distance),
            std::log2(errors[0].mean_curvature / errors[1].mean_curvature)};
}

float value_near(const FlowProblem& problem, const NodeField& field, const Vec3& p) {
    const double h = problem.grid->spacing();
    const Lattice lattice{.spacing = h, .origin = problem.grid->origin()};
    const BlockId block = problem.grid->find(lattice.block_of(p));
    EXPECT_NE(block, kNoBlock);
    if (block == kNoBlock) return std::nanf("");
    const Vec3 at = (1.0 / h) * (p - problem.grid->corner(block));
    const int node = node_in_block(static_cast<int>(at.x), static_cast<int>(at.y), static_cast<int>(at.z));
    return field[std::size_t{block} * kBlockNodes + static_cast<std::size_t>(node)];
}

TEST(Evolution, ReachesTheSameSteadyStateFromEveryStartAndTimeStep) {
    for (const Arrangement& a : few_spheres()) {
        SCOPED_TRACE(a.name);
        const FlowProblem problem(a.atoms, kProbe, 0.25);
        const EvolutionResult expected = problem.evolve(-1.0, {.tolerance = kAccurate});
        EXPECT_TRUE(expected.converged());
        for (const double c : {-4.0, -0.5, -0.2})
            for (const double step : {1.0, 16.0, 64.0}) {
                const EvolutionResult other = problem.evolve(c, {.time_step = step, .tolerance = kAccurate});
                EXPECT_TRUE(other.converged());
                // Which nodes beyond three spacings are unknowns depends on the way: hence more than rounding.
                const Difference apart = difference(problem, expected.state.coefficients, other.state.coefficients);
                EXPECT_LT(apart.mean, 1e-4);
                EXPECT_LT(apart.max, 1e-3);
            }
    }
}

TEST(Evolution, ConvergesInAFewStepsWithTheRightSignsEverywhere) {
    for (const Arrangement& a : few_spheres())
        for (const double h : {0.5, 0.25}) {
            SCOPED_TRACE(a.name);
            const FlowProblem problem(a.atoms, kProbe, h);
            for (const double c : {-4.0, -0.2}) {
                const EvolutionResult result = problem.evolve(c);
                EXPECT_TRUE(result.converged());
                EXPECT_LE(result.steps, 4);
                expect_right_signs(problem, result);
            }
        }
}

TEST(Evolution, SphereIsApproachedWithSecondOrderOrBetter) {
    const Ratios order = order_of(kOneSphere, 0.5, [](const NearestFeature&, const Vec3&) { return true; });
    EXPECT_GT(order.distance, 3.0);
    EXPECT_GT(order.curvature, 1.8);
}

TEST(Evolution, SmoothSurfacesAreApproachedWithSecondOrderOrBetter) {
    for (const Arrangement& a : few_spheres()) {
        if (a.name == "two spindle") continue;
        SCOPED_TRACE(a.name);
        EXPECT_GT(order_of(a.atoms, 0.5, [](const NearestFeature&, const Vec3&) { return true; }).distance, 1.8);
    }
}

TEST(Evolution, SpindleIsApproachedWithSecondOrderAwayFromItsCusps) {
    const auto off_axis = [](const NearestFeature&, const Vec3& p) { return std::hypot(p.y, p.z) > 0.8; };
    EXPECT_GT(order_of(two_spheres(5.9), 0.4, off_axis).distance, 1.8);
}

TEST(Evolution, CurvatureIsOfSecondOrderInsideAPatch) {
    const auto far_side = [](const NearestFeature&, const Vec3& p) { return p.x < -0.7; };
    EXPECT_GT(order_of(two_spheres(4.5, 2.0, 1.4), 0.4, far_side).curvature, 1.8);
    EXPECT_GT(order_of(two_spheres(9.0), 0.4, far_side).curvature, 1.8);
}

TEST(Evolution, IsCloseToTheExactSurface) {
    for (const Arrangement& a : few_spheres()) {
        SCOPED_TRACE(a.name);
        const FlowProblem problem(a.atoms, kProbe, 0.25);
        const SurfaceErrors errors = errors_on_surface(problem, problem.level_set(problem.evolve(-0.5)), a.atoms);
        EXPECT_LT(errors.mean_distance, 0.001);
        EXPECT_LT(errors.max_distance, a.name == "two spindle" ? 0.13 : 0.01);
    }
}

TEST(Evolution, OpensACavityThatTheStartMissed) {
    const FlowProblem problem(hollow_shell(50, 4.6, 1.6), kProbe, 0.25);
    const Vec3 wall{2.6, 0.1, 0.1};  // in the void, within the band
    EXPECT_LT(value_near(problem, problem.start(-0.2), wall), 0.0F);
    EXPECT_GT(value_near(problem, problem.band.distance, wall), 0.0F);
    const EvolutionResult result = problem.evolve(-0.2);
    EXPECT_TRUE(result.converged());
    EXPECT_GT(value_near(problem, result.state.values, wall), 0.0F);
    expect_right_signs(problem, result);
}

TEST(Evolution, ClosesACavityThatOnlyTheStartHas) {
    const FlowProblem problem(octahedron(2.6, 1.7), kProbe, 0.25);
    const Vec3 middle{0.1, 0.1, 0.1};
    EXPECT_GT(value_near(problem, problem.start(-4.0), middle), 0.0F);
    const EvolutionResult result = problem.evolve(-4.0);
    EXPECT_LT(value_near(problem, result.state.values, middle), 0.0F);
    expect_right_signs(problem, result);
}

TEST(Evolution, WorksWithoutAProbeAndWithALargeOne) {
    for (const double probe : {0.0, 0.3, 4.0}) {
        SCOPED_TRACE(probe);
        const FlowProblem problem(random_cluster(3, 20, 8.0), probe, 0.25);
        const EvolutionResult result = problem.evolve(-1.0);
        EXPECT_TRUE(result.converged());
        expect_right_signs(problem, result);
    }
}

TEST(Evolution, ValuesAreThoseOfTheSpline) {
    const FlowProblem problem(two_spheres(4.5, 2.0, 1.4), kProbe, 0.5);
    const EvolutionResult result = problem.evolve(-1.0);
    const LevelSet level_set = problem.level_set(result);
    for (std::size_t n = 0; n < result.state.values.size(); ++n) {
        if (std::abs(problem.band.distance[n]) > 1.0) continue;
        const int node = static_cast<int>(n % kBlockNodes);
        const Vec3 p =
            node_position(*problem.grid, static_cast<BlockId>(n / kBlockNodes), node % 8, node / 8 % 8, node / 64);
        ASSERT_NEAR(level_set.value(p), result.state.values[n], 1e-5);
    }
}

TEST(Evolution, HasTheSameBitsForAnyNumberOfThreads) {
    const auto evolved = [](int threads) {
        const ThreadLimit limit(threads);
        return FlowProblem(random_cluster(4, 100, 14.0), kProbe, 0.5).evolve(-0.5);
    };
    const EvolutionResult one = evolved(1);
    for (const int threads : {2, 0}) {
        const EvolutionResult other = evolved(threads);
        EXPECT_EQ(one.state.coefficients, other.state.coefficients);
        EXPECT_EQ(one.state.values, other.state.values);
        EXPECT_EQ(one.residual, other.residual);
        EXPECT_EQ(one.solver_iterations, other.solver_iterations);
    }
}

TEST(Evolution, ReportsItsStepsAndItsProgress) {
    const FlowProblem problem(two_spheres(3.0), kProbe, 0.5);
    const FlowOptions options{.time_step = 2.0, .tolerance = 1e-5};
    std::vector<double> fractions;
    const EvolutionResult result =
        evolve(*problem.grid, {problem.band, problem.start(-0.2)}, options,
               [&](const EvolutionResult&, double fraction) { fractions.push_back(fraction); });
    EXPECT_TRUE(result.converged());
    EXPECT_EQ(fractions.size(), static_cast<std::size_t>(result.steps));
    EXPECT_EQ(fractions.back(), 1.0);
    EXPECT_TRUE(std::is_sorted(fractions.begin(), fractions.end()));
    for (const double fraction : fractions) EXPECT_TRUE(fraction >= 0.0 && fraction <= 1.0) << fraction;
    EXPECT_NEAR(result.time, result.steps * 2.0 * 0.25, 1e-12);
    EXPECT_LT(result.residual / (options.anchor / 0.25) / 0.5, options.tolerance);
    EXPECT_GE(result.solver_iterations, result.steps);
}

TEST(Evolution, SaysWhenItDidNotConverge) {
    const FlowProblem problem(two_spheres(3.0), kProbe, 0.5);
    const EvolutionResult cut_short = problem.evolve(-0.2, {.time_step = 0.05, .max_steps = 2});
    EXPECT_FALSE(cut_short.converged());
    EXPECT_EQ(cut_short.steps, 2);
}

TEST(Evolution, GivesUpWhereStepsChangeTooLittle) {
    const FlowProblem problem(two_spheres(3.0), kProbe, 0.5);
    const EvolutionResult creeping = problem.evolve(-0.2, {.time_step = 0.001});
    EXPECT_FALSE(creeping.converged());
    EXPECT_LT(creeping.steps, 10);
}

TEST(Evolution, StopsWhereNothingChangesAnyMore) {
    const FlowProblem problem(two_spheres(3.0), kProbe, 0.5);
    const EvolutionResult still = problem.evolve(-0.2, {.tolerance = 1e-15});
    EXPECT_LT(still.steps, 30);
    EXPECT_LT(still.residual, 1e-4);
}

TEST(InterpolatingCoefficients, InterpolateNearTheSurface) {
    for (const double h : {0.5, 0.25}) {
        const FlowProblem problem(two_spheres(4.5, 2.0, 1.4), kProbe, h);
        const NodeField values = problem.start(-1.0);
        const NodeField coefficients = interpolating_coefficients(*problem.grid, values, 3.0);
        NodeField back(values.size(), 0.0F);
        const BlockFill fill(problem.grid->block_count());
        apply_everywhere(spline_value(), {*problem.grid, coefficients, fill}, back);
        for (std::size_t n = 0; n < values.size(); ++n) {
            if (std::abs(values[n]) < 2.0 * h) {  // farther nodes may lie beside a missing block
                ASSERT_NEAR(back[n], values[n], 2e-4 * h);
            }
        }
    }
}

}  // namespace
}  // namespace meniscus::testing
