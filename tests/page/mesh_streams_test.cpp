// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "page/mesh_streams.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "page/decoding.h"

namespace meniscus::page {
namespace {

using testing::SmallMolecule;

/// The map of viewer/shaders.js.
Vec3 normal_of(std::uint8_t first, std::uint8_t second) {
    const double u = first / 127.0 - 1.0;
    const double v = second / 127.0 - 1.0;
    Vec3 n{u, v, 1.0 - std::abs(u) - std::abs(v)};
    if (n.z < 0.0) n = {(1.0 - std::abs(v)) * std::copysign(1.0, u), (1.0 - std::abs(u)) * std::copysign(1.0, v), n.z};
    return normalised(n);
}

TEST(MeshStreams, TrianglesReadBackInTheNewOrder) {
    const Mesh mesh = SmallMolecule().mesh;
    const VertexOrder order = order_of_use(mesh);
    const std::vector<Triangle> read = testing::triangles(order.triangles);
    ASSERT_EQ(read.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < read.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(order.vertices[read[t][k]], mesh.triangles[t][k]);
}

TEST(MeshStreams, VerticesThatNoTriangleUsesAreLeftOut) {
    Mesh mesh = testing::tetrahedron();
    mesh.vertices.push_back({9, 9, 9});
    EXPECT_EQ(order_of_use(mesh).vertices, (std::vector<VertexId>{0, 2, 1, 3}));
}

TEST(MeshStreams, CoordinatesAreWithinHalfAQuantum) {
    const Mesh mesh = SmallMolecule().mesh;
    const std::vector<std::int64_t> steps = quantised(mesh.vertices, &Vec3::x, -3.0);
    for (std::size_t v = 0; v < steps.size(); ++v)
        EXPECT_NEAR(-3.0 + kQuantum * static_cast<double>(steps[v]), mesh.vertices[v].x, 0.5 * kQuantum + 1e-12);
}

TEST(MeshStreams, NormalsAreWithinADegree) {
    for (const SmallVec3& normal : SmallMolecule().mesh.normals) {
        const auto [u, v] = octahedral(normal);
        EXPECT_GT(dot(normal_of(u, v), normal), std::cos(1.0 * 3.14159 / 180.0));
    }
    for (const Vec3& axis : {Vec3{0, 0, -1}, Vec3{0, 0, 1}, Vec3{-1, 0, 0}, Vec3{0, 1, 0}}) {
        const auto [u, v] = octahedral(axis);
        EXPECT_NEAR(dot(normal_of(u, v), axis), 1.0, 1e-9);
    }
}

TEST(MeshStreams, ArraysThatAreMissingHaveNoStream) {
    Mesh mesh = SmallMolecule().mesh;
    mesh.mean_curvatures.clear();
    Streams streams;
    add_mesh(streams, mesh, {}, {});
    const auto has = [&](const char* name) {
        return std::any_of(streams.places().begin(), streams.places().end(),
                           [&](const auto& p) { return p.name == name; });
    };
    EXPECT_TRUE(has("atom") && has("patch") && has("component"));
    EXPECT_FALSE(has("curvature") || has("shape") || has("depth") || has("sky"));
}

TEST(MeshStreams, ValuesAreWithinHalfAStepAndMinusOneWhereThereIsNone) {
    Mesh mesh = testing::tetrahedron();
    mesh.normals.resize(4);
    mesh.atoms.resize(4);
    mesh.patches.resize(4);
    mesh.values = {{"a", {-2.0F, 6.0F, NAN, 0.1F}}, {"b", {7.0F, 7.0F, 7.0F, 7.0F}}};
    Streams streams;
    add_mesh(streams, mesh, {}, {});
    const auto steps = [&](const std::string& name) {
        const auto place = std::find_if(streams.places().begin(), streams.places().end(),
                                        [&](const Streams::Place& p) { return p.name == name; });
        return testing::sums(std::string_view(streams.bytes()).substr(place->offset, place->size));
    };
    const ValueScale scale = scale_of(mesh.values[0]);
    const auto first = steps("value-0");
    const std::vector<VertexId> order = order_of_use(mesh).vertices;
    for (std::size_t i = 0; i < 4; ++i) {
        const double value{mesh.values[0].values[order[i]]};
        if (std::isnan(value))
            EXPECT_EQ(first[i], -1);
        else
            EXPECT_NEAR(scale.low + scale.step * static_cast<double>(first[i]), value, 0.51 * scale.step);
    }
    EXPECT_EQ(steps("value-1"), (std::vector<std::int64_t>{0, 0, 0, 0}));
    EXPECT_EQ(scale_of(mesh.values[1]).low, 7.0);
}

}  // namespace
}  // namespace meniscus::page
