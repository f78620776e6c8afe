// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/nearest_batch.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

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
    if (claim == Claim::Below) {
        EXPECT_LE(s, -margin + 1e-9);
    } else {
        EXPECT_GE(s, margin - 1e-9);
    }
}

void expect_same(const NearestBatch& batch, std::size_t i, const NearestFeature& exact, double margin) {
    const double s = exact.signed_distance;
    if (!batch.found(i)) return expect_side(batch.claim(i), s, margin);
    EXPECT_LT(std::abs(s), margin + 1e-9);
    EXPECT_NEAR(batch.signed_distance(i), s, 1e-9);
    EXPECT_NEAR(batch.feature(i).signed_distance, s, 1e-9);
}

std::size_t expect_cube(const AccessibleSurface& surface, NearestBatch& batch, LocalFeatures& local,
                        const std::vector<Vec3>& points, double margin) {
    Box box;
    for (const Vec3& p : points) box.include(p);
    local.gather(box.grown(1.0));
    const Claim all = batch.start(local, box, margin);
    if (all == Claim::Open) batch.find(points);
    std::size_t found = 0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const NearestFeature exact = surface.nearest(points[i]);
        if (all != Claim::Open) {
            expect_side(all, exact.signed_distance, margin);
            continue;
        }
        expect_same(batch, i, exact, margin);
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
