// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "nearest/nearest_batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "support/arrangements.h"

namespace meniscus::testing {
namespace {

using Claim = NearestBatch::Claim;

// Up to 64 points on a lattice in a cube: with ties where the arrangement is symmetric.
std::vector<Vec3> points_in_cube(const Vec3& corner, double step, std::size_t count) {
    std::vector<Vec3> points(count);
    for (std::size_t n = 0; n < count; ++n) {
        const std::array<std::size_t, 3> steps{n % 4, n / 4 % 4, n / 16};
        points[n] = corner + step * Vec3{static_cast<double>(steps[0]), static_cast<double>(steps[1]),
                                         static_cast<double>(steps[2])};
    }
    return points;
}

void expect_side(Claim claim, double s, double margin) {
    EXPECT_TRUE(claim == Claim::Below || claim == Claim::Above);
    if (claim == Claim::Below) {
        EXPECT_LE(s, -margin + 1e-9);
    } else {
        EXPECT_GE(s, margin - 1e-9);
    }
}

// What is written for a point.
struct Written {
    float distance = 0.0F;
    float curvature = 0.0F;
};

constexpr double kCurvatureLimit = 0.5;  // Å^-1

// Of all points, written in reverse.
std::vector<Written> written(NearestBatch& batch, std::size_t count) {
    std::vector<std::uint32_t> places(count);
    std::iota(places.rbegin(), places.rend(), 0U);
    std::vector<float> distances(count);
    std::vector<float> curvatures(count);
    batch.write(places, kCurvatureLimit, distances.data(), curvatures.data());
    std::vector<Written> all;
    for (std::size_t i = count; i-- > 0;) all.push_back({distances[i], curvatures[i]});
    return all;
}

void expect_same(const NearestBatch& batch, std::size_t i, const Written& out, const NearestFeature& exact,
                 double margin) {
    const double s = exact.signed_distance;
    if (!batch.found(i)) {
        EXPECT_EQ(out.distance, static_cast<float>(batch.claim(i) == Claim::Below ? -margin : margin));
        EXPECT_EQ(out.curvature, 0.0F);
        return expect_side(batch.claim(i), s, margin);
    }
    EXPECT_LT(std::abs(s), margin + 1e-9);
    EXPECT_NEAR(batch.signed_distance(i), s, 1e-9);
    EXPECT_NEAR(batch.feature(i).signed_distance, s, 1e-9);
    if (std::abs(exact.mean_curvature) < 10.0) {  // elsewhere it is next to a cusp, and rounding decides
        EXPECT_NEAR(batch.mean_curvature(i), batch.feature(i).mean_curvature, 1e-6);
    }
    const double found = batch.signed_distance(i);
    EXPECT_EQ(out.distance, static_cast<float>(std::clamp(found, -margin, margin)));
    const double curvature = std::clamp(batch.mean_curvature(i), -kCurvatureLimit, kCurvatureLimit);
    const bool is_clamped = std::abs(found) >= margin || std::isnan(curvature);
    EXPECT_TRUE(is_clamped || out.curvature == static_cast<float>(curvature));
    const FeatureLabel label = batch.label(i);
    const NearestFeature feature = batch.feature(i);
    EXPECT_EQ(label.signed_distance, found);
    EXPECT_EQ(label.atom, feature.atom);
    EXPECT_EQ(label.patch, feature.patch);
}

std::size_t expect_cube(const AccessibleSurface& surface, NearestBatch& batch, LocalFeatures& local,
                        const std::vector<Vec3>& points, double margin) {
    Box box;
    for (const Vec3& p : points) box.include(p);
    local.gather(box.grown(1.0));
    const Claim all = batch.start(local, box, margin);
    if (all == Claim::Open) {
        batch.find(points);
        batch.find_curvatures();
    }
    std::size_t found = 0;
    const std::vector<Written> out = all == Claim::Open ? written(batch, points.size()) : std::vector<Written>();
    for (std::size_t i = 0; i < points.size(); ++i) {
        const NearestFeature exact = surface.nearest(points[i]);
        if (all != Claim::Open) {
            expect_side(all, exact.signed_distance, margin);
            continue;
        }
        expect_same(batch, i, out[i], exact, margin);
        found += batch.found(i) ? 1 : 0;
    }
    return found;
}

TEST(NearestBatch, EqualsTheGlobalSearchOrKnowsTheSide) {
    for (const Arrangement& a : awkward_arrangements()) {
        SCOPED_TRACE(a.name);
        const AccessibleSurface surface(a.atoms, a.probe);
        NearestBatch batch(surface);
        std::size_t found = 0;
        for (const double margin : {0.3, 0.9, 4.0}) {
            LocalFeatures local(surface, margin);
            for (const Vec3& corner : random_points_around(a.atoms, 30, 2.0))
                found += expect_cube(surface, batch, local, points_in_cube(corner, 0.4, 64), margin);
        }
        EXPECT_GT(found, 100U);
    }
}

TEST(NearestBatch, EqualsTheGlobalSearchWhereFeaturesTie) {
    const Atoms atoms = cubic_lattice(4, 3.0, 1.6);
    const AccessibleSurface surface(atoms, 1.4);
    NearestBatch batch(surface);
    LocalFeatures local(surface, 1.5);
    std::size_t found = 0;
    for (const Vec3& centre : atoms.centres)
        found += expect_cube(surface, batch, local, points_in_cube(centre - Vec3{1.5, 1.5, 1.5}, 0.75, 64), 1.5);
    EXPECT_GT(found, 500U);
}

TEST(NearestBatch, TakesAnyNumberOfPoints) {
    const AccessibleSurface surface(tetrahedral_spheres(3.0, 1.5), 1.4);
    NearestBatch batch(surface);
    LocalFeatures local(surface, 1.0);
    for (std::size_t count = 1; count <= kBatchLanes; ++count)
        expect_cube(surface, batch, local, points_in_cube({0.2, 0.3, 0.1}, 0.5, count), 1.0);
}

// Whether there is something to find among points next to each other, which then is found.
bool finds(NearestBatch& batch, LocalFeatures& local, const std::vector<Vec3>& points) {
    Box box;
    for (const Vec3& p : points) box.include(p);
    local.gather(box);
    if (batch.start(local, box, local.margin()) != Claim::Open) return false;
    batch.find(points);
    return true;
}

// Of settled steps from points near the surface; how many there were is added to.
void expect_steps_to_lead_to_the_surface(const AccessibleSurface& surface, NearestBatch& batch, LocalFeatures& local,
                                         const std::vector<Vec3>& points, std::size_t& settled) {
    if (!finds(batch, local, points)) return;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!batch.found(i)) continue;
        const SurfaceStep step = batch.step_to_surface(i);
        if (!step.settled) continue;
        ++settled;
        const NearestFeature exact = surface.nearest(step.point);
        EXPECT_NEAR(exact.signed_distance, 0.0, 1e-7);
        EXPECT_NEAR(step.feature.signed_distance, exact.signed_distance, 1e-7);
        EXPECT_NEAR(norm(step.point - points[i]), std::abs(batch.signed_distance(i)), 1e-9);
    }
}

TEST(NearestBatch, SettledStepsLeadToTheSurface) {
    for (const Arrangement& a : awkward_arrangements()) {
        SCOPED_TRACE(a.name);
        const AccessibleSurface surface(a.atoms, a.probe);
        NearestBatch batch(surface);
        LocalFeatures local(surface, 0.9);
        std::size_t settled = 0;
        for (const Vec3& corner : random_points_around(a.atoms, 60, 2.0))
            expect_steps_to_lead_to_the_surface(surface, batch, local, points_in_cube(corner, 0.4, 64), settled);
        EXPECT_GT(settled, 50U);
    }
}

// Of points that were found, beside the same steps one by one; how many were settled is added to.
void expect_the_same_steps(NearestBatch& batch, const std::vector<Vec3>& points, std::size_t& settled) {
    BatchSteps steps;
    batch.steps_to_surface(steps);
    std::vector<bool> seen(points.size());
    for (std::size_t lane = 0; lane < points.size(); ++lane) {
        const std::uint32_t i = steps.point[lane];
        ASSERT_FALSE(seen.at(i));
        seen[i] = true;
        if (!batch.found(i)) {
            EXPECT_EQ(steps.lanes.settled[lane], 0);
            continue;
        }
        const SurfaceStep alone = batch.step_to_surface(i);
        ASSERT_EQ(steps.lanes.settled[lane] != 0, alone.settled);
        const auto at = [lane](const LanePoints<double>& p) { return Vec3{p.x[lane], p.y[lane], p.z[lane]}; };
        EXPECT_NEAR(norm(at(steps.lanes.points) - alone.point), 0.0, 1e-12);
        if (!alone.settled) continue;
        ++settled;
        EXPECT_NEAR(norm(at(steps.lanes.normals) - alone.feature.normal), 0.0, 1e-9);
        EXPECT_NEAR(steps.signed_distance[lane], 0.0, 1e-12);
        EXPECT_EQ(steps.patch[lane], alone.feature.patch);
        const double mean = alone.feature.mean_curvature;
        if (!std::isfinite(mean)) continue;  // without a probe, on an arc
        EXPECT_NEAR(steps.lanes.mean[lane], mean, 1e-6 * std::max(1.0, std::abs(mean)));
        if (alone.feature.patch == PatchKind::Toroidal) {
            const double gaussian = alone.feature.gaussian_curvature;
            EXPECT_NEAR(steps.lanes.gaussian[lane], gaussian, 1e-6 * std::max(1.0, std::abs(gaussian)));
        } else {
            EXPECT_TRUE(std::isinf(steps.lanes.gaussian[lane]));
        }
    }
}

TEST(NearestBatch, StepsOfAllPointsAreThoseOfEach) {
    for (const NearestKernels& kernels : supported_nearest_kernels())
        for (const Arrangement& a : awkward_arrangements()) {
            SCOPED_TRACE(a.name);
            const AccessibleSurface surface(a.atoms, a.probe);
            NearestBatch batch(surface, kernels);
            LocalFeatures local(surface, 0.9);
            std::size_t settled = 0;
            for (const Vec3& corner : random_points_around(a.atoms, 60, 2.0)) {
                const std::vector<Vec3> points = points_in_cube(corner, 0.4, 61);
                if (finds(batch, local, points)) expect_the_same_steps(batch, points, settled);
            }
            EXPECT_GT(settled, 50U);
        }
}

TEST(NearestBatch, TheNearestAtomOfAStepIsThatOfEachStep) {
    const Atoms atoms = random_cluster(4, 60, 9.0);  // nothing ties
    const AccessibleSurface surface(atoms, 1.4);
    NearestBatch batch(surface);
    LocalFeatures local(surface, 0.9);
    std::size_t settled = 0;
    for (const Vec3& corner : random_points_around(atoms, 60, 2.0)) {
        const std::vector<Vec3> points = points_in_cube(corner, 0.4, 64);
        if (!finds(batch, local, points)) continue;
        BatchSteps steps;
        batch.steps_to_surface(steps);
        for (std::size_t lane = 0; lane < points.size(); ++lane) {
            if (steps.lanes.settled[lane] == 0) continue;
            ++settled;
            EXPECT_EQ(steps.atom[lane], batch.step_to_surface(steps.point[lane]).feature.atom);
        }
    }
    EXPECT_GT(settled, 500U);
}

TEST(NearestBatch, StepsAcrossTheAxisOfACircleAreNotSettled) {
    const AccessibleSurface surface(two_spheres(5.0), 1.4);  // the probe rolls around with a hole in the middle
    NearestBatch batch(surface);
    LocalFeatures local(surface, 0.9);
    const std::vector<Vec3> points{{2.5, 0.05, 0.0}, {2.5, 0.0, 0.1}, {2.3, 0.3, 0.1}};
    const Box box{{2.0, -1.0, -1.0}, {3.0, 1.0, 1.0}};
    local.gather(box);
    ASSERT_EQ(batch.start(local, box, 0.9), Claim::Open);
    batch.find(points);
    for (std::size_t i = 0; i < points.size(); ++i) {
        ASSERT_TRUE(batch.found(i));
        const SurfaceStep step = batch.step_to_surface(i);
        const bool on_surface = std::abs(surface.nearest(step.point).signed_distance) < 1e-7;
        EXPECT_EQ(step.settled, on_surface) << i;
    }
}

TEST(NearestBatch, KnowsTheSideOfWholeBoxes) {
    const AccessibleSurface surface(equal_spheres({{0, 0, 0}}, 10.0), 1.4);
    NearestBatch batch(surface);
    LocalFeatures local(surface, 1.0);
    const auto side = [&](const Vec3& corner) {
        const Box box{corner, corner + Vec3{1, 1, 1}};
        local.gather(box);
        return batch.start(local, box, 1.0);
    };
    EXPECT_EQ(side({0, 0, 0}), Claim::Below);
    EXPECT_EQ(side({20, 0, 0}), Claim::Above);
    EXPECT_EQ(side({9.5, 0, 0}), Claim::Open);
}

}  // namespace
}  // namespace meniscus::testing
