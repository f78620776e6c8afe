// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "nearest/nearest_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/bits.h"
#include "nearest/nearest_feature.h"
#include "nearest/parallel_curvature.h"
#include "simd/instructions.h"
#include "support/arrangements.h"

namespace meniscus::testing {
namespace {

constexpr std::size_t kPoints = 61;  // no multiple of any vector

// A bit for each of some items.
struct Marks {
    std::vector<std::uint64_t> words;

    std::uint64_t* room_for(std::size_t items) {
        words.assign(words_for(items), ~std::uint64_t{0});
        return words.data();
    }
    bool operator[](std::size_t item) const { return (words[item / 64] >> item % 64 & 1U) != 0; }
    std::size_t count() const {
        return std::accumulate(words.begin(), words.end(), std::size_t{0},
                               [](std::size_t sum, std::uint64_t word) { return sum + count_bits(word); });
    }
    bool operator==(const Marks&) const = default;
};

// What all kernels say of the points in one box.
struct Answers {
    Marks reaching;
    Marks overlapping;
    std::vector<double> depths_in_middle;
    std::size_t deepest = 0;
    Marks contenders;
    Depths depths;
    LaneArray<std::int32_t> groups;
    BallClaims claims;
    NearestTags nearest;
    LaneArray<double> ball_curvatures;
    LaneArray<double> edge_distances;
    LaneArray<double> edge_curvatures;
    LaneArray<float> clamped;  // distances
    LaneArray<float> within;   // curvatures of those within the margin
    LanePoints<float> small;
    KnownSides sides;
    StepLanes from_balls;
    StepLanes from_arcs;
    StepLanes from_vertices;
    LaneArray<std::int64_t> nearest_of_arcs;  // atoms
    LaneArray<std::int64_t> nearest_of_vertices;
    std::array<std::uint64_t, 3> in_cells{};  // points in cells of balls, arcs and vertices
};

class NearestKernelsTest : public ::testing::Test {
protected:
    NearestKernelsTest() {
        local_.gather({{-2, -2, -2}, {9, 9, 9}});
        for (std::size_t b = 0; b < local_.balls().size(); ++b) {
            const Vec3 c = position_in(local_.balls(), b);
            small_.push_back({static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z),
                              static_cast<float>(local_.balls().column(3)[b])});
        }
        const std::vector<Vec3> points = random_points_around(atoms_, kPoints, 1.0);
        for (std::size_t i = 0; i < kPoints; ++i) {
            set_point(points_, i, points[i]);
            lengths_[i] = static_cast<float>(norm(points[i] - kMiddle));
            set_point(small_points_, i, points[i]);
        }
    }

    Vec3 point(std::size_t i) const { return get_point(points_, i); }

    Answers ask(const NearestKernels& kernels) const {
        const AccessibleSurface::Data& data = surface_.data();
        Answers answers;
        kernels.mark_reaching(local_.vertices(), 0.4, kBox, answers.reaching.room_for(local_.vertices().size()));
        kernels.mark_overlapping(local_.arcs(), kBox, answers.overlapping.room_for(local_.arcs().size()));
        answers.depths_in_middle.resize(local_.balls().padded_size());
        answers.deepest = kernels.find_depths_of(kMiddle, local_.balls(), answers.depths_in_middle.data());
        answers.depths_in_middle.resize(local_.balls().size());
        kernels.mark_contenders(local_.balls(), answers.deepest, kBox,
                                answers.contenders.room_for(local_.balls().size()));
        kernels.make_small(points_, kMiddle, kPoints, answers.small);
        answers.sides = kernels.screen(kScreen, answers.small, lengths_);
        kernels.find_depths(small_, small_points_, kPoints, answers.depths);
        kernels.group_points(answers.depths, limits(), kPoints, answers.groups);
        const std::uint32_t atom = local_.balls().index(0);
        const BallOwner ball{data.atoms.centres[atom], data.rho[atom], data.exposed[atom] != 0, data.caps_of(atom)};
        kernels.claim(ball, data.probe, points_, {0, kPoints}, answers.claims);
        kernels.find_ball_curvatures(answers.claims, data.probe, kPoints, answers.ball_curvatures);
        kernels.clamp(answers.claims.signed_distance, kMargin, kPoints, answers.clamped);
        kernels.clamp(answers.ball_curvatures, kMargin, kPoints, answers.within);
        kernels.clear_beyond(answers.claims.signed_distance, kMargin, kPoints, answers.within);
        std::fill_n(answers.nearest.squared_distance.at, kPoints, 1e300);
        std::vector<std::uint32_t> items(local_.vertices().size());
        std::iota(items.begin(), items.end(), 0U);
        kernels.offer_vertices(local_.vertices(), items, points_, kPoints, answers.nearest);
        items.clear();
        for (std::size_t a = 0; a < local_.arcs().size(); ++a) items.push_back(local_.arcs().index(a));
        kernels.offer_arcs(data.arcs, items, points_, kPoints, answers.nearest);
        kernels.find_edge_distances(answers.nearest, data.probe, kPoints, answers.edge_distances);
        kernels.find_edge_curvatures(answers.nearest, data.probe, kPoints, answers.edge_curvatures);
        step(kernels, answers);
        return answers;
    }

    // From every point in turn from the features next in their lists, whether they are nearest or not.
    void step(const NearestKernels& kernels, Answers& answers) const {
        const AccessibleSurface::Data& data = surface_.data();
        BallLanes balls;
        ArcLanes arcs;
        VertexLanes vertices;
        for (std::size_t k = 0; k < kPoints; ++k) {
            const std::size_t atom = k % data.atoms.size();
            set_point(balls.centre, k, data.atoms.centres[atom]);
            balls.radius[k] = data.atoms.radii[atom];
            arcs.set(k, data.arcs[k % data.arcs.size()], data.atoms);
            vertices.set(k, data.vertices[k % data.vertices.size()], data.atoms);
        }
        kernels.step_from_balls(points_, balls, kPoints, 0, answers.from_balls);
        kernels.step_from_arcs(data.probe, points_, arcs, kPoints, 0, answers.from_arcs, answers.nearest_of_arcs);
        kernels.step_from_vertices(data.probe, points_, vertices, kPoints, 0, answers.from_vertices,
                                   answers.nearest_of_vertices);
        const CellBorder border(data.rho_max);
        const std::uint64_t all = first_bits(kPoints);
        // Of all cells, so that each kind has some of the points.
        answers.in_cells = {};
        for (std::uint32_t i = 0; i < data.atoms.size(); ++i)
            if (data.exposed[i] != 0)
                answers.in_cells[0] |= kernels.find_in_ball_cell(
                    {data.atoms.centres[i], data.rho[i], true, data.caps_of(i)}, border, points_, all);
        for (const SasArc& arc : data.arcs)
            if (!arc.is_a_point()) answers.in_cells[1] |= kernels.find_in_arc_cell(arc, border, points_, all);
        for (const SasVertex& vertex : data.vertices)
            answers.in_cells[2] |= kernels.find_in_vertex_cell(vertex_hull(data, vertex), border, points_, all);
    }

    DepthLimits limits() const {
        return {.above = 0.5F, .below = 2.0F, .lead = 0.01F, .balls = static_cast<std::int32_t>(small_.size())};
    }

    static constexpr PointScreen kScreen{
        .foot = {1.0F, 2.0F, -1.0F}, .near_foot = 16.0F, .near_middle = 3.0F, .middle_inside = true};
    static constexpr Box kBox{{1, 1, 1}, {3, 3, 3}};
    static constexpr Vec3 kMiddle{2, 2, 2};
    static constexpr double kMargin = 1.0;
    Atoms atoms_ = random_cluster(8, 40, 8.0);
    AccessibleSurface surface_{atoms_, 1.4};
    LocalFeatures local_{surface_, 1.0};
    std::vector<SmallBall> small_;
    LanePoints<double> points_;
    LanePoints<float> small_points_;
    LaneArray<float> lengths_;  // from kMiddle
};

template <class T>
void expect_equal(const LaneArray<T>& a, const LaneArray<T>& b) {
    EXPECT_TRUE(std::equal(a.at, a.at + kPoints, b.at));
}

template <class T>
void expect_equal(const LanePoints<T>& a, const LanePoints<T>& b) {
    expect_equal(a.x, b.x);
    expect_equal(a.y, b.y);
    expect_equal(a.z, b.z);
}

// Curvatures mean nothing where the step is not settled.
void expect_equal(const StepLanes& a, const StepLanes& b) {
    expect_equal(a.points, b.points);
    expect_equal(a.normals, b.normals);
    for (std::size_t k = 0; k < kPoints; ++k) {
        EXPECT_EQ(a.settled[k], b.settled[k]);
        if (a.settled[k] == 0) continue;
        EXPECT_EQ(a.mean[k], b.mean[k]);
        EXPECT_EQ(a.gaussian[k], b.gaussian[k]);
    }
}

std::ptrdiff_t count_settled(const StepLanes& lanes) {
    return kPoints - std::count(lanes.settled.at, lanes.settled.at + kPoints, 0);
}

TEST_F(NearestKernelsTest, GiveTheSameBitsOnEveryInstructionSet) {
    const std::vector<NearestKernels> all = supported_nearest_kernels();
    const Answers plain = ask(all.front());
    for (const std::uint64_t in_cells : plain.in_cells) EXPECT_NE(in_cells, 0U);
    for (const StepLanes* lanes : {&plain.from_balls, &plain.from_arcs, &plain.from_vertices})
        EXPECT_GT(count_settled(*lanes), 0);
    for (const NearestKernels& kernels : all) {
        const Answers other = ask(kernels);
        EXPECT_EQ(other.reaching, plain.reaching);
        EXPECT_EQ(other.overlapping, plain.overlapping);
        EXPECT_EQ(other.depths_in_middle, plain.depths_in_middle);
        EXPECT_EQ(other.deepest, plain.deepest);
        EXPECT_EQ(other.contenders, plain.contenders);
        expect_equal(other.small, plain.small);
        EXPECT_EQ(other.sides.inside, plain.sides.inside);
        EXPECT_EQ(other.sides.settled, plain.sides.settled);
        expect_equal(other.depths.first, plain.depths.first);
        expect_equal(other.depths.second, plain.depths.second);
        expect_equal(other.depths.ball, plain.depths.ball);
        expect_equal(other.groups, plain.groups);
        expect_equal(other.claims.signed_distance, plain.claims.signed_distance);
        expect_equal(other.claims.owned, plain.claims.owned);
        expect_equal(other.claims.rho, plain.claims.rho);
        expect_equal(other.nearest.squared_distance, plain.nearest.squared_distance);
        expect_equal(other.nearest.tag, plain.nearest.tag);
        expect_equal(other.ball_curvatures, plain.ball_curvatures);
        expect_equal(other.edge_distances, plain.edge_distances);
        expect_equal(other.edge_curvatures, plain.edge_curvatures);
        expect_equal(other.clamped, plain.clamped);
        expect_equal(other.within, plain.within);
        expect_equal(other.from_balls, plain.from_balls);
        expect_equal(other.from_arcs, plain.from_arcs);
        expect_equal(other.from_vertices, plain.from_vertices);
        expect_equal(other.nearest_of_arcs, plain.nearest_of_arcs);
        expect_equal(other.nearest_of_vertices, plain.nearest_of_vertices);
        EXPECT_EQ(other.in_cells, plain.in_cells);
    }
}

TEST(NearestKernels, AreChosenByName) {
    const std::vector<NearestKernels> all = supported_nearest_kernels();
    for (const NearestKernels& kernels : all) EXPECT_EQ(&choose_kernels(all, kernels.instructions), &kernels);
    EXPECT_EQ(choose_kernels(all, "plain").instructions, "plain");
    EXPECT_EQ(&choose_kernels(all, ""), &all.back());
    EXPECT_EQ(nearest_kernels().instructions, choose_kernels(all, wanted_instructions()).instructions);
    EXPECT_EQ(&nearest_kernels(), &nearest_kernels());
}

TEST_F(NearestKernelsTest, MarkWhatIsNearABox) {
    const Answers answers = ask(nearest_kernels());
    for (std::size_t v = 0; v < local_.vertices().size(); ++v) {
        const double squared = kBox.squared_distance(position_in(local_.vertices(), v));
        EXPECT_EQ(answers.reaching[v], squared < 1.8 * 1.8);
    }
    for (std::size_t a = 0; a < local_.arcs().size(); ++a) {
        const Box cell = surface_.data().arc_cell_tree.box(local_.arcs().index(a)).grown(1e-6);
        EXPECT_EQ(answers.overlapping[a], cell.overlaps(kBox));
    }
}

TEST_F(NearestKernelsTest, KnowSidesByTheFootAndTheMiddle) {
    const Answers answers = ask(nearest_kernels());
    const auto [inside, settled] = answers.sides;
    std::array<std::size_t, 3> counts{};  // of what is inside, outside and open
    for (std::size_t i = 0; i < kPoints; ++i) {
        const Vec3 from = point(i) - kMiddle;
        EXPECT_FLOAT_EQ(answers.small.y[i], static_cast<float>(from.y));
        const bool expected = norm(from) <= kScreen.near_middle;
        const bool outside = norm(from - Vec3{1, 2, -1}) <= 4.0;
        EXPECT_EQ((inside >> i & 1U) != 0, expected) << i;
        EXPECT_EQ((settled >> i & 1U) != 0, expected || outside) << i;
        ++counts.at(expected ? 0 : outside ? 1 : 2);
    }
    for (const std::size_t count : counts) EXPECT_GT(count, 5U);
}

// The foot of a point in the centre of a ball, or on the axis of an arc, is no number.
TEST_F(NearestKernelsTest, KnowSidesByTheMiddleAloneWhereTheFootIsNoNumber) {
    PointScreen no_foot = kScreen;
    no_foot.foot[0] = std::numeric_limits<float>::quiet_NaN();
    const auto [inside, settled] = nearest_kernels().screen(no_foot, small_points_, lengths_);
    for (std::size_t i = 0; i < kPoints; ++i) {
        EXPECT_EQ((settled >> i & 1U) != 0, lengths_[i] <= kScreen.near_middle);
        EXPECT_EQ((inside >> i & 1U) != 0, lengths_[i] <= kScreen.near_middle);
    }
}

// Nor does it tell anything where no distance is near enough; what is near the middle is on its side.
TEST_F(NearestKernelsTest, KnowNothingByAFootThatIsNeverNear) {
    const PointScreen never{.near_foot = -1.0F, .near_middle = 2.0F};
    const auto [inside, settled] = nearest_kernels().screen(never, small_points_, lengths_);
    EXPECT_EQ(inside, 0U);
    for (std::size_t i = 0; i < kPoints; ++i) EXPECT_EQ((settled >> i & 1U) != 0, lengths_[i] <= 2.0F);
}

TEST_F(NearestKernelsTest, FindDepthsInAllBalls) {
    const Answers answers = ask(nearest_kernels());
    for (std::size_t i = 0; i < kPoints; ++i) {
        std::vector<double> depths;
        for (std::size_t b = 0; b < local_.balls().size(); ++b)
            depths.push_back(local_.balls().column(3)[b] - norm(point(i) - position_in(local_.balls(), b)));
        const auto deepest = std::max_element(depths.begin(), depths.end()) - depths.begin();
        EXPECT_EQ(answers.depths.ball[i], deepest);
        std::sort(depths.rbegin(), depths.rend());
        EXPECT_NEAR(answers.depths.first[i], depths[0], 1e-5);
        EXPECT_NEAR(answers.depths.second[i], depths[1], 1e-5);
    }
    for (std::size_t b = 0; b < local_.balls().size(); ++b)
        EXPECT_EQ(answers.depths_in_middle[b],
                  local_.balls().column(3)[b] - norm(kMiddle - position_in(local_.balls(), b)));
}

// Nowhere in the box is a ball the deepest one that is not marked, and most balls are not.
TEST_F(NearestKernelsTest, MarkWhatMayBeTheDeepestBall) {
    const Answers answers = ask(nearest_kernels());
    EXPECT_EQ(answers.deepest, static_cast<std::size_t>(std::ranges::max_element(answers.depths_in_middle) -
                                                        answers.depths_in_middle.begin()));
    EXPECT_LT(answers.contenders.count(), local_.balls().size() / 2);
    constexpr int kSteps = 20;
    for (int n = 0; n < kSteps * kSteps * kSteps; ++n) {
        const int y = n / kSteps % kSteps;
        const int z = n / kSteps / kSteps;
        const Vec3 x = kBox.low + (2.0 / (kSteps - 1)) * Vec3{1.0 * (n % kSteps), 1.0 * y, 1.0 * z};
        std::size_t deepest = 0;
        double depth = -1e300;
        for (std::size_t b = 0; b < local_.balls().size(); ++b) {
            const double here = local_.balls().column(3)[b] - norm(x - position_in(local_.balls(), b));
            if (here > depth) deepest = b;
            depth = std::max(depth, here);
        }
        ASSERT_TRUE(answers.contenders[deepest]);
    }
}

TEST_F(NearestKernelsTest, GroupPointsByWhatTheirDepthsTell) {
    const Answers answers = ask(nearest_kernels());
    const DepthLimits limit = limits();
    for (std::size_t i = 0; i < kPoints; ++i) {
        const float first = answers.depths.first[i];
        std::int32_t expected = answers.depths.ball[i];
        if (!(first - answers.depths.second[i] > limit.lead)) expected = limit.balls + kDoubtfulGroup;
        if (first < limit.above) expected = limit.balls + kAboveGroup;
        if (first > limit.below) expected = limit.balls + kBelowGroup;
        EXPECT_EQ(answers.groups[i], expected);
    }
}

TEST_F(NearestKernelsTest, ClaimWhatABallOwns) {
    const AccessibleSurface::Data& data = surface_.data();
    const std::uint32_t atom = local_.balls().index(0);
    const Answers answers = ask(nearest_kernels());
    for (std::size_t i = 0; i < kPoints; ++i) {
        const Vec3 q = point(i) - data.atoms.centres[atom];
        const NearestBall ball{atom, data.rho[atom] - norm(q), norm(q)};
        const double s = data.probe - ball.depth;
        EXPECT_EQ(answers.claims.signed_distance[i], s);
        EXPECT_EQ(answers.claims.rho[i], data.rho[atom]);
        EXPECT_EQ(answers.claims.owned[i] != 0, owned_by_ball(data, ball, point(i)));
        EXPECT_NEAR(answers.ball_curvatures[i], contact_curvature(norm(q)), 1e-12);
        EXPECT_EQ(answers.clamped[i], static_cast<float>(std::clamp(s, -kMargin, kMargin)));
        const bool within = std::abs(s) < kMargin;
        EXPECT_EQ(answers.within[i],
                  within ? static_cast<float>(std::clamp(answers.ball_curvatures[i], -kMargin, kMargin)) : 0.0F);
    }
}

TEST_F(NearestKernelsTest, ClampWhatIsNoNumberToTheLowerLimit) {
    LaneArray<double> values;
    values[0] = std::numeric_limits<double>::quiet_NaN();
    values[1] = std::numeric_limits<double>::infinity();
    values[2] = 0.25;
    LaneArray<float> clamped;
    nearest_kernels().clamp(values, 2.0, 3, clamped);
    EXPECT_EQ(clamped[0], -2.0F);
    EXPECT_EQ(clamped[1], 2.0F);
    EXPECT_EQ(clamped[2], 0.25F);
}

TEST_F(NearestKernelsTest, FindTheNearestArcOrVertex) {
    const AccessibleSurface::Data& data = surface_.data();
    const Answers answers = ask(nearest_kernels());
    for (std::size_t i = 0; i < kPoints; ++i) {
        double best = 1e300;
        for (std::size_t v = 0; v < local_.vertices().size(); ++v)
            best = std::min(best, squared_norm(point(i) - position_in(local_.vertices(), v)));
        for (std::size_t a = 0; a < local_.arcs().size(); ++a) {
            const ArcFoot foot = foot_on_arc(data.arcs[local_.arcs().index(a)], point(i));
            if (foot.within) best = std::min(best, foot.squared_distance);
        }
        EXPECT_EQ(answers.nearest.squared_distance[i], best);
        const std::int64_t tag = answers.nearest.tag[i];
        const double own = is_arc(tag) ? foot_on_arc(data.arcs[arc_of(tag)], point(i)).squared_distance
                                       : squared_norm(point(i) - data.vertices[static_cast<std::size_t>(tag)].position);
        EXPECT_EQ(own, best);
        const double distance = std::sqrt(best);
        if (is_arc(tag)) {
            const SasArc& arc = data.arcs[arc_of(tag)];
            const double from_axis = foot_on_arc(arc, point(i)).from_axis;
            EXPECT_EQ(answers.nearest.from_axis[i], from_axis);
            EXPECT_EQ(answers.nearest.radius[i], arc.radius);
            EXPECT_NEAR(answers.edge_curvatures[i], toroidal_curvature(arc.radius, from_axis, distance), 1e-9);
        } else {
            EXPECT_NEAR(answers.edge_curvatures[i], reentrant_curvature(distance), 1e-9);
        }
    }
}

TEST(FeatureList, KeepsTheMarkedItemsInOrder) {
    FeatureList<2> all;
    for (std::uint32_t i = 0; i < 11; ++i) all.add({1.0 * i, 10.0 * i}, 100 + i);
    FeatureList<2> some;
    const std::uint64_t marks = 0b10000001100;
    some.select(all, &marks);
    ASSERT_EQ(some.size(), 3U);
    EXPECT_EQ(some.padded_size(), 8U);
    EXPECT_EQ(some.index(2), 110U);
    EXPECT_EQ(some.column(0)[1], 3.0);
    EXPECT_EQ(some.column(1)[2], 100.0);
    some.clear();
    EXPECT_TRUE(some.empty());
}

}  // namespace
}  // namespace meniscus::testing
