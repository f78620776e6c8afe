// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/triangle_lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "core/instructions.h"
#include "measure/corrected.h"
#include "support/shapes.h"

namespace meniscus::testing {
namespace {

Vec3 random_vector(std::mt19937& random) {
    std::uniform_real_distribution<double> within(-1.0, 1.0);
    return {within(random), within(random), within(random)};
}

TriangleLanes random_triangles() {
    std::mt19937 random(3);
    TriangleLanes lanes;
    for (std::size_t i = 0; i < kLanes; ++i)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            lanes.points[corner].set(i, random_vector(random));
            lanes.normals[corner].set(i, normalised(random_vector(random)));
        }
    for (std::size_t corner = 1; corner < 3; ++corner) lanes.points[corner].set(7, lanes.points[0].at(7));  // a point
    return lanes;
}

double corner_at(const Vec3& a, const Vec3& b, const Vec3& c) {
    return std::acos(dot(normalised(b - a), normalised(c - a)));
}

TEST(TriangleLanes, MeasureEveryTriangle) {
    TriangleLanes lanes = random_triangles();
    triangle_kernels().measure(lanes);
    for (std::size_t i = 0; i < kLanes; ++i) {
        const Vec3 a = lanes.points[0].at(i);
        const Vec3 b = lanes.points[1].at(i);
        const Vec3 c = lanes.points[2].at(i);
        EXPECT_NEAR(lanes.two_areas[i], norm(cross(b - a, c - a)), 1e-14);
        EXPECT_NEAR(lanes.six_volumes[i], dot(a, cross(b, c)), 1e-14);
        if (i == 7) {
            EXPECT_EQ(lanes.opposite[i] / lanes.adjacent[i], 0.0);
            continue;
        }
        const double smallest = std::min({corner_at(a, b, c), corner_at(b, c, a), corner_at(c, a, b)});
        EXPECT_NEAR(std::atan(std::sqrt(lanes.opposite[i] / lanes.adjacent[i])), smallest, 1e-7);
    }
}

TEST(TriangleLanes, MeasureThePartsOfEveryTriangle) {
    TriangleLanes lanes = random_triangles();
    triangle_kernels().measure_with_parts(lanes);
    for (std::size_t i = 0; i < kLanes; ++i) {
        Vec3 corners[3];
        Vec3 middles[3];  // of the sides from corner i to corner i + 1
        for (std::size_t k = 0; k < 3; ++k) corners[k] = lanes.points[k].at(i);
        for (std::size_t k = 0; k < 3; ++k)
            middles[k] =
                arc_middle(corners[k], lanes.normals[k].at(i), corners[(k + 1) % 3], lanes.normals[(k + 1) % 3].at(i));
        double two_areas = norm(cross(middles[1] - middles[0], middles[2] - middles[0]));
        double six_volumes = dot(middles[0], cross(middles[1], middles[2]));
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& before = middles[(k + 2) % 3];
            two_areas += norm(cross(middles[k] - corners[k], before - corners[k]));
            six_volumes += dot(corners[k], cross(middles[k], before));
        }
        EXPECT_NEAR(lanes.parts_two_areas[i], two_areas, 1e-12);
        EXPECT_NEAR(lanes.parts_six_volumes[i], six_volumes, 1e-12);
    }
}

TEST(TriangleLanes, HaveTheSameBitsOnEveryInstructionSet) {
    const std::vector<TriangleKernels> all = supported_triangle_kernels();
    TriangleLanes plain = random_triangles();
    all.front().measure_with_parts(plain);
    for (const TriangleKernels& kernels : all) {
        TriangleLanes lanes = random_triangles();
        kernels.measure_with_parts(lanes);
        EXPECT_EQ(lanes.two_areas, plain.two_areas) << kernels.instructions;
        EXPECT_EQ(lanes.six_volumes, plain.six_volumes);
        EXPECT_EQ(lanes.opposite, plain.opposite);
        EXPECT_EQ(lanes.adjacent, plain.adjacent);
        EXPECT_EQ(lanes.parts_two_areas, plain.parts_two_areas);
        EXPECT_EQ(lanes.parts_six_volumes, plain.parts_six_volumes);
        EXPECT_EQ(lanes.creased, plain.creased);
    }
}

TEST(TriangleLanes, FollowTheEnvironment) {
    const std::vector<TriangleKernels> all = supported_triangle_kernels();
    EXPECT_EQ(all.front().instructions, "plain");
    std::vector<std::string_view> names;
    names.reserve(all.size());
    for (const TriangleKernels& kernels : all) names.push_back(kernels.instructions);
    EXPECT_EQ(triangle_kernels().instructions, names[choose_instructions(names, wanted_instructions())]);
}

}  // namespace
}  // namespace meniscus::testing
