// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/triangle_survey.h"

#include <gtest/gtest.h>

#include <atomic>
#include <vector>

#include "meniscus/threads.h"
#include "mesh/components.h"
#include "support/shapes.h"

namespace meniscus::testing {
namespace {

using Parts = TriangleSurvey::Parts;

// Two spheres, one within the other, whose triangles take turns.
Mesh two_pieces() {
    const Mesh outer = projected_sphere({.centre = {1, 2, 3}, .radius = 3.0}, 0.2);
    Mesh mesh = turned_inside_out(projected_sphere({.centre = {1, 2, 3}, .radius = 2.0}, 0.2));
    append(mesh, outer);
    mesh.normals.insert(mesh.normals.end(), outer.normals.begin(), outer.normals.end());
    for (std::size_t t = 0; t < mesh.triangles.size() / 2; t += 3)
        std::swap(mesh.triangles[t], mesh.triangles[mesh.triangles.size() - 1 - t]);
    mesh.mean_curvatures.assign(mesh.vertices.size(), 0.4F);
    mesh.gaussian_curvatures.assign(mesh.vertices.size(), 0.16F);
    label_components(mesh);
    return mesh;
}

void expect_same(const TriangleSurvey& a, const TriangleSurvey& b, const Mesh& mesh) {
    const MeshMeasures one = a.measures(mesh.components);
    const MeshMeasures other = b.measures(mesh.components);
    EXPECT_EQ(one.area, other.area);
    EXPECT_EQ(one.volume, other.volume);
    EXPECT_EQ(one.smallest_angle_deg, other.smallest_angle_deg);
    ASSERT_EQ(one.components.size(), other.components.size());
    for (std::size_t p = 0; p < one.components.size(); ++p) {
        EXPECT_EQ(one.components[p].vertices, other.components[p].vertices);
        EXPECT_EQ(one.components[p].triangles, other.components[p].triangles);
        EXPECT_EQ(one.components[p].volume, other.components[p].volume);
    }
    EXPECT_EQ(a.parts().area, b.parts().area);
    EXPECT_EQ(a.parts().volume, b.parts().volume);
    EXPECT_EQ(std::vector<float>(a.thirds().begin(), a.thirds().end()),
              std::vector<float>(b.thirds().begin(), b.thirds().end()));
}

TEST(TriangleSurvey, SameBitsForAnyNumberOfThreads) {
    const Mesh mesh = two_pieces();
    const TriangleSurvey several(mesh, mesh.components, Parts::Creased);
    const ThreadLimit one(1);
    expect_same(TriangleSurvey(mesh, mesh.components, Parts::Creased), several, mesh);
}

TEST(TriangleSurvey, SumsAreThoseOfThePieces) {
    const Mesh mesh = two_pieces();
    const std::vector<MeshComponent> expected = measure_components(mesh, mesh.components);
    const MeshMeasures measures = TriangleSurvey(mesh, mesh.components, Parts::LeftOut).measures(mesh.components);
    ASSERT_EQ(measures.components.size(), 2U);
    for (std::size_t p = 0; p < 2; ++p) {
        EXPECT_EQ(measures.components[p].triangles, expected[p].triangles);
        EXPECT_NEAR(measures.components[p].area, expected[p].area, 1e-11 * expected[p].area);
        EXPECT_NEAR(measures.components[p].volume, expected[p].volume, 1e-11 * expected[p].area);
    }
}

// What an update makes of a survey, beside a new one. Where the first vertices of pieces move, so do the origins of
// volumes, and new ones differ by rounding.
TEST(TriangleSurvey, AnUpdateIsASurveyAnew) {
    Mesh mesh = two_pieces();
    TriangleSurvey survey(mesh, mesh.components, Parts::Creased);
    expect_same(survey, TriangleSurvey(mesh, mesh.components, Parts::Creased), mesh);
    const VertexId last = mesh.triangles[2000][0];
    mesh.vertices[last] += 0.01 * mesh.normals[last];
    std::vector<std::uint32_t> changed;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t)
        for (const VertexId v : mesh.triangles[t])
            if (v == last) changed.push_back(t);
    survey.update(mesh, mesh.components, changed);
    expect_same(survey, TriangleSurvey(mesh, mesh.components, Parts::Creased), mesh);

    const std::vector<Triangle> end(mesh.triangles.end() - 700, mesh.triangles.end());
    mesh.triangles.resize(mesh.triangles.size() - 700);  // fewer chunks
    survey.update(mesh, mesh.components, {});
    expect_same(survey, TriangleSurvey(mesh, mesh.components, Parts::Creased), mesh);
    for (int i = 0; i < 4; ++i) mesh.triangles.insert(mesh.triangles.end(), end.begin(), end.end());  // and more
    mesh.triangles[5] = mesh.triangles[7];
    survey.update(mesh, mesh.components, std::vector<std::uint32_t>{5});
    expect_same(survey, TriangleSurvey(mesh, mesh.components, Parts::Creased), mesh);
}

TEST(TriangleSurvey, ShowsEveryTriangleOnce) {
    const Mesh mesh = two_pieces();
    std::vector<std::atomic<int>> seen(mesh.triangles.size());
    const TriangleSurvey survey(
        mesh, mesh.components, Parts::Smooth,
        [&](std::size_t first, std::span<const Triangle> triangles, const TriangleLanes& lanes) {
            EXPECT_EQ(first % kLanes, 0U);
            for (std::size_t i = 0; i < triangles.size(); ++i) {
                EXPECT_EQ(triangles[i], mesh.triangles[first + i]);
                EXPECT_GT(lanes.two_areas[i], 0.0);
                ++seen[first + i];
            }
        });
    for (const std::atomic<int>& times : seen) EXPECT_EQ(times, 1);
}

TEST(TriangleSurvey, OfNothingIsNothing) {
    const TriangleSurvey survey({}, {}, Parts::Smooth);
    EXPECT_EQ(survey.measures({}).area, 0.0);
    EXPECT_EQ(survey.parts().area, 0.0);
    EXPECT_TRUE(survey.thirds().empty());
}

}  // namespace
}  // namespace meniscus::testing
