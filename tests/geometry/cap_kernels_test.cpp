// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/cap_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>

#include "core/bits.h"
#include "core/perpendicular.h"
#include "geometry/contour.h"
#include "geometry/random_caps.h"
#include "support/arrangements.h"

namespace meniscus::testing {
namespace {

constexpr std::size_t kItems = 61;  // no multiple of any vector

double sine_of(const Cap& cap) { return std::sqrt(1.0 - cap.t * cap.t); }

// An arc of a rim, whose points are counted clockwise from `perpendicular`.
struct ArcOnRim {
    Cap cap;
    double begin;  // radian
    double sweep;

    Vec3 at(double part) const {
        const double angle = begin + part * sweep;
        const Vec3 e1 = perpendicular(cap.axis);
        return cap.t * cap.axis + sine_of(cap) * (std::cos(angle) * e1 + std::sin(angle) * cross(e1, cap.axis));
    }
    bool whole() const { return sweep >= 2.0 * std::numbers::pi; }
};

std::vector<ArcOnRim> random_arcs(std::uint64_t seed, const std::vector<Cap>& caps) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> angle(0.01, 2.0 * std::numbers::pi - 0.01);
    std::vector<ArcOnRim> arcs;
    arcs.reserve(caps.size());
    for (const Cap& cap : caps) arcs.push_back({cap, angle(random), angle(random)});
    for (std::size_t a = 0; a < arcs.size(); a += 5) arcs[a].sweep = 2.0 * std::numbers::pi;
    return arcs;
}

std::vector<EightArcs> side_by_side(const std::vector<ArcOnRim>& arcs) {
    std::vector<EightArcs> lanes((arcs.size() + EightArcs::kCount - 1) / EightArcs::kCount);
    for (std::size_t a = 0; a < arcs.size(); ++a) {
        const auto set = [&](std::size_t column, double number) {
            lanes[a / EightArcs::kCount].numbers[EightArcs::kCount * column + a % EightArcs::kCount] = number;
        };
        const auto set3 = [&](std::size_t column, const Vec3& v) {
            set(column, v.x);
            set(column + 1, v.y);
            set(column + 2, v.z);
        };
        set3(EightArcs::kAxis, arcs[a].cap.axis);
        set(EightArcs::kT, arcs[a].cap.t);
        set3(EightArcs::kStart, arcs[a].at(0.0));
        set3(EightArcs::kEnd, arcs[a].whole() ? arcs[a].at(0.0) : arcs[a].at(1.0));
    }
    return lanes;
}

double depth_in(const auto& cap, const Vec3& n) { return dot(cap.axis, n) - cap.t; }

// How deep an arc comes into a cap, at most and at least.
std::pair<double, double> depths_of(const ArcOnRim& arc, const auto& cap) {
    constexpr int kSteps = 2000;
    double least = 2.0;
    double most = -2.0;
    for (int i = 0; i <= kSteps; ++i) {
        const double depth = depth_in(cap, arc.at(static_cast<double>(i) / kSteps));
        least = std::min(least, depth);
        most = std::max(most, depth);
    }
    return {least, most};
}

// What a kernel set answers; only the items asked for.
struct Answers {
    std::vector<std::uint64_t> meeting;
    bool all_meet = false;
    std::vector<double> caps;  // column after column
    std::vector<std::size_t> deepest;
    std::vector<std::uint64_t> changing;
    std::vector<unsigned> meetings;
    std::vector<double> crossings;
    bool operator==(const Answers&) const = default;
};

class CapKernelsTest : public ::testing::Test {
protected:
    CapKernelsTest() : list_(kItems) {
        small_balls_.resize(kItems);
        std::fill(columns_[3] + kItems, columns_[3] + columns_.padded_size(), 4.0);
        for (std::size_t i = 0; i < kItems; ++i) {
            const Vec3 c = atoms_.centres[i];
            for (const auto& [column, value] : {std::pair{0, c.x}, {1, c.y}, {2, c.z}, {3, atoms_.radii[i]}})
                small_balls_[static_cast<std::size_t>(column)][i] = static_cast<float>(value);
        }
        std::iota(list_.begin(), list_.end(), 0U);
        std::reverse(list_.begin(), list_.end());
        list_.resize(columns_.padded_size(), list_.back());
    }

    Answers ask(const CapKernels& kernels) const {
        Answers answers;
        answers.meeting.resize(words_for(kItems));
        kernels.mark_meeting(small_balls_, kOne, kSlack, answers.meeting.data());
        CapColumns caps;
        caps.resize(kItems);
        answers.all_meet = kernels.find_caps(atoms_.centres.data(), atoms_.radii.data(), std::span(list_).first(kItems),
                                             kCentre, kRadius, 0, caps);
        for (std::size_t column = 0; column < 4; ++column)
            answers.caps.insert(answers.caps.end(), caps[column], caps[column] + kItems);
        for (const Cap& cap : buried_)
            answers.deepest.push_back(kernels.find_deepest(columns_, columns_[3], cap.axis, 0.0));
        answers.changing.resize(words_for(kItems));
        kernels.mark_changing(columns_, side_by_side({arcs_.begin(), arcs_.begin() + 3}), 3, planes_of(buried_),
                              answers.changing.data());
        std::vector<EightMeetings> meetings(kItems);
        kernels.meet_arcs(side_by_side(arcs_), kItems, kOther, meetings.data());
        for (std::size_t a = 0; a < kItems; ++a) {
            const EightMeetings& eight = meetings[a / EightArcs::kCount];
            const std::size_t lane = a % EightArcs::kCount;
            answers.meetings.push_back((eight.start_inside >> lane & 1U) | (eight.end_inside >> lane & 1U) << 1U |
                                       (eight.twice >> lane & 1U) << 2U);
            for (std::size_t column = 0; column < 3; ++column)
                answers.crossings.push_back(eight.crossing[EightArcs::kCount * column + lane]);
        }
        return answers;
    }

    static std::vector<CapPlane> planes_of(const std::vector<Cap>& caps) {
        std::vector<CapPlane> planes;
        planes.reserve(caps.size());
        for (const Cap& cap : caps) planes.push_back({cap.axis, cap.t});
        return planes;
    }

    static constexpr std::size_t kOne = 17;
    static constexpr float kSlack = 1e-4F;
    static constexpr Vec3 kCentre{1.0, -0.5, 2.0};
    static constexpr double kRadius = 3.1;
    static constexpr CapPlane kOther{{0.6, 0.0, 0.8}, 0.35};

    Atoms atoms_ = random_cluster(1, kItems, 12.0);
    std::vector<Cap> caps_ = random_caps(2, kItems, 0.3, 0.95);
    std::vector<Cap> buried_ = random_caps(3, 5, 0.3, 0.95);
    std::vector<ArcOnRim> arcs_ = random_arcs(5, caps_);
    SmallBallColumns small_balls_;
    CapColumns columns_ = columns_of(caps_);
    std::vector<std::uint32_t> list_;
};

TEST_F(CapKernelsTest, EveryInstructionSetGivesTheSameBits) {
    const std::vector<CapKernels> kernels = supported_cap_kernels();
    const Answers plain = ask(kernels.front());
    for (const CapKernels& other : kernels) EXPECT_EQ(ask(other), plain);
}

TEST_F(CapKernelsTest, BallsThatMeetOneOrAllButDoAreMarked) {
    std::size_t marked = 0;
    for (std::size_t i = 0; i < kItems; ++i) {
        const double missed_by =
            norm(atoms_.centres[i] - atoms_.centres[kOne]) - (atoms_.radii[i] + atoms_.radii[kOne]);
        // The second time as close to the limit as single precision tells.
        for (const double limit : {0.0, missed_by}) {
            const auto slack = static_cast<float>(std::max(limit, 0.0));
            std::vector<std::uint64_t> marks(words_for(kItems));
            cap_kernels().mark_meeting(small_balls_, kOne, slack + kSlack, marks.data());
            const bool is_marked = (marks[i / 64] >> i % 64 & 1U) != 0;
            EXPECT_TRUE(is_marked || missed_by > slack) << i;
            EXPECT_TRUE(!is_marked || missed_by < slack + 2.0 * kSlack) << i;
            marked += is_marked ? 1 : 0;
        }
    }
    EXPECT_GT(marked, kItems);
    EXPECT_LT(marked, 2 * kItems);
}

TEST_F(CapKernelsTest, RimsOfCapsLieOnBothSpheres) {
    const Answers answers = ask(cap_kernels());
    for (std::size_t k = 0; k < kItems; ++k) {
        const std::size_t i = list_[k];
        const auto column = [&](std::size_t c) { return answers.caps[c * kItems + k]; };
        const Vec3 axis{column(0), column(1), column(2)};
        const double t = column(3);
        EXPECT_NEAR(dot(axis, normalised(atoms_.centres[i] - kCentre)), 1.0, 1e-14);
        if (std::abs(t) >= 1.0) continue;  // there is none
        const Vec3 on_rim = kCentre + kRadius * (t * axis + std::sqrt(1.0 - t * t) * perpendicular(axis));
        EXPECT_NEAR(norm(on_rim - atoms_.centres[i]), atoms_.radii[i], 1e-12);
    }
}

TEST_F(CapKernelsTest, CapsWhosePlanesMissTheSphereAreToldOf) {
    const auto all_meet = [&](const std::vector<std::uint32_t>& list) {
        std::vector<std::uint32_t> repeated = list;
        repeated.resize(CapColumns::kStep, list.back());
        CapColumns caps;
        caps.resize(CapColumns::kStep);
        return cap_kernels().find_caps(atoms_.centres.data(), atoms_.radii.data(),
                                       std::span(repeated).first(list.size()), kCentre, kRadius, 0, caps);
    };
    std::vector<std::uint32_t> meeting;
    for (std::uint32_t i = 0; i < kItems && meeting.size() < 2; ++i)
        if (std::abs(norm(atoms_.centres[i] - kCentre) - kRadius) < 0.99 * atoms_.radii[i]) meeting.push_back(i);
    ASSERT_EQ(meeting.size(), 2U);
    EXPECT_TRUE(all_meet(meeting));
    for (const double far_away : {0.0, 100.0}) {
        atoms_.centres[meeting[1]] = kCentre + Vec3{far_away, 1e-3, 0.0};
        EXPECT_FALSE(all_meet(meeting));
    }
}

TEST_F(CapKernelsTest, DeepestCapHoldsADirectionMostOrNoneDoes) {
    for (std::size_t i = 0; i < kItems; ++i) columns_[3][i] = caps_[i].t = 0.7 + 0.3 * caps_[i].t;  // gaps between them
    std::size_t outside = 0;
    for (const Cap& at : random_caps(4, 200, 0.3, 0.95)) {
        std::size_t expected = kItems;
        double depth = 0.0;
        for (std::size_t i = 0; i < kItems; ++i)
            if (depth_in(caps_[i], at.axis) > depth) depth = depth_in(caps_[expected = i], at.axis);
        EXPECT_EQ(cap_kernels().find_deepest(columns_, columns_[3], at.axis, 0.0), expected);
        outside += expected == kItems ? 1 : 0;
    }
    EXPECT_GT(outside, 0U);
    EXPECT_LT(outside, 200U);
}

TEST_F(CapKernelsTest, OfCapsThatAreEquallyDeepTheFirstIsTaken) {
    for (const CapKernels& kernels : supported_cap_kernels())
        for (const std::size_t twin : {1U, 7U, 8U, 40U}) {
            for (std::size_t column = 0; column < 4; ++column) columns_[column][twin] = columns_[column][0];
            EXPECT_EQ(kernels.find_deepest(columns_, columns_[3], caps_[0].axis, 0.0), 0U);
        }
}

TEST_F(CapKernelsTest, TheLargestCapIsTheDeepestForNoDirection) {
    const auto largest =
        std::min_element(caps_.begin(), caps_.end(), [](const Cap& a, const Cap& b) { return a.t < b.t; });
    EXPECT_EQ(cap_kernels().find_deepest(columns_, columns_[3], {}, -4.0),
              static_cast<std::size_t>(largest - caps_.begin()));
}

TEST_F(CapKernelsTest, WholeRimsMeetACapTwiceWhereTheyCrossIt) {
    for (ArcOnRim& arc : arcs_) arc.sweep = 2.0 * std::numbers::pi;
    const Answers answers = ask(cap_kernels());
    int crossing = 0;
    for (std::size_t a = 0; a < kItems; ++a) {
        const RimCrossing expected = cross_rims(caps_[a], {kOther.axis, kOther.t});
        const bool starts_inside = (answers.meetings[a] & 1U) != 0;
        EXPECT_EQ(starts_inside, depth_in(kOther, arcs_[a].at(0.0)) > 0.0);
        EXPECT_EQ((answers.meetings[a] & 2U) != 0, starts_inside);
        EXPECT_EQ((answers.meetings[a] & 4U) != 0, expected.crosses);
        if (!expected.crosses) continue;
        ++crossing;
        const Vec3 point{answers.crossings[3 * a], answers.crossings[3 * a + 1], answers.crossings[3 * a + 2]};
        EXPECT_EQ(point, starts_inside ? expected.back : expected.onto);
    }
    EXPECT_GT(crossing, 10);
}

TEST_F(CapKernelsTest, ArcsMeetACapWhereTheirPointsSay) {
    const Answers answers = ask(cap_kernels());
    std::array<int, 8> seen{};
    for (std::size_t a = 0; a < kItems; ++a) {
        if (arcs_[a].whole()) continue;
        const auto [least, most] = depths_of(arcs_[a], kOther);
        const bool starts_inside = depth_in(kOther, arcs_[a].at(0.0)) > 0.0;
        const bool ends_inside = depth_in(kOther, arcs_[a].at(1.0)) > 0.0;
        const bool twice = starts_inside == ends_inside && (starts_inside ? least < 0.0 : most > 0.0);
        const unsigned expected = (starts_inside ? 1U : 0U) | (ends_inside ? 2U : 0U) | (twice ? 4U : 0U);
        EXPECT_EQ(answers.meetings[a], expected) << a;
        ++seen[expected];
        if (starts_inside == ends_inside) continue;
        const RimCrossing crossing = cross_rims(caps_[a], {kOther.axis, kOther.t});
        const Vec3 point{answers.crossings[3 * a], answers.crossings[3 * a + 1], answers.crossings[3 * a + 2]};
        EXPECT_EQ(point, starts_inside ? crossing.back : crossing.onto);
    }
    for (const unsigned kind : {0U, 1U, 2U, 3U, 4U, 7U}) EXPECT_GT(seen[kind], 0) << kind;
}

TEST_F(CapKernelsTest, CapsThatMayChangeAContourAreMarked) {
    constexpr double kHair = 1e-5;  // more than single precision leaves open, and the steps along an arc
    int idle = 0;
    int buried_and_entered = 0;
    const Answers answers = ask(cap_kernels());
    for (std::size_t i = 0; i < kItems; ++i) {
        double entered = -2.0;
        double held = -2.0;  // at starts alone, which on a contour are ends of arcs before: these need not be here
        for (std::size_t a = 0; a < 3; ++a) {
            const bool at_start =
                depth_in(caps_[i], arcs_[a].at(0.0)) > 0.0 && depth_in(caps_[i], arcs_[a].at(1.0)) < 0.0;
            double& deepest = at_start ? held : entered;
            deepest = std::max(deepest, depths_of(arcs_[a], caps_[i]).second);
        }
        double buried = -2.0;
        for (const Cap& cap : buried_) buried = std::max(buried, depth_in(cap, caps_[i].axis));
        const bool marked = (answers.changing[i / 64] >> i % 64 & 1U) != 0;
        if (entered > kHair || buried < -kHair) {
            EXPECT_TRUE(marked) << i;
        } else if (std::max(entered, held) < -kHair && buried > kHair) {
            EXPECT_FALSE(marked) << i;
        }
        idle += marked ? 0 : 1;
        buried_and_entered += marked && buried > kHair ? 1 : 0;
    }
    EXPECT_GT(idle, 0);
    EXPECT_GT(buried_and_entered, 0);
}

}  // namespace
}  // namespace meniscus::testing
