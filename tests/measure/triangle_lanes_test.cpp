// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/triangle_lanes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <random>
#include <utility>
#include <vector>

#include "simd/instructions.h"
#include "simd/tangent_planes.h"
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
            lanes.normals[corner].set(i, to_small(normalised(random_vector(random))));
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
            middles[k] = arc_middle<Vec3>(corners[k], lanes.normals[k].at(i), corners[(k + 1) % 3],
                                          lanes.normals[(k + 1) % 3].at(i));
        double two_areas = norm(cross(middles[1] - middles[0], middles[2] - middles[0]));
        double six_volumes = dot(middles[0], cross(middles[1], middles[2]));
        for (std::size_t k = 0; k < 3; ++k) {
            const Vec3& before = middles[(k + 2) % 3];
            two_areas += norm(cross(middles[k] - corners[k], before - corners[k]));
            six_volumes += dot(corners[k], cross(middles[k], before));
        }
        EXPECT_NEAR(lanes.parts_two_areas[i], two_areas, 1e-6);
        EXPECT_NEAR(lanes.parts_six_volumes[i], six_volumes, 1e-6);
    }
}

TEST(TriangleLanes, GatherWhatIsAtTheCorners) {
    const Mesh mesh = projected_sphere({.centre = {1, 2, 3}, .radius = 2.0}, 0.5);
    const Vec3 origin{0.5, 0.25, -3.0};
    ASSERT_EQ(mesh.normals.size(), mesh.vertices.size());
    for (const TriangleKernels& kernels : supported_triangle_kernels())
        for (const std::size_t count : {0U, 1U, 3U, 4U, 63U, 64U}) {
            TriangleLanes lanes;
            const auto triangles = std::span(mesh.triangles).subspan(5, count);
            kernels.gather(mesh.vertices.data(), mesh.normals.data(), triangles, origin, lanes);
            for (std::size_t i = 0; i < count; ++i)
                for (std::size_t corner = 0; corner < 3; ++corner) {
                    const VertexId v = triangles[i][corner];
                    EXPECT_EQ(lanes.points[corner].at(i), mesh.vertices[v] - origin);
                    EXPECT_EQ(lanes.normals[corner].at(i), mesh.normals[v]);
                }
        }
}

TEST(TriangleLanes, KnowSidesAndWhereTheSurfaceLooks) {
    TriangleLanes lanes = random_triangles();
    triangle_kernels().measure_with_normals(lanes);
    for (std::size_t i = 0; i < kLanes; ++i) {
        std::array<Vec3, 3> p;
        for (std::size_t k = 0; k < 3; ++k) p[k] = lanes.points[k].at(i);
        const Vec3 normal = cross(p[1] - p[0], p[2] - p[0]);
        const std::array sides{squared_norm(p[1] - p[0]), squared_norm(p[2] - p[1]), squared_norm(p[0] - p[2])};
        EXPECT_EQ(lanes.shortest[i], *std::min_element(sides.begin(), sides.end()));
        EXPECT_EQ(lanes.longest[i], *std::max_element(sides.begin(), sides.end()));
        const std::array facing{dot(normal, lanes.normals[0].at(i)), dot(normal, lanes.normals[1].at(i)),
                                dot(normal, lanes.normals[2].at(i))};
        EXPECT_NEAR(lanes.facing[i], facing[0], 1e-6);
        EXPECT_NEAR(lanes.least_facing[i], *std::min_element(facing.begin(), facing.end()), 1e-6);
        EXPECT_NEAR(lanes.squared_normal[i], squared_norm(normal), 1e-5);
    }
}

TEST(TriangleLanes, AddUp) {
    TriangleLanes lanes = random_triangles();
    triangle_kernels().measure_with_parts(lanes);
    LaneSums sums;
    triangle_kernels().add_up(lanes, sums);
    const auto total = [](const auto& values) { return std::accumulate(values.begin(), values.end(), 0.0); };
    EXPECT_NEAR(sums.two_areas, total(lanes.two_areas), 1e-12);
    EXPECT_NEAR(sums.six_volumes, total(lanes.six_volumes), 1e-12);
    EXPECT_NEAR(sums.parts_two_areas, total(lanes.parts_two_areas), 1e-12);
    EXPECT_NEAR(sums.parts_six_volumes, total(lanes.parts_six_volumes), 1e-12);
    EXPECT_EQ(sums.smallest.opposite, 0.0);  // of the one that is a point
    EXPECT_EQ(sums.shortest, 0.0);
    lanes.shortest[7] = 1e9;
    LaneSums without_it;
    triangle_kernels().add_up(lanes, without_it);
    EXPECT_EQ(without_it.shortest, *std::min_element(lanes.shortest.begin(), lanes.shortest.end()));
    lanes.opposite[7] = 3.0 * lanes.adjacent[7];
    LaneSums others;
    triangle_kernels().add_up(lanes, others);
    double smallest = 3.0;
    for (std::size_t i = 0; i < kLanes; ++i) smallest = std::min(smallest, lanes.opposite[i] / lanes.adjacent[i]);
    EXPECT_DOUBLE_EQ(others.smallest.opposite / others.smallest.adjacent, smallest);
}

TEST(TriangleLanes, MarkWhatIsSuspect) {
    TriangleLanes lanes = random_triangles();
    triangle_kernels().measure_with_normals(lanes);
    const SuspectLimits limits{.squared_tangent = 0.05, .squared_edge = 0.1, .squared_cosine = 0.16};
    const SuspectMarks marks = triangle_kernels().mark(lanes, limits);
    std::array<std::size_t, 4> of_kind{};
    for (std::size_t i = 0; i < kLanes; ++i) {
        const bool bad =
            lanes.opposite[i] < 0.05 * lanes.adjacent[i] || lanes.shortest[i] < 0.1 || lanes.facing[i] < 0.0;
        const double least = lanes.least_facing[i];
        const bool leans = least < 0.0 || least * least < 0.16 * lanes.squared_normal[i];
        EXPECT_EQ((marks.may_be_bad >> i & 1U) != 0, bad) << i;
        EXPECT_EQ((marks.leaning >> i & 1U) != 0, leans) << i;
        ++of_kind.at((bad ? 1 : 0) + (leans ? 2 : 0));
    }
    for (const std::size_t kind : {0U, 2U, 3U}) EXPECT_GT(of_kind.at(kind), 0U) << kind;
}

// Single precision may take them for triangles that look the other way.
TEST(TriangleLanes, MarkWhatHardlyLooksTheSurfacesWay) {
    for (const TriangleKernels& kernels : supported_triangle_kernels()) {
        TriangleLanes lanes;
        for (std::size_t i = 0; i < kLanes; ++i) {
            lanes.points[1].set(i, {1, 0, 0});
            lanes.points[2].set(i, {0, 1, 0});
            const float cosine = i % 2 == 0 ? 0.9e-3F : 1.1e-3F;
            for (SmallVectorLanes& normals : lanes.normals) normals.set(i, {1.0F, 0.0F, cosine});
        }
        kernels.measure_with_normals(lanes);
        const SuspectMarks marks =
            kernels.mark(lanes, {.squared_tangent = 0.05, .squared_edge = 0.1, .squared_cosine = 0.0});
        EXPECT_EQ(marks.may_be_bad, 0x5555'5555'5555'5555U) << kernels.instructions;
        EXPECT_EQ(marks.leaning, 0U);
    }
}

TEST(TriangleLanes, AreBoundedByStretches) {
    const TriangleLanes lanes = random_triangles();
    for (const TriangleKernels& kernels : supported_triangle_kernels()) {
        EXPECT_EQ(kernels.find_least(lanes.points[1].y), *std::ranges::min_element(lanes.points[1].y));
        EXPECT_EQ(kernels.find_largest(lanes.points[1].y), *std::ranges::max_element(lanes.points[1].y));
        StretchBoxes boxes;
        kernels.bound(lanes, boxes);
        for (std::size_t s = 0; s < boxes.size(); ++s) {
            Box expected;
            for (std::size_t i = 0; i < kStretchLanes; ++i)
                for (const VectorLanes& corners : lanes.points) expected.include(corners.at(s * kStretchLanes + i));
            EXPECT_EQ(boxes[s].low, expected.low);
            EXPECT_EQ(boxes[s].high, expected.high);
        }
    }
}

TEST(TriangleLanes, MeasureTheShapeOfEveryTriangle) {
    const TriangleLanes lanes = random_triangles();
    const std::vector<TriangleKernels> all = supported_triangle_kernels();
    TriangleShapes plain;
    all.front().measure_shapes(lanes, plain);
    for (const TriangleKernels& kernels : all) {
        TriangleShapes shapes;
        kernels.measure_shapes(lanes, shapes);
        EXPECT_EQ(shapes.sides, plain.sides) << kernels.instructions;
        EXPECT_EQ(shapes.cosines, plain.cosines);
        EXPECT_EQ(shapes.one_less_cosine, plain.one_less_cosine);
        EXPECT_EQ(shapes.aspect_ratio, plain.aspect_ratio);
    }
    for (std::size_t i = 0; i < kLanes; ++i) {
        const std::array<Vec3, 3> at{lanes.points[0].at(i), lanes.points[1].at(i), lanes.points[2].at(i)};
        if (i == 7) {
            EXPECT_EQ(plain.one_less_cosine[i], 0.0);
            EXPECT_EQ(plain.aspect_ratio[i], std::numeric_limits<double>::infinity());
            continue;
        }
        double perimeter = 0.0;
        double product = 1.0;
        double largest_cosine = -1.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double side = norm(at[(k + 1) % 3] - at[(k + 2) % 3]);
            const double cosine = std::cos(corner_at(at[k], at[(k + 1) % 3], at[(k + 2) % 3]));
            EXPECT_EQ(plain.sides[k][i], side);
            EXPECT_NEAR(plain.cosines[k][i], cosine, 1e-12);
            perimeter += side;
            product *= side;
            largest_cosine = std::max(largest_cosine, cosine);
        }
        EXPECT_NEAR(plain.one_less_cosine[i], 1.0 - largest_cosine, 1e-12);
        const double two_areas = norm(cross(at[1] - at[0], at[2] - at[0]));
        EXPECT_NEAR(plain.aspect_ratio[i], product / (2.0 * two_areas) * perimeter / (2.0 * two_areas), 1e-9);
    }
}

TEST(TriangleLanes, TellOnWhichSideOfABracketValuesAre) {
    Lanes values;
    std::iota(values.begin(), values.end(), 0.0);
    values[3] = std::numeric_limits<double>::infinity();
    for (const TriangleKernels& kernels : supported_triangle_kernels()) {
        const BracketMarks marks = kernels.bracket(values, {10.0, 12.0});
        EXPECT_EQ(marks.below, 0b11'1111'0111U) << kernels.instructions;
        EXPECT_EQ(marks.within, 0b1'1100'0000'0000U);
        const double infinity = std::numeric_limits<double>::infinity();
        EXPECT_EQ(kernels.bracket(values, {-infinity, infinity}).below, 0U);
        EXPECT_EQ(kernels.bracket(values, {-infinity, infinity}).within, ~std::uint64_t{0});
    }
}

// A vertex whose steps go from each neighbour to the next, the last one to the first.
struct Star {
    std::array<HalfStar, 2> halves;
    std::uint32_t size = 0;

    explicit Star(VertexId vertex) {
        for (HalfStar& half : halves) {
            half.from.fill(vertex);
            half.to.fill(vertex);
        }
    }
    void add(VertexId from, VertexId to) {
        if (size < 2 * HalfStar::kSteps) {
            halves[size / HalfStar::kSteps].from[size % HalfStar::kSteps] = from;
            halves[size / HalfStar::kSteps].to[size % HalfStar::kSteps] = to;
        }
        ++size;
    }
    void add_ring(std::vector<VertexId> ring, std::mt19937& random) {
        std::vector<std::pair<VertexId, VertexId>> steps;
        for (std::size_t i = 0; i < ring.size(); ++i) steps.emplace_back(ring[i], ring[(i + 1) % ring.size()]);
        std::shuffle(steps.begin(), steps.end(), random);
        for (const auto& [from, to] : steps) add(from, to);
    }
    bool is_ring(const TriangleKernels& kernels) const {
        return kernels.find_rings({halves.data(), 1}, &halves[1], {&size, 1}) != 0;
    }
};

TEST(TriangleLanes, TellRingsFromOtherStars) {
    std::mt19937 random(4);
    for (const TriangleKernels& kernels : supported_triangle_kernels()) {
        for (std::uint32_t size = 0; size < 20; ++size) {
            std::vector<VertexId> ring(size);
            std::iota(ring.begin(), ring.end(), 10U);
            Star whole(5);
            whole.add_ring(ring, random);
            EXPECT_EQ(whole.is_ring(kernels), size > 2 && size < 2 * HalfStar::kSteps) << kernels.instructions << size;
            if (size < 3 || size >= 2 * HalfStar::kSteps) continue;
            for (std::uint32_t k = 0; k < size; ++k)  // a step to or from where there is none, one twice, itself
                for (const VertexId other : {VertexId{99}, ring[0], ring[size - 1], VertexId{5}})
                    for (const auto end : {&HalfStar::from, &HalfStar::to}) {
                        Star damaged = whole;
                        VertexId& place = (damaged.halves[k / HalfStar::kSteps].*end)[k % HalfStar::kSteps];
                        if (std::exchange(place, other) != other) {
                            EXPECT_FALSE(damaged.is_ring(kernels)) << size << ' ' << k << ' ' << other;
                        }
                    }
            for (std::uint32_t first = 1; first < size; ++first) {  // two rings
                Star two(5);
                two.add_ring({ring.begin(), ring.begin() + first}, random);
                two.add_ring({ring.begin() + first, ring.end()}, random);
                EXPECT_FALSE(two.is_ring(kernels)) << size << ' ' << first;
            }
        }
    }
}

TEST(TriangleLanes, HaveTheSameBitsOnEveryInstructionSet) {
    const std::vector<TriangleKernels> all = supported_triangle_kernels();
    TriangleLanes plain = random_triangles();
    const std::uint64_t plain_creased = all.front().measure_with_parts(plain);
    EXPECT_NE(plain_creased, 0U);
    for (const TriangleKernels& kernels : all) {
        TriangleLanes lanes = random_triangles();
        EXPECT_EQ(kernels.measure_with_parts(lanes), plain_creased);
        EXPECT_EQ(lanes.two_areas, plain.two_areas) << kernels.instructions;
        EXPECT_EQ(lanes.six_volumes, plain.six_volumes);
        EXPECT_EQ(lanes.opposite, plain.opposite);
        EXPECT_EQ(lanes.adjacent, plain.adjacent);
        EXPECT_EQ(lanes.parts_two_areas, plain.parts_two_areas);
        EXPECT_EQ(lanes.parts_six_volumes, plain.parts_six_volumes);
        EXPECT_EQ(lanes.thirds, plain.thirds);
        EXPECT_EQ(lanes.squared_normal, plain.squared_normal);
        EXPECT_EQ(lanes.shortest, plain.shortest);
        EXPECT_EQ(lanes.longest, plain.longest);
        EXPECT_EQ(lanes.facing, plain.facing);
        EXPECT_EQ(lanes.least_facing, plain.least_facing);
        LaneSums sums;
        LaneSums plain_sums;
        kernels.add_up(lanes, sums);
        all.front().add_up(plain, plain_sums);
        EXPECT_EQ(sums.two_areas, plain_sums.two_areas);
        EXPECT_EQ(sums.six_volumes, plain_sums.six_volumes);
        EXPECT_EQ(sums.parts_two_areas, plain_sums.parts_two_areas);
        EXPECT_EQ(sums.parts_six_volumes, plain_sums.parts_six_volumes);
        EXPECT_EQ(sums.smallest.opposite, plain_sums.smallest.opposite);
        EXPECT_EQ(sums.smallest.adjacent, plain_sums.smallest.adjacent);
        const SuspectLimits limits{.squared_tangent = 0.05, .squared_edge = 0.1, .squared_cosine = 0.16};
        const SuspectMarks marks = kernels.mark(lanes, limits);
        const SuspectMarks plain_marks = all.front().mark(plain, limits);
        EXPECT_EQ(marks.may_be_bad, plain_marks.may_be_bad);
        EXPECT_EQ(marks.leaning, plain_marks.leaning);
        EXPECT_EQ(kernels.find_largest(lanes.longest), all.front().find_largest(plain.longest));
    }
}

TEST(TriangleLanes, FindTheLargestOfAllIndices) {
    std::vector<std::uint32_t> indices(37);
    std::iota(indices.begin(), indices.end(), 5U);
    for (const TriangleKernels& kernels : supported_triangle_kernels()) {
        EXPECT_EQ(kernels.find_largest_index({}), 0U);
        for (std::uint32_t& last : indices) {
            const std::uint32_t before = std::exchange(last, 0xFFFFFFFEU);
            EXPECT_EQ(kernels.find_largest_index(indices), 0xFFFFFFFEU);
            last = before;
        }
        EXPECT_EQ(kernels.find_largest_index(indices), 41U);
    }
}

TEST(TriangleLanes, SignedAreasOfAClosedSurfaceSumToNothing) {
    const Mesh mesh = projected_sphere({.centre = {1, 2, 3}, .radius = 2.0}, 0.5);
    const std::span<const Triangle> triangles = mesh.triangles;
    const std::vector<TriangleKernels> all = supported_triangle_kernels();
    for (const TriangleKernels& kernels : all) {
        EXPECT_EQ(kernels.sum_signed_areas(triangles), 0U);
        for (const std::size_t count : {1U, 7U, 8U, 61U}) {
            const std::uint64_t sum = kernels.sum_signed_areas(triangles.first(count));
            EXPECT_EQ(sum, all.front().sum_signed_areas(triangles.first(count)));
            EXPECT_EQ(sum + kernels.sum_signed_areas(triangles.subspan(count)), 0U);
            EXPECT_NE(sum, 0U);
        }
    }
}

TEST(TriangleLanes, FollowTheEnvironment) {
    const std::vector<TriangleKernels> all = supported_triangle_kernels();
    EXPECT_EQ(all.front().instructions, "plain");
    EXPECT_EQ(triangle_kernels().instructions, choose_kernels(all, wanted_instructions()).instructions);
}

}  // namespace
}  // namespace meniscus::testing
