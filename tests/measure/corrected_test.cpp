// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/corrected.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/parallel.h"
#include "meniscus/errors.h"
#include "meniscus/threads.h"
#include "support/shapes.h"

namespace meniscus {
namespace {

using testing::Sphere;
using testing::Torus;

const Sphere kSphere{.centre = {0.01, 0.02, 0.03}, .radius = 2.0};
constexpr Torus kTorus{.major = 2.0, .minor = 0.8};

void project_to_sphere(std::span<Vec3> points, std::span<Vec3> normals) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        normals[i] = normalised(points[i] - kSphere.centre);
        points[i] = kSphere.centre + kSphere.radius * normals[i];
    }
}

Vec3 torus_centre_near(const Vec3& p) {
    const double r = std::hypot(p.x, p.y);
    return {kTorus.major * p.x / r, kTorus.major * p.y / r, 0.0};
}

void project_to_torus(std::span<Vec3> points, std::span<Vec3> normals) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3 centre = torus_centre_near(points[i]);
        normals[i] = normalised(points[i] - centre);
        points[i] = centre + kTorus.minor * normals[i];
    }
}

Mesh projected_torus(double spacing) {
    const auto field = testing::sample_box(spacing, {-3, -3, -1}, {3, 3, 1}, kTorus);
    Mesh mesh = extract_zero_set(field.grid, field.values);
    std::vector<Vec3> normals(mesh.vertices.size());
    project_to_torus(mesh.vertices, normals);
    for (const Vec3& normal : normals) mesh.normals.push_back(to_small(normal));
    return mesh;
}

// Both relative errors stay under a multiple of h⁴ while h falls to an eighth. (Ratios of successive errors would not
// do: the area of the torus has errors of both signs that cancel at one spacing or other.)
template <class MakeMesh, class Measure>
void expect_fourth_order(const MakeMesh& make, const Measure& measure, double area, double volume) {
    for (const double spacing : {0.4, 0.2, 0.1, 0.05}) {
        const CorrectedMeasures m = measure(make(spacing));
        EXPECT_NEAR(m.area / area, 1.0, 0.06 * std::pow(spacing, 4)) << "spacing " << spacing;
        EXPECT_NEAR(m.volume / volume, 1.0, 0.06 * std::pow(spacing, 4)) << "spacing " << spacing;
    }
}

TEST(Corrected, FourthOrderOnASphereByProjection) {
    expect_fourth_order([](double h) { return testing::projected_sphere(kSphere, h); },
                        [](const Mesh& mesh) { return corrected_measures(mesh, project_to_sphere); },
                        16.0 * std::numbers::pi, 32.0 / 3.0 * std::numbers::pi);
}

TEST(Corrected, OneMoreDivisionIsWorthHalfTheSpacing) {
    for (const double spacing : {0.4, 0.2}) {
        const CorrectedMeasures m =
            corrected_measures(testing::projected_sphere(kSphere, spacing), project_to_sphere, 2);
        EXPECT_NEAR(m.area / (16.0 * std::numbers::pi), 1.0, 0.06 * std::pow(spacing / 2.0, 4));
        EXPECT_NEAR(m.volume / (32.0 / 3.0 * std::numbers::pi), 1.0, 0.06 * std::pow(spacing / 2.0, 4));
    }
}

TEST(Corrected, FourthOrderOnASphereByNormals) {
    expect_fourth_order([](double h) { return testing::projected_sphere(kSphere, h); },
                        [](const Mesh& mesh) { return corrected_measures(mesh); }, 16.0 * std::numbers::pi,
                        32.0 / 3.0 * std::numbers::pi);
}

TEST(Corrected, FourthOrderOnATorusByProjection) {
    expect_fourth_order(
        projected_torus, [](const Mesh& mesh) { return corrected_measures(mesh, project_to_torus); },
        4.0 * std::numbers::pi * std::numbers::pi * 1.6, 2.0 * std::numbers::pi * std::numbers::pi * 2.0 * 0.64);
}

TEST(Corrected, FourthOrderOnATorusByNormals) {
    expect_fourth_order(
        projected_torus, [](const Mesh& mesh) { return corrected_measures(mesh); },
        4.0 * std::numbers::pi * std::numbers::pi * 1.6, 2.0 * std::numbers::pi * std::numbers::pi * 2.0 * 0.64);
}

TEST(Corrected, TheProjectorIsGivenPlacesNearTheSurface) {
    Mesh mesh = testing::tetrahedron();
    std::vector<Vec3> normals(mesh.vertices.size());
    project_to_sphere(mesh.vertices, normals);
    for (const Vec3& normal : normals) mesh.normals.push_back(to_small(normal));
    const auto project = [](std::span<Vec3> points, std::span<Vec3> looking) {
        for (const Vec3& p : points) EXPECT_NEAR(norm(p - kSphere.centre), kSphere.radius, 0.3);  // the chord's: 0.85
        project_to_sphere(points, looking);
    };
    EXPECT_NEAR(corrected_measures(mesh, project, 4).area, 16.0 * std::numbers::pi, 1e-3 * 16.0 * std::numbers::pi);
}

TEST(Corrected, FlatSurfacesStayAsTheyAre) {
    Mesh mesh = testing::tetrahedron();
    mesh.normals.resize(mesh.vertices.size());  // that say nothing
    const CorrectedMeasures m = corrected_measures(mesh, [](std::span<Vec3>, std::span<Vec3>) {});
    EXPECT_NEAR(m.area, 8.0 * std::sqrt(3.0), 1e-13);
    EXPECT_NEAR(m.volume, 8.0 / 3.0, 1e-13);
}

// The middle of a square's diagonal lands beyond the square.
TEST(Corrected, PartsThatFoldOverCancel) {
    Mesh mesh;
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
    mesh.normals.assign(4, {0, 0, 1});
    const auto project = [](std::span<Vec3> points, std::span<Vec3> normals) {
        for (Vec3& p : points)
            if (p.x == 0.5 && p.y == 0.5) p = {1.2, 1.3, 0};
        std::fill(normals.begin(), normals.end(), Vec3{0, 0, 1});
    };
    EXPECT_NEAR(corrected_measures(mesh, project).area, 1.0, 1e-12);
}

TEST(Corrected, NothingMeasuresNothing) {
    EXPECT_EQ(corrected_measures(Mesh{}).area, 0.0);
    EXPECT_EQ(corrected_measures(Mesh{}, project_to_sphere).volume, 0.0);
}

TEST(Corrected, SameBitsForAnyNumberOfThreads) {
    const Mesh mesh = testing::projected_sphere(kSphere, 0.05);
    const auto with_threads = [&](int threads) {
        const ThreadLimit limit(threads);
        return corrected_measures(mesh, project_to_sphere);
    };
    EXPECT_EQ(with_threads(1).area, with_threads(4).area);
    EXPECT_EQ(with_threads(1).volume, with_threads(4).volume);
}

TEST(Corrected, NormalsAreRequired) {
    EXPECT_THROW(corrected_measures(testing::tetrahedron()), UsageError);
    EXPECT_THROW(corrected_measures(testing::tetrahedron(), project_to_sphere), UsageError);
}

}  // namespace
}  // namespace meniscus
