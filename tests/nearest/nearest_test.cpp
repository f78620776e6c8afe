// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <random>

#include "geometry/accessible_surface.h"
#include "support/arrangements.h"
#include "support/brute_force_ses.h"
#include "support/test_data.h"

namespace meniscus::testing {
namespace {

void expect_brute_force_distances(const Atoms& atoms, double probe, std::size_t count) {
    const AccessibleSurface surface(atoms, probe);
    const BruteForceSes oracle(atoms, probe);
    double worst = 0.0;
    for (const Vec3& p : random_points_around(atoms, count, 4.0))
        worst = std::max(worst, std::abs(surface.nearest(p).signed_distance - oracle.signed_distance(p)));
    EXPECT_LT(worst, 1e-5);
}

TEST(Nearest, OneSphereIsItsOwnDistance) {
    const AccessibleSurface surface({{{1.0, 2.0, 3.0}}, {1.7}}, 1.4);
    const NearestFeature at = surface.nearest({1.0, 2.0, 6.0});
    EXPECT_NEAR(at.signed_distance, 1.3, 1e-9);
    EXPECT_EQ(at.patch, PatchKind::Contact);
    EXPECT_NEAR(at.mean_curvature, 1.0 / 3.0, 1e-9);
    EXPECT_NEAR(at.gaussian_curvature, 1.0 / 9.0, 1e-9);
    EXPECT_NEAR(at.normal.z, 1.0, 1e-12);
    EXPECT_NEAR(surface.nearest({1.0, 2.0, 3.0}).signed_distance, -1.7, 1e-9);
}

TEST(Nearest, TorusOfTwoSpheresHasItsDistanceAndCurvature) {
    const AccessibleSurface surface({{{0, 0, 0}, {0, 0, 3.0}}, {1.7, 1.7}}, 1.4);
    const double a = std::sqrt(3.1 * 3.1 - 1.5 * 1.5);  // radius of the probe centre's circle
    const double x = 1.2;
    const NearestFeature at = surface.nearest({x, 0.0, 1.5});
    EXPECT_EQ(at.patch, PatchKind::Toroidal);
    EXPECT_NEAR(at.signed_distance, 1.4 - (a - x), 1e-9);
    EXPECT_NEAR(at.mean_curvature, 0.5 * (1.0 / x - 1.0 / (a - x)), 1e-9);
    EXPECT_NEAR(at.gaussian_curvature, -1.0 / (x * (a - x)), 1e-9);
    EXPECT_NEAR(at.normal.x, 1.0, 1e-9);
}

TEST(Nearest, ProbeOnThreeSpheresGivesAReentrantPatch) {
    const double side = 3.0;
    const AccessibleSurface surface(
        {{{0, 0, 0}, {side, 0, 0}, {0.5 * side, std::sqrt(0.75) * side, 0}}, {1.5, 1.5, 1.5}}, 1.4);
    EXPECT_EQ(surface.vertex_count(), 2U);
    const Vec3 middle{0.5 * side, side * std::sqrt(0.75) / 3.0, 0.0};
    const double height = std::sqrt(2.9 * 2.9 - side * side / 3.0);
    const NearestFeature at = surface.nearest(middle + Vec3{0, 0, height - 1.4});
    EXPECT_EQ(at.patch, PatchKind::Reentrant);
    EXPECT_NEAR(at.signed_distance, 0.0, 1e-9);
    EXPECT_NEAR(at.mean_curvature, -1.0 / 1.4, 1e-9);
    EXPECT_NEAR(at.gaussian_curvature, 1.0 / 1.96, 1e-9);
    EXPECT_NEAR(at.foot.z, height, 1e-9);
}

TEST(Nearest, CurvatureIsHalfTheLaplacianOfTheDistance) {
    const AccessibleSurface surface({{{0, 0, 0}, {2.2, 0.3, 0}, {0.8, 2.4, 0.2}}, {1.7, 1.5, 1.6}}, 1.4);
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> within(-3.0, 5.0);
    constexpr double kStep = 1e-4;
    int compared = 0;
    for (int n = 0; n < 4000; ++n) {
        const Vec3 p{within(random), within(random), within(random)};
        const NearestFeature at = surface.nearest(p);
        if (std::abs(at.signed_distance) > 0.8) continue;
        bool same_patch = true;
        double sum = 0.0;
        for (const Vec3 axis : {Vec3{kStep, 0, 0}, Vec3{0, kStep, 0}, Vec3{0, 0, kStep}})
            for (const double sign : {-1.0, 1.0}) {
                const NearestFeature beside = surface.nearest(p + sign * axis);
                same_patch = same_patch && beside.patch == at.patch && norm(beside.foot - at.foot) < 10 * kStep;
                sum += beside.signed_distance - at.signed_distance;
            }
        if (!same_patch || std::abs(at.mean_curvature) > 5.0) continue;
        EXPECT_NEAR(0.5 * sum / (kStep * kStep), at.mean_curvature, 1e-4 * (1 + std::pow(at.mean_curvature, 2)));
        ++compared;
    }
    EXPECT_GT(compared, 500);
}

// The derivative of the normal in the tangent plane has mean and Gaussian curvature as half its trace and determinant.
TEST(Nearest, GaussianCurvatureIsThatOfTheTurningNormal) {
    const AccessibleSurface surface({{{0, 0, 0}, {2.2, 0.3, 0}, {0.8, 2.4, 0.2}}, {1.7, 1.5, 1.6}}, 1.4);
    std::mt19937_64 random(4);
    std::uniform_real_distribution<double> within(-3.0, 5.0);
    constexpr double kStep = 1e-5;
    int compared[3] = {0, 0, 0};
    for (int n = 0; n < 4000; ++n) {
        const Vec3 p{within(random), within(random), within(random)};
        const NearestFeature at = surface.nearest(p);
        if (std::abs(at.signed_distance) > 0.8 || std::abs(at.mean_curvature) > 5.0) continue;
        const Vec3 e1 = normalised(cross(at.normal, std::abs(at.normal.x) < 0.6 ? Vec3{1, 0, 0} : Vec3{0, 1, 0}));
        const Vec3 e2 = cross(at.normal, e1);
        bool same_patch = true;
        const auto turn = [&](const Vec3& e) {
            const NearestFeature before = surface.nearest(p - kStep * e);
            const NearestFeature after = surface.nearest(p + kStep * e);
            same_patch = same_patch && before.patch == at.patch && after.patch == at.patch &&
                         norm(before.foot - after.foot) < 20 * kStep;
            return (0.5 / kStep) * (after.normal - before.normal);
        };
        const Vec3 d1 = turn(e1);
        const Vec3 d2 = turn(e2);
        if (!same_patch) continue;
        const double bound = 1e-5 * (1.0 + std::pow(at.mean_curvature, 2));
        EXPECT_NEAR(0.5 * (dot(e1, d1) + dot(e2, d2)), at.mean_curvature, bound);
        EXPECT_NEAR(dot(e1, d1) * dot(e2, d2) - dot(e1, d2) * dot(e2, d1), at.gaussian_curvature, bound);
        ++compared[static_cast<int>(at.patch)];
    }
    for (const int count : compared) EXPECT_GT(count, 20);
}

TEST(Nearest, NormalIsTheGradientOfTheDistance) {
    const AccessibleSurface surface({{{0, 0, 0}, {2.2, 0.3, 0}, {0.8, 2.4, 0.2}}, {1.7, 1.5, 1.6}}, 1.4);
    for (const Vec3 p : {Vec3{-1.9, 0.2, 0.1}, Vec3{1.0, 0.8, 1.5}, Vec3{1.2, -1.2, 0.6}, Vec3{0.9, 0.9, -2.0}}) {
        constexpr double kStep = 1e-5;
        const NearestFeature at = surface.nearest(p);
        const auto slope = [&](const Vec3& d) {
            return (surface.nearest(p + d).signed_distance - surface.nearest(p - d).signed_distance) / (2 * kStep);
        };
        EXPECT_NEAR(slope({kStep, 0, 0}), at.normal.x, 1e-6);
        EXPECT_NEAR(slope({0, kStep, 0}), at.normal.y, 1e-6);
        EXPECT_NEAR(slope({0, 0, kStep}), at.normal.z, 1e-6);
    }
}

TEST(Nearest, WorksFarFromAnOutlierAtom) {
    const AccessibleSurface surface({{{0, 0, 0}, {1e6, 0, 0}}, {1.5, 1.5}}, 1.4);
    EXPECT_NEAR(surface.nearest({1e6, 2.0, 0}).signed_distance, 0.5, 1e-9);
    EXPECT_NEAR(surface.nearest({5e5, 0, 0}).signed_distance, 5e5 - 1.5, 1e-9);
}

TEST(Nearest, AgreesWithBruteForceOnRandomClusters) {
    for (std::uint64_t seed = 0; seed < 20; ++seed)
        expect_brute_force_distances(random_cluster(seed, 40, 9.0), 0.5 * static_cast<double>(seed % 4), 500);
}

TEST(Nearest, AgreesWithBruteForceOnACubicLattice) {
    expect_brute_force_distances(cubic_lattice(3, 2.0, 1.5), 1.4, 2000);
}

TEST(Nearest, AgreesWithBruteForceOnEverySphereFile) {
    MENISCUS_NEED_TEST_DATA();
    for (const auto& entry : std::filesystem::directory_iterator(*test_data() / "reference/spheres")) {
        SCOPED_TRACE(entry.path().filename().string());
        expect_brute_force_distances(read_spheres(entry.path()), 1.4, 10000);
    }
}

TEST(Nearest, AgreesWithBruteForceOnCrambin) {
    MENISCUS_NEED_TEST_DATA();
    expect_brute_force_distances(read_spheres(*test_data() / "reference/xyzr/1crn.xyzr"), 1.4, 10000);
}

// Without a probe the seam of two spheres is the arc itself: its points look the way one of the spheres does.
TEST(Nearest, SeamsWithoutAProbeHaveUnitNormals) {
    const Vec3 centres[] = {{20.3, 30.1, 25.7}, {21.1, 31.7, 26.4}};
    const AccessibleSurface surface({{centres[0], centres[1]}, {1.5, 1.6}}, 0.0);
    std::mt19937 random(5);
    std::normal_distribution<double> offset(0.0, 1.0);
    int on_the_seam = 0;
    for (int k = 0; k < 2000; ++k) {
        const Vec3 away = normalised(Vec3{offset(random), offset(random), offset(random)});
        const NearestFeature before = surface.nearest(0.5 * (centres[0] + centres[1]) + 0.3 * away);
        const NearestFeature at = surface.nearest(before.foot);
        EXPECT_NEAR(at.signed_distance, 0.0, 1e-9);  // atoms are shifted by 1e-10 Å
        EXPECT_NEAR(norm(at.normal), 1.0, 1e-12);
        EXPECT_GT(dot(at.normal, before.foot - centres[at.atom]), 0.0);
        on_the_seam += at.patch == PatchKind::Contact ? 0 : 1;
    }
    EXPECT_GT(on_the_seam, 100);
}

}  // namespace
}  // namespace meniscus::testing
