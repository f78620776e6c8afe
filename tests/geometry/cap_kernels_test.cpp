// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/cap_kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "core/bits.h"
#include "geometry/contour.h"
#include "support/arrangements.h"

namespace meniscus::testing {
namespace {

constexpr std::size_t kItems = 61;  // no multiple of any vector

std::vector<Cap> random_caps(std::uint64_t seed, std::uint32_t count) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> t(0.3, 0.95);
    std::vector<Cap> caps;
    for (std::uint32_t i = 0; i < count; ++i)
        caps.push_back({normalised({normal(random), normal(random), normal(random)}), t(random), i});
    return caps;
}

double sine_of(const Cap& cap) { return std::sqrt(1.0 - cap.t * cap.t); }

// What a kernel set answers; only the items asked for.
struct Answers {
    std::vector<std::uint64_t> meeting;
    std::vector<double> caps;  // column after column
    std::vector<std::size_t> deepest;
    std::vector<double> idle;
    std::vector<double> meetings;
    bool operator==(const Answers&) const = default;
};

class CapKernelsTest : public ::testing::Test {
protected:
    CapKernelsTest() : list_(kItems) {
        balls_.resize(kItems);
        columns_.resize(kItems);
        std::fill(columns_[3] + kItems, columns_[3] + columns_.padded_size(), 4.0);
        for (std::size_t i = 0; i < kItems; ++i) {
            const Vec3 c = atoms_.centres[i];
            for (const auto& [column, value] : {std::pair{0, c.x}, {1, c.y}, {2, c.z}, {3, atoms_.radii[i]}})
                balls_[static_cast<std::size_t>(column)][i] = value;
            const Cap& cap = caps_[i];
            columns_[0][i] = cap.axis.x;
            columns_[1][i] = cap.axis.y;
            columns_[2][i] = cap.axis.z;
            columns_[3][i] = cap.t;
            columns_[4][i] = sine_of(cap);
            const Vec3 e1 = perpendicular(cap.axis);
            rims_.push_back({cap.axis, cap.t, e1, cross(e1, cap.axis)});
        }
        std::iota(list_.begin(), list_.end(), 0U);
        std::reverse(list_.begin(), list_.end());
        for (const Cap& cap : buried_) extents_.push_back({cap.axis, cap.t, sine_of(cap)});
    }

    Answers ask(const CapKernels& kernels) const {
        Answers answers;
        NeighbourColumns caps;
        caps.resize(kItems);
        answers.meeting.resize(words_for(kItems));
        kernels.find_caps(balls_, kCentre, kRadius, caps, answers.meeting.data());
        for (std::size_t column = 0; column < 4; ++column)
            answers.caps.insert(answers.caps.end(), caps[column], caps[column] + kItems);
        for (const Cap& cap : buried_) answers.deepest.push_back(kernels.find_deepest(columns_, cap.axis));
        answers.idle.resize(kItems + 7);
        kernels.find_idle(columns_, extents_, buried_, answers.idle.data());
        answers.idle.resize(kItems);
        MeetingColumns meetings;
        meetings.resize(kItems);
        kernels.find_meetings(rims_, list_, kOther, meetings);
        for (std::size_t column = 0; column < 9; ++column)
            answers.meetings.insert(answers.meetings.end(), meetings[column], meetings[column] + kItems);
        return answers;
    }

    static constexpr Vec3 kCentre{1.0, -0.5, 2.0};
    static constexpr double kRadius = 3.1;
    static constexpr Cap kOther{{0.6, 0.0, 0.8}, 0.35, 0};

    Atoms atoms_ = random_cluster(1, kItems, 12.0);
    std::vector<Cap> caps_ = random_caps(2, kItems);
    std::vector<Cap> buried_ = random_caps(3, 5);
    BallColumns balls_;
    CapColumns columns_;
    std::vector<ArcExtent> extents_;
    std::vector<Rim> rims_;
    std::vector<std::uint32_t> list_;
};

TEST_F(CapKernelsTest, EveryInstructionSetGivesTheSameBits) {
    const std::vector<CapKernels> kernels = supported_cap_kernels();
    const Answers plain = ask(kernels.front());
    for (const CapKernels& other : kernels) EXPECT_EQ(ask(other), plain);
}

TEST_F(CapKernelsTest, BallsThatMeetASphereAreMarked) {
    const Answers answers = ask(cap_kernels());
    std::vector<std::uint32_t> marked(kItems);
    marked.resize(list_items(answers.meeting.data(), kItems, marked.data()));
    std::vector<std::uint32_t> meeting;
    for (std::uint32_t i = 0; i < kItems; ++i)
        if (norm(atoms_.centres[i] - kCentre) < kRadius + atoms_.radii[i]) meeting.push_back(i);
    EXPECT_EQ(marked, meeting);
}

TEST_F(CapKernelsTest, RimsOfCapsLieOnBothSpheres) {
    const Answers answers = ask(cap_kernels());
    for (std::size_t i = 0; i < kItems; ++i) {
        const auto column = [&](std::size_t c) { return answers.caps[c * kItems + i]; };
        const Vec3 axis{column(0), column(1), column(2)};
        const double t = column(3);
        EXPECT_NEAR(dot(axis, normalised(atoms_.centres[i] - kCentre)), 1.0, 1e-14);
        if (std::abs(t) >= 1.0) continue;  // there is none
        const Vec3 on_rim = kCentre + kRadius * (t * axis + std::sqrt(1.0 - t * t) * perpendicular(axis));
        EXPECT_NEAR(norm(on_rim - atoms_.centres[i]), atoms_.radii[i], 1e-12);
    }
}

TEST_F(CapKernelsTest, DeepestCapHoldsADirectionMostOrNoneDoes) {
    const auto depth_in = [](const Cap& cap, const Vec3& n) { return dot(cap.axis, n) - cap.t; };
    for (std::size_t i = 0; i < kItems; ++i) columns_[3][i] = caps_[i].t = 0.7 + 0.3 * caps_[i].t;  // gaps between them
    std::size_t outside = 0;
    for (const Cap& at : random_caps(4, 200)) {
        std::size_t expected = kItems;
        double depth = 0.0;
        for (std::size_t i = 0; i < kItems; ++i)
            if (depth_in(caps_[i], at.axis) > depth) depth = depth_in(caps_[expected = i], at.axis);
        EXPECT_EQ(cap_kernels().find_deepest(columns_, at.axis), expected);
        outside += expected == kItems ? 1 : 0;
    }
    EXPECT_GT(outside, 0U);
    EXPECT_LT(outside, 200U);
}

TEST_F(CapKernelsTest, OfCapsThatAreEquallyDeepTheFirstIsTaken) {
    for (const CapKernels& kernels : supported_cap_kernels())
        for (const std::size_t twin : {1U, 7U, 8U, 40U}) {
            for (std::size_t column = 0; column < 5; ++column) columns_[column][twin] = columns_[column][0];
            EXPECT_EQ(kernels.find_deepest(columns_, caps_[0].axis), 0U);
        }
}

TEST_F(CapKernelsTest, IdleCapsAreApartFromAllArcsAndBuried) {
    const Answers answers = ask(cap_kernels());
    for (std::size_t i = 0; i < kItems; ++i) {
        const Cap& cap = caps_[i];
        const bool apart = std::all_of(buried_.begin(), buried_.end(), [&](const Cap& rim) {
            return std::acos(dot(cap.axis, rim.axis)) > std::acos(cap.t) + std::acos(rim.t);
        });
        const bool buried = std::any_of(buried_.begin(), buried_.end(),
                                        [&](const Cap& other) { return dot(cap.axis, other.axis) > other.t; });
        EXPECT_EQ(answers.idle[i] > 0.0, apart && buried);
    }
}

TEST_F(CapKernelsTest, ACapBehindItsOnlyArcIsIdle) {
    CapColumns cap;
    cap.resize(1);
    for (std::size_t column = 0; column < 5; ++column) cap[column][0] = 0.0;
    cap[2][0] = 1.0;
    cap[3][0] = 0.9;
    cap[4][0] = std::sqrt(1.0 - 0.81);
    const std::vector<Cap> buried = {{{0, 0, 1}, 0.0, 0}};
    const std::vector<ArcExtent> arcs = {{{1, 0, 0}, 0.9, std::sqrt(1.0 - 0.81)}};
    std::vector<double> idle(8);
    cap_kernels().find_idle(cap, arcs, buried, idle.data());
    EXPECT_GT(idle[0], 0.0);
    cap_kernels().find_idle(cap, arcs, {}, idle.data());
    EXPECT_LE(idle[0], 0.0);
}

TEST_F(CapKernelsTest, MeetingsAreThoseOfCrossRims) {
    MeetingColumns meetings;
    meetings.resize(kItems);
    cap_kernels().find_meetings(rims_, list_, kOther, meetings);
    const auto point = [&](std::size_t column, std::size_t i) {
        return Vec3{meetings[column][i], meetings[column + 1][i], meetings[column + 2][i]};
    };
    int crossing = 0;
    for (std::size_t i = 0; i < kItems; ++i) {
        const Cap& cap = caps_[list_[i]];
        const RimCrossing expected = cross_rims(cap, kOther);
        ASSERT_EQ(meetings[MeetingColumns::kDiscriminant][i] > 0.0, expected.crosses);
        if (!expected.crosses) continue;
        ++crossing;
        EXPECT_EQ(point(MeetingColumns::kOnto, i), expected.onto);
        EXPECT_EQ(point(MeetingColumns::kBack, i), expected.back);
        const Rim& rim = rims_[list_[i]];
        for (const auto& [angle, n] : {std::pair{meetings[MeetingColumns::kAngleOnto][i], expected.onto},
                                       {meetings[MeetingColumns::kAngleBack][i], expected.back}}) {
            const double turn = std::atan2(dot(n, rim.e2), dot(n, rim.e1)) / std::acos(0.0);
            EXPECT_EQ(std::floor(angle), std::floor(turn < 0.0 ? turn + 4.0 : turn));  // the same quarter
        }
    }
    EXPECT_GT(crossing, 10);
}

}  // namespace
}  // namespace meniscus::testing
