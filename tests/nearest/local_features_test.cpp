// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "nearest/local_features.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "nearest/near_surface.h"
#include "support/arrangements.h"

namespace meniscus::testing {
namespace {

void expect_same(const NearestFeature& actual, const NearestFeature& expected) {
    EXPECT_NEAR(actual.signed_distance, expected.signed_distance, 1e-12);
    EXPECT_EQ(actual.patch, expected.patch);
    EXPECT_EQ(actual.atom, expected.atom);
    EXPECT_NEAR(norm(actual.foot - expected.foot), 0.0, 1e-9);
    EXPECT_NEAR(norm(actual.normal - expected.normal), 0.0, 1e-9);
    EXPECT_NEAR(actual.mean_curvature, expected.mean_curvature, 1e-9 * (1.0 + std::abs(expected.mean_curvature)));
}

void expect_same_as_one_by_one(const AccessibleSurface& surface, const std::vector<Vec3>& points) {
    const std::vector<NearestFeature> features = nearest_features(surface, points);
    ASSERT_EQ(features.size(), points.size());
    for (std::size_t i = 0; i < points.size(); ++i) expect_same(features[i], surface.nearest(points[i]));
}

TEST(LocalFeatures, EqualTheGlobalSearchNearTheSurface) {
    const Atoms atoms = random_cluster(1, 120, 14.0);
    for (const double probe : {0.0, 0.3, 1.4, 3.0}) {
        const AccessibleSurface surface(atoms, probe);
        std::vector<Vec3> points = near_surface(surface, random_points_around(atoms, 6000, 3.0), 0.4);
        std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
        EXPECT_GT(points.size(), 500U);
        expect_same_as_one_by_one(surface, points);
    }
}

TEST(LocalFeatures, EqualTheGlobalSearchFarFromTheSurface) {
    const Atoms atoms = random_cluster(2, 120, 14.0);
    const AccessibleSurface surface(atoms, 1.4);
    expect_same_as_one_by_one(surface, random_points_around(atoms, 3000, 12.0));
}

TEST(LocalFeatures, PointsFarFromAllOthersAreNoHindrance) {
    const Atoms atoms = random_cluster(5, 120, 14.0);
    const AccessibleSurface surface(atoms, 1.4);
    std::vector<Vec3> points(1000, Vec3{60.0, 0.0, 0.0});
    for (const Vec3& p : near_surface(surface, random_points_around(atoms, 4000, 3.0), 0.4)) points.push_back(p);
    points.push_back({1e100, -1e100, 0.0});
    expect_same_as_one_by_one(surface, points);
}

TEST(LocalFeatures, StepsLeadToTheSurfaceOrSayThatTheyDoNot) {
    const Atoms atoms = random_cluster(4, 120, 14.0);
    const AccessibleSurface surface(atoms, 1.4);
    std::vector<Vec3> points = random_points_around(atoms, 6000, 3.0);  // some alone, most in groups
    std::sort(points.begin(), points.end(), [](const Vec3& a, const Vec3& b) { return a.x < b.x; });
    const std::vector<SurfaceStep> steps = steps_to_surface(surface, points);
    ASSERT_EQ(steps.size(), points.size());
    std::size_t settled = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const NearestFeature before = surface.nearest(points[i]);
        EXPECT_NEAR(norm(steps[i].point - (points[i] - before.signed_distance * before.normal)), 0.0, 1e-9);
        if (!steps[i].settled) continue;
        ++settled;
        expect_same(steps[i].feature, surface.nearest(steps[i].point));
        EXPECT_NEAR(steps[i].feature.signed_distance, 0.0, 1e-9);
    }
    EXPECT_GT(settled, 500U);
}

TEST(LocalFeatures, AnswerForPointsFarApartInOneBatch) {
    Atoms atoms = random_cluster(3, 30, 7.0);
    atoms.centres.push_back({1e7, 0, -1e7});
    atoms.radii.push_back(1.5);
    const AccessibleSurface surface(atoms, 1.4);
    std::vector<Vec3> points;
    for (const Vec3& p : random_points_around(random_cluster(3, 30, 7.0), 300, 3.0)) {
        points.push_back(p);
        points.push_back(Vec3{1e7 + 1.0, 0.5, -1e7} + 0.1 * p);
        points.push_back({-1e12 - p.x, p.y, 1e9});
    }
    expect_same_as_one_by_one(surface, points);
}

TEST(LocalFeatures, AnswerForNoPointAndForOne) {
    const AccessibleSurface surface(two_spheres(3.0), 1.4);
    EXPECT_TRUE(nearest_features(surface, {}).empty());
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const double inf = std::numeric_limits<double>::infinity();
    EXPECT_THROW(nearest_features(surface, std::vector<Vec3>{{1, 0, 0}, {0, nan, 0}}), std::invalid_argument);
    EXPECT_THROW(nearest_features(surface, std::vector<Vec3>{{inf, 0, 0}}), std::invalid_argument);
    expect_same_as_one_by_one(surface, {{1.5, 1.2, 0.3}});
    expect_same_as_one_by_one(surface, {{1.5, 1.2, 0.3}, {1.5, 1.2, 0.3}, {1.5, 1.2, 0.3}});
}

TEST(LocalFeatures, ListsHoldWhateverIsNearestInTheBox) {
    const Atoms atoms = random_cluster(4, 100, 12.0);
    const AccessibleSurface surface(atoms, 1.4);
    for (const double margin : {0.3, 1.0, 2.5}) {
        LocalFeatures local(surface, margin);
        for (const Vec3& corner : random_points_around(atoms, 40, 3.0)) {
            local.gather({corner, corner + Vec3{2, 2, 2}});
            const Atoms box{{corner + Vec3{1, 1, 1}}, {1.0}};
            for (const Vec3& p : random_points_around(box, 40, 1.0)) expect_same(local.nearest(p), surface.nearest(p));
        }
    }
}

// A ball that does not reach into the box may be the nearest beside it.
TEST(LocalFeatures, AnswerForPointsOutsideTheBoxToo) {
    const Atoms atoms = random_cluster(6, 100, 12.0);
    const AccessibleSurface surface(atoms, 1.4);
    LocalFeatures local(surface, 0.5);
    expect_same(local.nearest({6, 6, 6}), surface.nearest({6, 6, 6}));
    for (const Vec3& corner : random_points_around(atoms, 40, 3.0)) {
        local.gather({corner, corner + Vec3{0.6, 0.6, 0.6}});
        const Atoms beside{{corner}, {1.0}};
        for (const Vec3& p : random_points_around(beside, 40, 4.0)) expect_same(local.nearest(p), surface.nearest(p));
    }
}

TEST(LocalFeatures, ListsAreShort) {
    const Atoms atoms = random_cluster(5, 1000, 26.0);
    const AccessibleSurface surface(atoms, 1.4);
    LocalFeatures local(surface, 0.5);
    local.gather({{13, 13, 13}, {14, 14, 14}});
    EXPECT_LT(local.balls().size(), 80U);
    EXPECT_LT(local.arcs().size(), surface.arc_count() / 4);
    EXPECT_LT(local.vertices().size(), surface.vertex_count() / 4);
}

}  // namespace
}  // namespace meniscus::testing
