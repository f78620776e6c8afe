// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "nearest/step_batch.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "support/arrangements.h"

namespace meniscus::testing {
namespace {

using Kind = FeatureCell::Kind;

FeatureCell nearest_cell(const AccessibleSurface& surface, const Vec3& p) {
    const NearestHit hit = nearest_hit(surface.data(), p);
    if (hit.by_ball) return {Kind::Ball, hit.ball.atom};
    return hit.edge.vertex == kNoVertex ? FeatureCell{Kind::Arc, hit.edge.arc}
                                        : FeatureCell{Kind::Vertex, hit.edge.vertex};
}

struct Batch {
    std::vector<Vec3> points;
    std::vector<FeatureCell> cells;  // where these are
};

// Points near the surface, as many as a batch holds.
Batch batch_near(const AccessibleSurface& surface, const Atoms& atoms) {
    Batch batch;
    for (const Vec3& p : random_points_around(atoms, 4000, 1.0)) {
        if (!(std::abs(surface.nearest(p).signed_distance) < 0.5)) continue;
        batch.points.push_back(p);
        batch.cells.push_back(nearest_cell(surface, p));
        if (batch.points.size() == kBatchLanes) break;
    }
    return batch;
}

// A lane of what was taken is the step that its point takes alone.
void expect_step(const BatchSteps& steps, std::size_t lane, const SurfaceStep& alone) {
    EXPECT_LE(norm(get_point(steps.lanes.points, lane) - alone.point), 1e-12);
    EXPECT_EQ(steps.lanes.settled[lane] != 0, alone.settled);
    EXPECT_EQ(steps.signed_distance[lane], 0.0);
    if (!alone.settled) return;
    EXPECT_EQ(steps.patch[lane], alone.feature.patch);
    EXPECT_EQ(steps.atom[lane], alone.feature.atom);
    EXPECT_LE(norm(get_point(steps.lanes.normals, lane) - alone.feature.normal), 1e-12);
    EXPECT_NEAR(steps.lanes.mean[lane], alone.feature.mean_curvature, 1e-9);
}

TEST(StepBatch, EveryPointStepsAsItDoesAlone) {
    const Atoms atoms = random_cluster(8, 40, 8.0);
    const AccessibleSurface surface(atoms, 1.4);
    const Batch batch = batch_near(surface, atoms);
    ASSERT_EQ(batch.points.size(), kBatchLanes);
    std::array<std::size_t, 4> kinds{};
    for (const NearestKernels& kernels : supported_nearest_kernels()) {
        SCOPED_TRACE(kernels.instructions);
        StepBatch stepper(surface, kernels);
        stepper.clear();
        for (std::size_t i = 0; i < kBatchLanes; ++i)
            stepper.add(static_cast<std::uint32_t>(i), batch.points[i], batch.cells[i]);
        BatchSteps steps;
        ASSERT_EQ(stepper.take(steps), kBatchLanes);
        std::vector<int> taken(kBatchLanes, 0);
        for (std::size_t lane = 0; lane < kBatchLanes; ++lane) {
            const std::uint32_t point = steps.point[lane];
            ++taken.at(point);
            ++kinds.at(static_cast<std::size_t>(batch.cells[point].kind));
            expect_step(steps, lane, step_from(surface.data(), batch.points[point], batch.cells[point]));
        }
        EXPECT_EQ(taken, std::vector<int>(kBatchLanes, 1));
    }
    for (const Kind kind : {Kind::Ball, Kind::Arc, Kind::Vertex})
        EXPECT_GT(kinds.at(static_cast<std::size_t>(kind)), 3U);
}

TEST(StepBatch, TakesNothingAfterItWasCleared) {
    const AccessibleSurface surface(two_spheres(3.0), 1.4);
    StepBatch stepper(surface);
    stepper.clear();
    stepper.add(0, {0.0, 0.0, 1.0}, {Kind::Ball, 0});
    stepper.clear();
    BatchSteps steps;
    EXPECT_EQ(stepper.take(steps), 0U);
}

TEST(BatchSteps, HoldWhatWasFoundOtherwise) {
    BatchSteps steps;
    NearestFeature at;
    at.signed_distance = 0.1;
    at.patch = PatchKind::Toroidal;
    at.atom = 7;
    at.mean_curvature = 0.2;
    at.gaussian_curvature = -0.3;
    at.normal = {0.0, 1.0, 0.0};
    steps.set(5, {1.0, 2.0, 3.0}, at);
    EXPECT_EQ(get_point(steps.lanes.points, 5), (Vec3{1.0, 2.0, 3.0}));
    EXPECT_EQ(get_point(steps.lanes.normals, 5), at.normal);
    EXPECT_EQ(steps.lanes.mean[5], 0.2);
    EXPECT_EQ(steps.lanes.gaussian[5], -0.3);
    EXPECT_EQ(steps.atom[5], 7U);
    EXPECT_EQ(steps.patch[5], PatchKind::Toroidal);
    EXPECT_EQ(steps.signed_distance[5], 0.1);
    at.patch = PatchKind::Contact;  // both principal curvatures are the mean
    steps.set(5, {1.0, 2.0, 3.0}, at);
    EXPECT_EQ(steps.lanes.gaussian[5], std::numeric_limits<double>::infinity());
}

}  // namespace
}  // namespace meniscus::testing
