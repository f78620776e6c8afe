// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "space/box_tree.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace meniscus::testing {
namespace {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

std::vector<Box> random_boxes(std::uint64_t seed, std::size_t count, double size) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> at(0.0, 20.0);
    std::uniform_real_distribution<double> edge(0.0, size);
    std::vector<Box> boxes(count);
    for (Box& box : boxes) {
        const Vec3 low{at(random), at(random), at(random)};
        box.include(low);
        box.include(low + Vec3{edge(random), edge(random), edge(random)});
    }
    return boxes;
}

// What boxes in single precision may be larger by, Å.
constexpr double kRounding = 1e-5;

std::vector<std::uint32_t> overlapping(const BoxTree& tree, const Box& box) {
    std::vector<std::uint32_t> found;
    tree.for_each_overlapping(box, [&](std::uint32_t i) { found.push_back(i); });
    return found;
}

double nearest_squared_distance(const BoxTree& tree, const std::vector<Box>& boxes, const Vec3& p) {
    double best = kUnbounded;
    tree.search_nearest(
        p, [&] { return best; },
        [&](std::uint32_t i) {
            EXPECT_LT(boxes[i].grown(kRounding).squared_distance(p), best);
            best = std::min(best, boxes[i].squared_distance(p));
        });
    return best;
}

TEST(SmallBox, HoldsTheBoxAndHardlyMore) {
    for (const Box& box : random_boxes(7, 200, 3.0)) {
        const SmallBox small(box);
        EXPECT_TRUE(small.box().contains(box));
        EXPECT_TRUE(box.grown(1e-5).contains(small.box()));
        const double x = box.high.x + 1e-4;
        EXPECT_TRUE(small.overlaps(SmallBox(Box{box.high, box.high})));
        EXPECT_FALSE(small.overlaps(SmallBox(Box{{x, box.low.y, box.low.z}, {x, box.high.y, box.high.z}})));
    }
}

TEST(SmallBox, GrowsFromNothing) {
    SmallBox all;
    EXPECT_FALSE(all.overlaps(SmallBox({{-1e30, -1e30, -1e30}, {1e30, 1e30, 1e30}})));
    for (const Box& box : random_boxes(8, 20, 1.0)) {
        all.include(SmallBox(box));
        EXPECT_TRUE(all.box().contains(box));
    }
    const double far = std::numeric_limits<double>::max();
    EXPECT_TRUE(SmallBox({{-far, 0, 0}, {far, 1, 1}}).overlaps(SmallBox({{1e38, 0.5, 0.5}, {1e39, 0.6, 0.6}})));
}

TEST(EightBoxes, HaveAHullOfThoseThatWereSet) {
    EightBoxes eight;
    SmallBox all;
    const auto expect_same = [&] {
        EXPECT_EQ(eight.hull().low, all.low);
        EXPECT_EQ(eight.hull().high, all.high);
    };
    expect_same();
    const std::vector<Box> boxes = random_boxes(10, EightBoxes::kCount, 3.0);
    for (std::size_t i = 0; i < EightBoxes::kCount; ++i) {
        eight.set(i, SmallBox(boxes[i]));
        all.include(SmallBox(boxes[i]));
        expect_same();
    }
}

TEST(BoxTree, FindsWhatOverlapsInTheItemsOrder) {
    for (const std::size_t count : {1U, 7U, 8U, 9U, 64U, 65U, 700U}) {
        const std::vector<Box> boxes = random_boxes(count, count, 2.0);
        const BoxTree tree(boxes);
        for (const Box& query : random_boxes(99, 50, 5.0)) {
            const std::vector<std::uint32_t> found = overlapping(tree, query);
            EXPECT_TRUE(std::is_sorted(found.begin(), found.end()));
            for (std::uint32_t i = 0; i < count; ++i) {
                const bool is_found = std::binary_search(found.begin(), found.end(), i);
                EXPECT_TRUE(is_found || !boxes[i].overlaps(query));
                EXPECT_TRUE(!is_found || boxes[i].grown(kRounding).overlaps(query));
            }
        }
    }
}

// As boxes around probes are that are larger than single precision.
TEST(BoxTree, ABoxAroundEverythingOverlapsTheItemsAlone) {
    const std::vector<Box> boxes(3, Box{{0, 0, 0}, {1, 1, 1}});
    const BoxTree tree(boxes);
    const Box everything = Box{{0, 0, 0}, {1, 1, 1}}.grown(1e100);
    EXPECT_EQ(overlapping(tree, everything), (std::vector<std::uint32_t>{0, 1, 2}));
}

TEST(BoxTree, KeepsTheBoxesAndHardlyMore) {
    const std::vector<Box> boxes = random_boxes(3, 100, 2.0);
    const BoxTree tree(boxes);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        EXPECT_TRUE(tree.box(i).grown(1e-12).contains(boxes[i]));
        EXPECT_TRUE(boxes[i].grown(kRounding).contains(tree.box(i)));
    }
}

TEST(BoxTree, KeepsItsDigitsFarFromTheOrigin) {
    const Vec3 far{3e8, -1e9, 2e7};
    std::vector<Box> boxes = random_boxes(4, 300, 0.5);
    for (Box& box : boxes) box = {box.low + far, box.high + far};
    const BoxTree tree(boxes);
    std::size_t found = 0;
    for (const Box& box : boxes) found += overlapping(tree, box).size();
    EXPECT_LT(found, 3 * boxes.size());
}

TEST(BoxTree, FindsTheNearest) {
    for (const std::size_t count : {1U, 8U, 9U, 65U, 700U}) {
        const std::vector<Box> boxes = random_boxes(count, count, 0.5);
        const BoxTree tree(boxes);
        for (const Box& query : random_boxes(98, 50, 0.0)) {
            double expected = kUnbounded;
            for (const Box& box : boxes) expected = std::min(expected, box.squared_distance(query.low));
            EXPECT_EQ(nearest_squared_distance(tree, boxes, query.low), expected);
        }
    }
}

TEST(BoxTree, VisitsNothingBeyondTheBound) {
    const std::vector<Box> boxes = random_boxes(5, 200, 0.5);
    const BoxTree tree(boxes);
    std::size_t visits = 0;
    tree.search_nearest(
        {-100, 0, 0}, [] { return 1.0; }, [&](std::uint32_t) { ++visits; });
    EXPECT_EQ(visits, 0U);
}

TEST(BoxTree, AnEmptyTreeFindsNothing) {
    Box everything;
    everything.include(Vec3{-1e9, -1e9, -1e9});
    everything.include(Vec3{1e9, 1e9, 1e9});
    for (const BoxTree& tree : {BoxTree(), BoxTree(std::vector<Box>{})}) {
        EXPECT_TRUE(overlapping(tree, everything).empty());
        EXPECT_EQ(nearest_squared_distance(tree, {}, {0, 0, 0}), kUnbounded);
    }
}

TEST(Box, TheDefaultOneIsEmpty) {
    Box box;
    EXPECT_FALSE(box.overlaps(box));
    box.include(Box{});
    EXPECT_FALSE(box.overlaps(box));
    box.include(Vec3{1, 2, 3});
    EXPECT_TRUE(box.overlaps(box));
    EXPECT_EQ(box.low, (Vec3{1, 2, 3}));
    EXPECT_EQ(box.high, (Vec3{1, 2, 3}));
}

TEST(Box, TouchingBoxesOverlap) {
    const Box a{{0, 0, 0}, {1, 1, 1}};
    EXPECT_TRUE(a.overlaps({{1, 1, 1}, {2, 2, 2}}));
    EXPECT_FALSE(a.overlaps({{1.001, 0, 0}, {2, 2, 2}}));
    EXPECT_TRUE(a.grown(0.001).overlaps({{1.001, 0, 0}, {2, 2, 2}}));
}

TEST(Box, KnowsItsDistance) {
    const Box a{{0, 0, 0}, {1, 1, 1}};
    EXPECT_EQ(a.squared_distance({0.5, 0.2, 1.0}), 0.0);
    EXPECT_EQ(a.squared_distance({-2, 0.5, 0.5}), 4.0);
    EXPECT_EQ(a.squared_distance({3, -2, 0.5}), 8.0);
    EXPECT_EQ(a.squared_distance({3, -2, 2}), 9.0);
}

}  // namespace
}  // namespace meniscus::testing
