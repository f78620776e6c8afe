// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/narrow_handles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "remesh/self_intersections.h"
#include "support/mesh_checks.h"
#include "support/shapes.h"

namespace meniscus::testing {
namespace {

template <class Shape>
SurfaceProjector onto(const Shape& shape) {
    return [shape](std::span<SurfacePoint> points) {
        constexpr double kStep = 1e-5;
        for (SurfacePoint& point : points)
            for (int i = 0; i < 3; ++i) {
                const auto slope = [&](const Vec3& along) {
                    return shape(point.position + kStep * along) - shape(point.position - kStep * along);
                };
                point.normal = normalised(Vec3{slope({1, 0, 0}), slope({0, 1, 0}), slope({0, 0, 1})});
                point.position = point.position - shape(point.position) * point.normal;
            }
    };
}

template <class Shape>
Mesh extracted(const Shape& shape, double reach) {
    const SampledField field = sample_box(0.25, {-reach, -reach, -reach}, {reach, reach, reach}, shape);
    return extract_zero_set(field.grid, field.values);
}

std::size_t pieces_of(const Mesh& mesh) { return measure_mesh(mesh).components.size(); }

// One piece without handles, made from one with a single handle.
void expect_ball(const CutMesh& cut) {
    EXPECT_EQ(cut.handles, 1u);
    expect_closed_manifold(cut.mesh);
    EXPECT_EQ(euler_characteristic_of(cut.mesh), 2);
    EXPECT_EQ(pieces_of(cut.mesh), 1u);
    EXPECT_TRUE(places_of_self_intersections(cut.mesh).empty());
}

TEST(NarrowHandles, AThinRingIsCutOnce) {
    const Torus ring{2.0, 0.45};
    const Mesh mesh = extracted(ring, 3.0);
    const CutMesh cut = cut_narrow_handles(mesh, 1.0, onto(ring));
    expect_ball(cut);
    for (const Vec3& v : cut.mesh.vertices) EXPECT_NEAR(ring(v), 0.0, 0.05);
    EXPECT_NEAR(volume_of(cut.mesh), volume_of(mesh), 0.1 * volume_of(mesh));
}

TEST(NarrowHandles, ANarrowTunnelIsClosed) {
    const Torus ring{1.75, 1.3};
    const Mesh mesh = extracted(ring, 3.5);
    const CutMesh cut = cut_narrow_handles(mesh, 1.0, onto(ring));
    expect_ball(cut);
    EXPECT_NEAR(volume_of(cut.mesh), volume_of(mesh), 0.1 * volume_of(mesh));
}

TEST(NarrowHandles, EndsLieApart) {
    const Torus ring{2.0, 0.45};
    const Mesh mesh = extracted(ring, 3.0);
    const CutMesh cut = cut_narrow_handles(mesh, 1.0, onto(ring));
    std::set<std::array<double, 3>> places;
    for (const Vec3& v : cut.mesh.vertices)
        places.insert({std::round(1e3 * v.x), std::round(1e3 * v.y), std::round(1e3 * v.z)});
    EXPECT_EQ(places.size(), cut.mesh.vertices.size());
}

TEST(NarrowHandles, WideOnesStayAndTheMeshIsTheSame) {
    for (const Torus ring : {Torus{2.0, 0.6}, Torus{2.0, 1.3}}) {
        const Mesh mesh = extracted(ring, 3.5);
        const CutMesh cut =
            cut_narrow_handles(mesh, 0.95 * 2.0 * std::min(ring.minor, ring.major - ring.minor), onto(ring));
        EXPECT_EQ(cut.handles, 0u);
        EXPECT_EQ(cut.mesh.vertices, mesh.vertices);
        EXPECT_EQ(cut.mesh.triangles, mesh.triangles);
    }
}

TEST(NarrowHandles, ANeckBetweenTwoBallsStays) {
    const auto dumbbell = [](const Vec3& p) {
        const double neck = std::max(std::hypot(p.x, p.y) - 0.4, std::abs(p.z) - 2.0);
        return std::min({Sphere{{0, 0, 2}, 1.2}(p), Sphere{{0, 0, -2}, 1.2}(p), neck});
    };
    const Mesh mesh = extracted(dumbbell, 3.5);
    EXPECT_EQ(pieces_of(mesh), 1u);
    EXPECT_EQ(cut_narrow_handles(mesh, 1.5, onto(dumbbell)).handles, 0u);
}

TEST(NarrowHandles, ATunnelWithSomethingInItStays) {
    const Torus ring{1.75, 1.3};
    const auto thread = [](const Vec3& p) { return std::max(std::hypot(p.x, p.y) - 0.15, std::abs(p.z) - 2.5); };
    Mesh mesh = extracted(ring, 3.5);
    append(mesh, extracted(thread, 3.5));
    EXPECT_EQ(euler_characteristic_of(mesh), 2);
    const CutMesh cut =
        cut_narrow_handles(mesh, 1.0, onto([&](const Vec3& p) { return std::min(ring(p), thread(p)); }));
    EXPECT_EQ(cut.handles, 0u);
    EXPECT_TRUE(places_of_self_intersections(cut.mesh).empty());
}

TEST(NarrowHandles, SeveralAreCutTogether) {
    // Three rings in a chain: they run into each other.
    const auto chain = [](const Vec3& p) {
        double least = Torus{1.2, 0.35}(p);
        for (const double shift : {-2.4, 2.4}) least = std::min(least, Torus{1.2, 0.35}(p - Vec3{shift, 0, 0}));
        return least;
    };
    const Mesh mesh = extracted(chain, 4.5);
    ASSERT_EQ(euler_characteristic_of(mesh), -4);
    const CutMesh cut = cut_narrow_handles(mesh, 0.9, onto(chain));
    EXPECT_EQ(cut.handles, 3u);
    expect_closed_manifold(cut.mesh);
    EXPECT_EQ(euler_characteristic_of(cut.mesh), 2);
    EXPECT_EQ(pieces_of(cut.mesh), 1u);
}

}  // namespace
}  // namespace meniscus::testing
