// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The three flows and their pieces: what is stable, what is not, and that pieces which should agree do.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "flow/closest_points.h"
#include "flow/paper/printed_curvature.h"
#include "flow/paper/reinitialise.h"
#include "flow/small_flow.h"
#include "mesh/extract.h"
#include "support/test_data.h"

namespace meniscus::testing {
namespace {

constexpr double kWater = 1.4;
constexpr double kRadius = 1.7;
constexpr double kInfinite = std::numeric_limits<double>::infinity();
const Vec3 kCentre{0.1, -0.2, 0.3};

// One sphere on a dense grid with room to go astray.
class SphereProblem {
public:
    explicit SphereProblem(double h)
        : surface_({{kCentre}, {kRadius}}, kWater),
          field_(sample_box(h, kCentre - Vec3{4, 4, 4}, kCentre + Vec3{4, 4, 4}, [](const Vec3&) { return 0.0; })),
          band_(sample_distance(surface_, field_.grid, 2.0)) {}

    const BlockGrid& grid() const { return field_.grid; }
    const AccessibleSurface& surface() const { return surface_; }
    std::span<const float> parallel_curvature() const { return band_.curvature; }

    // Signed distance from the sphere of another radius.
    NodeField start(double radius) const {
        NodeField values(grid().node_count(), 0.0F);
        for (std::size_t n = 0; n < values.size(); ++n)
            values[n] = static_cast<float>(norm(grid().position(n) - kCentre) - radius);
        return values;
    }

    // Excess of the radius over kRadius after every step, from that of the start.
    std::vector<double> excesses(double excess, std::span<const float> curvature, const FlowOptions& options) const {
        std::vector<double> found{excess};
        DistanceBand band = band_;
        band.curvature.assign(curvature.begin(), curvature.end());
        evolve(grid(), {std::move(band), start(kRadius + excess)}, options,
               [&](const EvolutionResult& at, double) { found.push_back(mean_radius(at.state) - kRadius); });
        return found;
    }

private:
    double mean_radius(const FlowState& state) const {
        const LevelSet level_set(std::make_shared<const BlockGrid>(grid()), state.coefficients);
        const Mesh mesh = extract_zero_set(grid(), state.values);
        double sum = 0.0;
        for (const Vec3& v : mesh.vertices) sum += norm(level_set.project(v) - kCentre);
        return sum / static_cast<double>(mesh.vertices.size());
    }

    AccessibleSurface surface_;
    SampledField field_;
    DistanceBand band_;
};

// ρ' = 2(1/r - 1/ρ) by small Euler steps.
double excess_by_the_equation(double excess, double time) {
    constexpr int kSteps = 1000;
    double rho = kRadius + excess;
    for (int i = 0; i < kSteps; ++i) rho += time / kSteps * 2.0 * (1.0 / kRadius - 1.0 / rho);
    return rho - kRadius;
}

TEST(Flows, ThePapersFieldDrivesASphereAwayFromItsSteadyState) {
    const SphereProblem problem(0.2);
    const NodeField field = sample_printed_curvature(problem.surface(), problem.grid(), BridgedPair::Torus);
    const FlowOptions options{.curvature = CurvatureField::Paper,
                              .anchor = 0.0,
                              .reinitialiser = Reinitialiser::ClosestPoint,
                              .time_step = 1.0,
                              .max_steps = 80,
                              .tolerance = 1e-9};
    const double tau = 0.04;
    for (const double excess : {0.05, -0.05}) {
        const std::vector<double> found = problem.excesses(excess, field, options);
        double largest = 0.0;
        for (std::size_t n = 0; n < found.size() && std::abs(found[n]) < 0.3; ++n) {
            const double expected = excess_by_the_equation(excess, static_cast<double>(n) * tau);
            EXPECT_NEAR(found[n], expected, 0.15 * std::abs(expected)) << "step " << n;
            largest = std::abs(found[n]);
        }
        EXPECT_GT(largest, 0.2);
    }
}

TEST(Flows, TheParallelFieldLeavesASphereWhereItIs) {
    const SphereProblem problem(0.2);
    FlowOptions options = kParallelFlow;
    options.max_steps = 25;  // t = 1
    options.tolerance = 1e-9;
    for (const double excess : {0.05, -0.05})
        for (const double found : problem.excesses(excess, problem.parallel_curvature(), options))
            EXPECT_NEAR(found, excess, 0.01);
}

TEST(Flows, TheAnchorTakesAwayTheExcessByTheSameFactorInEveryStep) {
    const SphereProblem problem(0.2);
    for (const double lambda : {1.0, 4.0})
        for (const double excess : {0.05, -0.05}) {
            const FlowOptions options{.anchor = lambda, .time_step = 1.0, .max_steps = 2, .tolerance = 1e-9};
            const std::vector<double> found = problem.excesses(excess, problem.parallel_curvature(), options);
            const double factor = 1.0 / (1.0 + lambda);
            EXPECT_NEAR(found[1] / found[0], factor, 0.1 * factor);
            EXPECT_NEAR(found[2] / found[1], factor, 0.1 * factor);
        }
}

// Largest difference of two fields near the surface, in spacings.
double largest_difference(const FlowProblem& problem, const NodeField& a, const NodeField& b) {
    double largest = 0.0;
    for (std::size_t n = 0; n < a.size(); ++n)
        if (std::abs(problem.band.distance[n]) < problem.grid->spacing())
            largest = std::max(largest, std::abs(double{a[n]} - b[n]) / problem.grid->spacing());
    return largest;
}

TEST(Flows, AllSolversGiveTheSameSurface) {
    const FlowProblem problem(random_cluster(3, 30, 9.0), kWater, 0.25);
    const EvolutionResult cg = problem.evolve(-0.5, {.solver = Solver::Cg});
    for (const Solver solver : {Solver::Richardson, Solver::Gmres}) {
        const EvolutionResult other = problem.evolve(-0.5, {.solver = solver});
        EXPECT_TRUE(other.converged());
        EXPECT_LT(largest_difference(problem, cg.state.values, other.state.values), 1e-3);
        EXPECT_NEAR(other.solver_iterations, cg.solver_iterations, 6);
    }
}

TEST(Flows, OneSolveGivesTheSteadyState) {
    for (const Atoms& atoms : {two_spheres(5.9), random_cluster(3, 30, 9.0)}) {
        const FlowProblem problem(atoms, kWater, 0.25);
        const EvolutionResult steps = problem.evolve(-0.5, {.tolerance = 1e-6});
        const EvolutionResult once = problem.evolve(-0.5, {.time_step = kInfinite, .max_steps = 1});
        EXPECT_TRUE(once.converged());
        EXPECT_EQ(once.steps, 1);
        EXPECT_LT(largest_difference(problem, steps.state.values, once.state.values), 1e-3);
    }
}

TEST(Flows, TheSharpFieldMakesTheDistanceItselfTheFixedPoint) {
    const FlowProblem problem(two_spheres(5.9), kWater, 0.25);  // with a cusp, where the parallel field rounds
    DistanceBand band = problem.band;
    band.curvature = sharp_curvature(*problem.grid, band, FlowOptions{}.half_width);
    const EvolutionResult result =
        evolve(*problem.grid, {std::move(band), problem.start(-0.5)}, {.tolerance = 1e-6}, {});
    const EvolutionResult rounded = problem.evolve(-0.5);
    const double off = largest_difference(problem, result.state.values, problem.band.distance);
    EXPECT_LT(off, 0.005);
    EXPECT_GT(largest_difference(problem, rounded.state.values, problem.band.distance), 10.0 * off);
}

// Mean | |∇Φ| - 1 | within two spacings of the zero set.
double slope_error(const BlockGrid& grid, const NodeField& values, const NodeField& before) {
    const LevelSet level_set(std::make_shared<const BlockGrid>(grid), interpolating_coefficients(grid, values, 4.0));
    double sum = 0.0;
    double count = 0.0;
    for (std::size_t n = 0; n < values.size(); ++n) {
        if (std::abs(before[n]) > 2.0 * grid.spacing()) continue;
        sum += std::abs(norm(level_set.sample(grid.position(n)).gradient) - 1.0);
        count += 1.0;
    }
    return sum / count;
}

TEST(Reinitialise, TheRepairedEquationEvensTheSlopeAndThePrintedOneDoesNot) {
    const FlowProblem problem(random_cluster(3, 30, 9.0), kWater, 0.25);
    const NodeField before = problem.start(-0.5);
    const double width = 5.0 * problem.grid->spacing();
    NodeField repaired = before;
    NodeField printed = before;
    EXPECT_EQ(reinitialise_upwind(*problem.grid, width, {}, repaired), 8);
    reinitialise_upwind(*problem.grid, width, {.repaired = false}, printed);
    const double error = slope_error(*problem.grid, before, before);
    EXPECT_LT(slope_error(*problem.grid, repaired, before), 0.7 * error);
    EXPECT_GT(slope_error(*problem.grid, printed, before), error);
}

TEST(Reinitialise, StopsWhereNothingChanges) {
    const SphereProblem problem(0.5);
    NodeField flat(problem.grid().node_count(), 1.0F);
    EXPECT_EQ(reinitialise_upwind(problem.grid(), 1.0, {}, flat), 1);
}

TEST(ClosestPoints, GiveTheDistanceFromASphere) {
    const double h = 0.25;
    const SphereProblem problem(h);
    NodeField values = problem.start(2.0);
    for (float& v : values) v = v * (1.0F + 0.3F * v);  // no distance any more
    const NodeField coefficients = interpolating_coefficients(problem.grid(), values, 8.0);
    const NodeField found = distance_by_closest_points(problem.grid(), values, coefficients, 5.0 * h);
    const NodeField exact = problem.start(2.0);
    for (std::size_t n = 0; n < found.size(); ++n) {
        const double expected = std::clamp(double{exact[n]}, -5.0 * h, 5.0 * h);
        ASSERT_NEAR(found[n], expected, 2e-3 * h);
    }
}

// How far the zero set moves when its spline is replaced by the distance from it, Å, in the mean.
double mean_displacement(const FlowProblem& problem, const FlowState& state) {
    const NodeField distance =
        distance_by_closest_points(*problem.grid, state.values, state.coefficients, 5.0 * problem.grid->spacing());
    const LevelSet before(problem.grid, state.coefficients);
    const LevelSet after(problem.grid, interpolating_coefficients(*problem.grid, distance, 4.0));
    const Mesh mesh = extract_zero_set(*problem.grid, state.values);
    double sum = 0.0;
    for (const Vec3& v : mesh.vertices) {
        const LevelSetSample at = after.sample(before.project(v));
        sum += std::abs(at.value) / norm(at.gradient);
    }
    return sum / static_cast<double>(mesh.vertices.size());
}

TEST(ClosestPoints, HardlyMoveTheZeroSet) {
    const FlowProblem problem(random_cluster(3, 30, 9.0), kWater, 0.25);
    EXPECT_LT(mean_displacement(problem, problem.evolve(-0.5).state), 0.0005);
}

TEST(ClosestPoints, HardlyMoveTheSurfaceOfCrambin) {
    MENISCUS_NEED_TEST_DATA();
    const FlowProblem problem(read_spheres(*test_data() / "reference/xyzr/1crn.xyzr"), kWater, 0.25);
    EXPECT_LT(mean_displacement(problem, problem.evolve(-0.5).state), 0.0003);
}

}  // namespace
}  // namespace meniscus::testing
