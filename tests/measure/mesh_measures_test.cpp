// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "core/parallel.h"
#include "measure/corrected.h"
#include "measure/surface_measures.h"
#include "meniscus/errors.h"
#include "meniscus/mesh.h"
#include "meniscus/threads.h"
#include "mesh/components.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace meniscus {
namespace {

using testing::append;
using testing::extracted_sphere;
using testing::projected_sphere;
using testing::tetrahedron;

TEST(MeshMeasures, Tetrahedron) {
    const MeshMeasures measures = measure_mesh(tetrahedron());
    EXPECT_NEAR(measures.area, 8.0 * std::sqrt(3.0), 1e-14);
    EXPECT_NEAR(measures.volume, 8.0 / 3.0, 1e-14);
    EXPECT_TRUE(measures.closed);
    EXPECT_TRUE(measures.manifold);
    EXPECT_EQ(measures.euler_characteristic, 2);
    EXPECT_NEAR(measures.smallest_angle_deg, 60.0, 1e-12);
    EXPECT_NEAR(measures.shortest_edge, 2.0 * std::sqrt(2.0), 1e-14);
    ASSERT_EQ(measures.components.size(), 1U);
    EXPECT_EQ(measures.components[0].triangles, 4U);
}

TEST(MeshMeasures, NothingMeasuresNothing) {
    const MeshMeasures measures = measure_mesh({});
    EXPECT_EQ(measures.area, 0.0);
    EXPECT_EQ(measures.volume, 0.0);
    EXPECT_EQ(measures.smallest_angle_deg, 0.0);
    EXPECT_EQ(measures.shortest_edge, 0.0);
    EXPECT_TRUE(measures.components.empty());
}

TEST(MeshMeasures, AgreesWithPlainSums) {
    const Mesh mesh = extracted_sphere({.centre = {0.3, -0.1, 0.2}, .radius = 2.0}, 0.2);
    const MeshMeasures measures = measure_mesh(mesh);
    EXPECT_NEAR(measures.area, testing::area_of(mesh), 1e-9);
    EXPECT_NEAR(measures.volume, testing::volume_of(mesh), 1e-9);
    EXPECT_EQ(measures.euler_characteristic, testing::euler_characteristic_of(mesh));
}

TEST(MeshMeasures, PlainSumsConvergeWithSecondOrder) {
    double previous_area = 1.0;
    double previous_volume = 1.0;
    for (const double spacing : {0.4, 0.2, 0.1}) {
        const MeshMeasures m =
            measure_mesh(testing::projected_sphere({.centre = {0.01, 0.02, 0.03}, .radius = 2.0}, spacing));
        const double area = std::abs(m.area / (16.0 * std::numbers::pi) - 1.0);
        const double volume = std::abs(m.volume / (32.0 / 3.0 * std::numbers::pi) - 1.0);
        EXPECT_GT(previous_area / area, 3.6);
        EXPECT_GT(previous_volume / volume, 3.6);
        previous_area = area;
        previous_volume = volume;
    }
}

TEST(MeshMeasures, CavitiesCountNegative) {
    Mesh mesh = extracted_sphere({.centre = {}, .radius = 3.0}, 0.25);
    append(mesh, testing::turned_inside_out(extracted_sphere({.centre = {}, .radius = 1.0}, 0.25)));
    const MeshMeasures measures = measure_mesh(mesh);
    ASSERT_EQ(measures.components.size(), 2U);
    EXPECT_LT(measures.components[1].volume, 0.0);
    EXPECT_DOUBLE_EQ(measures.volume, measures.components[0].volume + measures.components[1].volume);
    EXPECT_EQ(measures.euler_characteristic, 4);
}

TEST(MeshMeasures, UsesTheComponentsOfTheMesh) {
    Mesh mesh = tetrahedron();
    append(mesh, tetrahedron());
    EXPECT_EQ(measure_mesh(mesh).components.size(), 2U);
    mesh.components.assign(8, 0);
    EXPECT_EQ(measure_mesh(mesh).components.size(), 1U);
}

TEST(MeshMeasures, SameNumbersWithAndWithoutLabels) {
    Mesh mesh = extracted_sphere({.centre = {5, 0, 0}, .radius = 1.0}, 0.25);
    append(mesh, extracted_sphere({.centre = {}, .radius = 2.0}, 0.25));
    const MeshMeasures before = measure_mesh(mesh);
    label_components(mesh);
    const MeshMeasures after = measure_mesh(mesh);
    EXPECT_EQ(before.area, after.area);
    EXPECT_EQ(before.volume, after.volume);
    EXPECT_EQ(before.components[0].triangles, after.components[0].triangles);
}

TEST(MeshMeasures, SmallestAngleOfASliver) {
    const double width = std::tan(0.001 * std::numbers::pi / 180.0);
    for (const Triangle& t : {Triangle{0, 1, 2}, Triangle{1, 2, 0}, Triangle{2, 0, 1}}) {
        const Mesh mesh{.vertices = {{0, 0, 0}, {1, 0, 0}, {1, width, 0}},
                        .normals = {},
                        .atoms = {},
                        .patches = {},
                        .components = {},
                        .triangles = {t}};
        EXPECT_NEAR(measure_mesh(mesh).smallest_angle_deg, 0.001, 1e-12);
    }
}

TEST(MeshMeasures, DegenerateTrianglesHaveNoAngle) {
    Mesh mesh = tetrahedron();
    mesh.vertices[0] = mesh.vertices[1];
    EXPECT_EQ(measure_mesh(mesh).smallest_angle_deg, 0.0);
    mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {3, 0, 0}, {0, 1, 0}};
    EXPECT_EQ(measure_mesh(mesh).smallest_angle_deg, 0.0);
    mesh.vertices = {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}};
    EXPECT_EQ(measure_mesh(mesh).smallest_angle_deg, 0.0);
}

TEST(MeshMeasures, MalformedMeshesAreRefused) {
    Mesh mesh = tetrahedron();
    mesh.triangles[2][1] = 4;
    EXPECT_THROW(measure_mesh(mesh), UsageError);
    mesh = tetrahedron();
    mesh.components = {0, 0, 0};
    EXPECT_THROW(measure_mesh(mesh), UsageError);
    mesh.components = {0, 0, 0, 0xffffffffU};
    EXPECT_THROW(measure_mesh(mesh), UsageError);
}

Mesh two_spheres() {
    Mesh mesh = projected_sphere({.centre = {1, 2, 3}, .radius = 2.0}, 0.1);
    const Mesh other = projected_sphere({.centre = {9, 2, 3}, .radius = 3.0}, 0.1);
    append(mesh, other);
    mesh.normals.insert(mesh.normals.end(), other.normals.begin(), other.normals.end());
    return mesh;
}

SurfaceMeasures measured(Mesh& mesh, Creases creases) {
    return measure_surface(mesh, survey_surface(mesh, creases), Stars::Examined);
}

TEST(MeasureSurface, IsWhatTheSeparateMeasuresAre) {
    Mesh mesh = two_spheres();
    label_components(mesh);
    const SurfaceMeasures surface = measured(mesh, Creases::Sharp);
    const MeshMeasures plain = measure_mesh(mesh);
    EXPECT_EQ(surface.mesh.area, plain.area);
    EXPECT_EQ(surface.mesh.volume, plain.volume);
    EXPECT_EQ(surface.mesh.smallest_angle_deg, plain.smallest_angle_deg);
    EXPECT_TRUE(surface.mesh.closed && surface.mesh.manifold);
    EXPECT_EQ(surface.mesh.euler_characteristic, 4);
    const CorrectedMeasures corrected = corrected_measures(mesh);
    EXPECT_NEAR(surface.corrected.area, corrected.area, 1e-11 * corrected.area);
    EXPECT_NEAR(surface.corrected.volume, corrected.volume, 1e-11 * corrected.volume);
    const double sum = std::accumulate(surface.areas.begin(), surface.areas.end(), 0.0);
    EXPECT_NEAR(sum, plain.area, 1e-6 * plain.area);
}

// Two caps that meet in a sharp circle, each of the height 1: they measure 4π · 3.
Mesh lens(double spacing) {
    const testing::Sphere upper{.centre = {0.01, 0.02, -1.97}, .radius = 3.0};
    const testing::Sphere lower{.centre = {0.01, 0.02, 2.03}, .radius = 3.0};
    const auto field = testing::sample_box(spacing, {-3, -3, -2}, {3, 3, 2},
                                           [&](const Vec3& p) { return std::max(upper(p), lower(p)); });
    Mesh mesh = extract_zero_set(field.grid, field.values);
    for (Vec3& v : mesh.vertices) {
        const testing::Sphere& cap = upper(v) >= lower(v) ? upper : lower;
        const Vec3 normal = normalised(v - cap.centre);
        mesh.normals.push_back(to_small(normal));
        v = cap.centre + cap.radius * normal;
    }
    label_components(mesh);
    return mesh;
}

TEST(MeasureSurface, CorrectedMeasuresFollowCreasesWhereCurvaturesTellThem) {
    const double area = 12.0 * std::numbers::pi;
    const double volume = 2.0 * std::numbers::pi * (3.0 - 1.0 / 3.0);
    for (const double spacing : {0.4, 0.2, 0.1}) {
        Mesh mesh = lens(spacing);
        const CorrectedMeasures rounded = measured(mesh, Creases::Sharp).corrected;  // nothing tells them
        EXPECT_LT(rounded.area / area, 1.0 - 0.015 * spacing);
        mesh.mean_curvatures.assign(mesh.vertices.size(), 1.0F / 3.0F);
        mesh.gaussian_curvatures.assign(mesh.vertices.size(), 1.0F / 9.0F);
        const CorrectedMeasures sharp = measured(mesh, Creases::Sharp).corrected;
        EXPECT_NEAR(sharp.area / area, 1.0, 0.07 * spacing * spacing);
        EXPECT_NEAR(sharp.volume / volume, 1.0, 0.07 * spacing * spacing);
        EXPECT_EQ(measured(mesh, Creases::Rounded).corrected.area, rounded.area);
    }
}

TEST(MeasureSurface, PiecesAreThoseOfMeasureComponents) {
    Mesh mesh = two_spheres();
    const std::vector<MeshComponent> expected = label_components(mesh);
    const std::vector<MeshComponent> pieces = measured(mesh, Creases::Sharp).mesh.components;
    ASSERT_EQ(pieces.size(), expected.size());
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        EXPECT_EQ(pieces[p].vertices, expected[p].vertices);
        EXPECT_EQ(pieces[p].triangles, expected[p].triangles);
        EXPECT_NEAR(pieces[p].area, expected[p].area, 1e-11 * expected[p].area);
        EXPECT_NEAR(pieces[p].volume, expected[p].volume, 1e-11 * expected[p].volume);
    }
}

TEST(MeasureSurface, SameBitsForAnyNumberOfThreads) {
    Mesh mesh = projected_sphere({.centre = {1, 2, 3}, .radius = 2.0}, 0.03);
    label_components(mesh);
    const auto with_threads = [&](int threads) {
        const ThreadLimit limit(threads);
        return measured(mesh, Creases::Sharp);
    };
    const SurfaceMeasures one = with_threads(1);
    const SurfaceMeasures four = with_threads(4);
    EXPECT_EQ(one.mesh.area, four.mesh.area);
    EXPECT_EQ(one.corrected.area, four.corrected.area);
    EXPECT_EQ(one.corrected.volume, four.corrected.volume);
    EXPECT_EQ(one.areas, four.areas);
}

TEST(MeasureSurface, NeedsNormalsComponentsAndCornersThatExist) {
    Mesh mesh = tetrahedron();
    label_components(mesh);
    EXPECT_THROW(survey_surface(mesh, Creases::Sharp), UsageError);
    mesh.normals.resize(mesh.vertices.size());
    mesh.components.clear();
    EXPECT_THROW(survey_surface(mesh, Creases::Sharp), UsageError);
    label_components(mesh);
    const TriangleSurvey survey = survey_surface(mesh, Creases::Sharp);
    mesh.triangles[2][1] = 4;
    EXPECT_THROW(survey_surface(mesh, Creases::Sharp), UsageError);
    EXPECT_THROW(measure_surface(mesh, survey, Stars::Trusted), UsageError);
}

}  // namespace
}  // namespace meniscus
