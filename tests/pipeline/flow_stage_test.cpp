// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Whole surfaces by the three flows: what they report about themselves, and what is kept.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "meniscus/errors.h"
#include "meniscus/surface.h"
#include "support/arrangements.h"
#include "support/mesh_checks.h"

namespace meniscus::testing {
namespace {

const Atoms kPair = two_spheres(2.4, 1.7, 1.7);

SurfaceOptions with(const FlowOptions& flow) {
    SurfaceOptions options;
    options.flow = flow;
    return options;
}

double least_distance(const std::vector<FlowStep>& history) {
    double least = std::numeric_limits<double>::infinity();
    for (const FlowStep& step : history)
        if (step.step > 0) least = std::fmin(least, step.mean_distance);
    return least;
}

TEST(FlowStage, ThePapersFlowKeepsItsBestStateAndSaysThatItDiverged) {
    const Surface surface = compute_surface(kPair, with(kPaperFlow));
    EXPECT_FALSE(surface.flow.converged);
    EXPECT_FALSE(surface.passed());
    EXPECT_NE(surface.flow.explanation, "");
    ASSERT_GT(surface.history.size(), 2U);
    EXPECT_LT(surface.flow.kept_step, surface.flow.steps);
    EXPECT_NEAR(surface.distance.mean, least_distance(surface.history), 1e-12);
    expect_closed_manifold(surface.mesh);
}

TEST(FlowStage, ASurfaceThatShrinksToNothingHasNotConverged) {
    SurfaceOptions options = with(kPaperFlow);  // its reinitialiser draws small surfaces together
    options.spacing = 0.25;
    const Surface surface = compute_surface(kPair, options);
    EXPECT_EQ(surface.flow.end, FlowEnd::Vanished);
    EXPECT_FALSE(surface.flow.converged);
    EXPECT_FALSE(surface.mesh.vertices.empty());
    EXPECT_TRUE(std::isnan(surface.history.back().mean_distance));
}

TEST(FlowStage, TheParallelFlowStaysNearTheSurfaceThatItStartedFrom) {
    SurfaceOptions options = with(kParallelFlow);
    options.density = -1.4;
    options.flow.max_steps = 20;
    const Surface surface = compute_surface(kPair, options);
    EXPECT_LT(surface.distance.mean, 0.05);
    EXPECT_EQ(surface.flow.reinitialisations, surface.flow.steps);
}

TEST(FlowStage, RecordsEveryStepOnDemand) {
    SurfaceOptions options;
    const Surface silent = compute_surface(kPair, options);
    EXPECT_TRUE(silent.history.empty());
    options.history = true;
    const Surface surface = compute_surface(kPair, options);
    ASSERT_EQ(surface.history.size(), static_cast<std::size_t>(surface.flow.steps) + 1);
    EXPECT_EQ(surface.history.front().time, 0.0);
    EXPECT_EQ(surface.history.back().time, surface.flow.time);
    EXPECT_EQ(surface.history.back().residual, surface.flow.residual);
    EXPECT_NEAR(surface.history.back().area, surface.measures.area, 1e-9);
    EXPECT_NEAR(surface.history.back().mean_distance, surface.distance.mean, 1e-12);
    EXPECT_EQ(surface.history.back().genus, 0);
    int iterations = 0;
    for (const FlowStep& step : surface.history) iterations += step.solver_iterations;
    EXPECT_EQ(iterations, surface.flow.solver_iterations);
    EXPECT_EQ(silent.mesh.vertices, surface.mesh.vertices);
}

TEST(FlowStage, MeasuresTheStartOnDemandWithoutATrace) {
    SurfaceOptions options;
    const Surface without = compute_surface(kPair, options);
    EXPECT_EQ(without.flow.initial_area, 0.0);
    options.initial_area = true;
    const Surface measured = compute_surface(kPair, options);
    EXPECT_EQ(measured.mesh.vertices, without.mesh.vertices);
    options.method = Method::Gaussian;
    EXPECT_NEAR(measured.flow.initial_area, compute_surface(kPair, options).measures.area,
                0.02 * without.measures.area);
}

TEST(FlowStage, TheSteadyStateInOneSolveDoesNotKnowTheStart) {
    SurfaceOptions options;
    const Surface one = compute_surface(kPair, options);
    options.density = -4.0;
    options.history = true;
    const Surface other = compute_surface(kPair, options);
    EXPECT_EQ(one.mesh.vertices, other.mesh.vertices);
    EXPECT_EQ(one.flow.steps, 1);
    EXPECT_TRUE(std::isinf(one.flow.time));
}

TEST(FlowStage, ShowsEveryStepToAnObserver) {
    std::vector<int> steps;
    const Surface surface = compute_surface(kPair, {}, {.observer = [&](const FlowStep& step, const Mesh& mesh) {
                                                steps.push_back(step.step);
                                                expect_closed_manifold(mesh);
                                                EXPECT_EQ(mesh.atoms.size(), mesh.vertices.size());
                                            }});
    ASSERT_EQ(steps.size(), static_cast<std::size_t>(surface.flow.steps) + 1);
    EXPECT_TRUE(std::is_sorted(steps.begin(), steps.end()));
}

TEST(FlowStage, RefusesOptionsThatMakeNoSense) {
    const auto refused = [](const FlowOptions& flow) { EXPECT_THROW(compute_surface(kPair, with(flow)), UsageError); };
    refused({.anchor = -1.0});
    refused({.time_step = 0.0});
    refused({.anchor = 0.0, .time_step = std::numeric_limits<double>::infinity()});
    refused({.half_width = 1.0});
    refused({.half_width = 100.0});
    refused({.tolerance = 0.0});
    refused({.max_steps = 0});
}

TEST(Pieces, AreKeptByKind) {
    const Atoms shell = hollow_shell(60, 5.2, 1.7);
    const auto computed = [&](Pieces pieces) {
        SurfaceOptions options;
        options.pieces = pieces;
        return compute_surface(shell, options);
    };
    const Surface all = computed(Pieces::All);
    const Surface outer = computed(Pieces::Outer);
    const Surface cavities = computed(Pieces::Cavities);
    ASSERT_EQ(all.measures.components.size(), 2U);
    EXPECT_EQ(outer.measures.components.size(), 1U);
    EXPECT_EQ(cavities.measures.components.size(), 1U);
    EXPECT_GT(outer.measures.volume, 0.0);
    EXPECT_LT(cavities.measures.volume, 0.0);
    EXPECT_NEAR(outer.measures.area + cavities.measures.area, all.measures.area, 1e-9 * all.measures.area);
    EXPECT_EQ(outer.mesh.normals.size(), outer.mesh.vertices.size());
    expect_closed_manifold(cavities.mesh);
}

}  // namespace
}  // namespace meniscus::testing
