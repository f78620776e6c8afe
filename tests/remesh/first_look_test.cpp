// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/first_look.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

#include "measure/triangle_survey.h"
#include "mesh/components.h"
#include "remesh/mend_slivers.h"
#include "remesh/patch.h"
#include "remesh/remesher.h"
#include "space/triangle_tree.h"
#include "support/shapes.h"

namespace meniscus::testing {
namespace {

constexpr double kAngle = 8.0;

// Vertices next to nodes make small angles; some normals are turned.
Mesh sphere_with_slivers() {
    Mesh mesh = projected_sphere({.centre = {0.1, -0.2, 0.05}, .radius = 3.0}, 0.2);
    for (std::size_t v = 0; v < mesh.normals.size(); v += 97) mesh.normals[v] = -mesh.normals[v];
    for (std::size_t v = 50; v < mesh.normals.size(); v += 97)
        mesh.normals[v] = to_small(normalised(mesh.normals[v] + 3.0 * cross(mesh.normals[v], Vec3{0.2, 0.5, 0.8})));
    label_components(mesh);
    return mesh;
}

TEST(FirstLook, SuspectsEveryBadAndEveryLeaningTriangle) {
    const Mesh mesh = sphere_with_slivers();
    FirstLook look(mesh, kAngle, kShortestEdge);
    look.look_at_all();
    const FirstLook::Suspects suspects = std::move(look).suspects();
    EXPECT_TRUE(std::is_sorted(suspects.bad.begin(), suspects.bad.end()));
    EXPECT_TRUE(std::is_sorted(suspects.leaning.begin(), suspects.leaning.end()));
    std::size_t bad = 0;
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
        Patch alone;
        double least = 1.0;
        const auto& [a, b, c] = mesh.triangles[t];
        const Vec3 normal = normalised(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]));
        for (const VertexId v : mesh.triangles[t]) {
            alone.points.push_back({mesh.vertices[v], mesh.normals[v], 0.0});
            least = std::min(least, dot(normal, mesh.normals[v]));
        }
        if (alone.goodness({0, 1, 2}, kShortestEdge) < tangent_of_degrees(kAngle)) {
            ++bad;
            EXPECT_TRUE(std::binary_search(suspects.bad.begin(), suspects.bad.end(), t)) << t;
        }
        EXPECT_EQ(std::binary_search(suspects.leaning.begin(), suspects.leaning.end(), t), least < 0.4) << t;
    }
    EXPECT_GT(bad, 100U);
    EXPECT_LT(suspects.bad.size(), bad + bad / 10);
}

TEST(FirstLook, BoxesHoldTheirTriangles) {
    Mesh mesh = sphere_with_slivers();
    FirstLook look(mesh, kAngle, kShortestEdge);
    look.look_at_all();
    TriangleBoxes boxes = std::move(look).suspects().boxes;
    const auto expect_all_held = [&] {
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            const Box box = box_of(mesh, mesh.triangles[t]);
            const std::size_t chunk = t / TriangleBoxes::kChunk;
            EXPECT_TRUE(boxes.chunks[chunk].contains(box));
            const Vec3& corner = mesh.vertices[mesh.triangles[t][0]];
            EXPECT_TRUE(boxes.stretches[t / TriangleBoxes::kStretch].box().contains(box));
            EXPECT_TRUE((Box{corner, corner}.grown(boxes.longest[chunk]).contains(box)));
        }
    };
    expect_all_held();
    mesh.triangles.resize(mesh.triangles.size() + 300, mesh.triangles.front());
    boxes.resize(mesh.triangles.size());
    for (std::size_t t = mesh.triangles.size() - 300; t < mesh.triangles.size(); ++t)
        boxes.include(mesh, static_cast<std::uint32_t>(t));
    expect_all_held();
}

TEST(FirstLook, SeesTheSameDuringASurvey) {
    const Mesh mesh = sphere_with_slivers();
    FirstLook alone(mesh, kAngle, kShortestEdge);
    alone.look_at_all();
    FirstLook during(mesh, kAngle, kShortestEdge);
    const TriangleSurvey survey(mesh, mesh.components, TriangleSurvey::Parts::Smooth,
                                [&](std::size_t first, std::span<const Triangle> triangles,
                                    const TriangleLanes& lanes) { during.look(first, triangles, lanes); });
    const FirstLook::Suspects expected = std::move(alone).suspects();
    const FirstLook::Suspects seen = std::move(during).suspects();
    EXPECT_EQ(seen.bad, expected.bad);
    EXPECT_EQ(seen.leaning, expected.leaning);
    for (std::size_t c = 0; c < expected.boxes.longest.size(); ++c)
        EXPECT_NEAR(seen.boxes.longest[c], expected.boxes.longest[c], 1e-12);
    for (std::size_t s = 0; s < expected.boxes.stretches.size(); ++s) {
        const Box box = expected.boxes.stretches[s].box();
        EXPECT_TRUE(seen.boxes.stretches[s].box().grown(1e-6).contains(box));
        EXPECT_TRUE(box.grown(1e-6).contains(seen.boxes.stretches[s].box()));
    }
    EXPECT_GT(survey.measures(mesh.components).area, 0.0);
}

}  // namespace
}  // namespace meniscus::testing
