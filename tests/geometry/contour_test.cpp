// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/contour.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <set>
#include <span>

#include "core/perpendicular.h"
#include "geometry/random_caps.h"

namespace meniscus::testing {
namespace {

const Vec3 kX{1, 0, 0};
const Vec3 kY{0, 1, 0};
const Vec3 kZ{0, 0, 1};

bool inside(const Cap& cap, const Vec3& n, double slack = 0.0) { return dot(cap.axis, n) > cap.t + slack; }

// The point of an arc at a pseudo-angle from its start: inverse of what ContourArc's sweep is measured with. caps:
// those that the contour kept.
Vec3 on_arc(const std::vector<Cap>& caps, const ContourArc& arc, double pseudo) {
    const Cap& cap = caps[arc.cap];
    const Vec3 start =
        arc.from == kWholeCircle ? perpendicular(cap.axis) : rim_crossing(caps[arc.from], cap) - cap.t * cap.axis;
    const double y = pseudo < 1.0 ? pseudo : (pseudo < 3.0 ? 2.0 - pseudo : pseudo - 4.0);
    const double x = (pseudo < 1.0 || pseudo > 3.0 ? 1.0 : -1.0) * (1.0 - std::abs(y));
    const Vec3 radial = normalised(x * start + y * cross(start, cap.axis));
    return cap.t * cap.axis + std::sqrt(1.0 - cap.t * cap.t) * radial;
}

void expect_on_rim(const Cap& cap, const Vec3& n) { EXPECT_NEAR(dot(cap.axis, n), cap.t, 1e-12); }

// Ends lie on both rims; ends and inner points lie in no other cap.
void expect_exposed_arcs(const ContourBuilder& builder, const std::vector<Cap>& caps) {
    const std::vector<Cap> kept = kept_of(builder, caps);
    for (const ContourArc& arc : builder.arcs()) {
        ASSERT_EQ(arc.from == kWholeCircle, arc.to == kWholeCircle);
        if (arc.from != kWholeCircle) {
            const Vec3 start = rim_crossing(kept[arc.from], kept[arc.cap]);
            const Vec3 end = rim_crossing(kept[arc.cap], kept[arc.to]);
            expect_on_rim(kept[arc.cap], start);
            expect_on_rim(kept[arc.cap], end);
            expect_on_rim(kept[arc.from], start);
            expect_on_rim(kept[arc.to], end);
            EXPECT_NEAR(norm(on_arc(kept, arc, 0.0) - start), 0.0, 1e-12);
            EXPECT_NEAR(norm(on_arc(kept, arc, arc.sweep) - end), 0.0, 1e-12);
        }
        for (const double part : {0.0, 0.2, 0.5, 0.8, 1.0})
            for (const Cap& cap : caps) EXPECT_FALSE(inside(cap, on_arc(kept, arc, part * arc.sweep), 1e-12));
    }
}

// Arcs form closed loops: where one ends, another of that rim begins.
void expect_closed_loops(const ContourBuilder& builder) {
    std::set<std::pair<std::uint32_t, std::uint32_t>> begins;
    std::set<std::pair<std::uint32_t, std::uint32_t>> ends;
    for (const ContourArc& arc : builder.arcs()) {
        if (arc.from == kWholeCircle) continue;
        EXPECT_TRUE(begins.emplace(arc.from, arc.cap).second);
        EXPECT_TRUE(ends.emplace(arc.cap, arc.to).second);
    }
    EXPECT_EQ(begins, ends);
}

void expect_kept_caps_suffice(const ContourBuilder& builder, const std::vector<Cap>& caps) {
    std::mt19937_64 random(3);
    bool found_exposed = false;
    for (int i = 0; i < 3000; ++i) {
        const Vec3 n = random_direction(random);
        const bool buried = std::any_of(caps.begin(), caps.end(), [&](const Cap& cap) { return inside(cap, n); });
        const bool by_kept = std::any_of(builder.kept().begin(), builder.kept().end(),
                                         [&](std::uint32_t k) { return inside(caps[k], n); });
        EXPECT_EQ(buried, by_kept);
        found_exposed = found_exposed || !buried;
    }
    if (found_exposed) {
        EXPECT_TRUE(builder.exposed());
    }
}

void expect_caps_are_those_numbered(const ContourBuilder& builder, const std::vector<Cap>& caps) {
    const std::vector<Cap> kept = kept_of(builder, caps);
    ASSERT_EQ(builder.kept_caps().size(), kept.size());
    for (std::size_t k = 0; k < kept.size(); ++k) {
        EXPECT_EQ(builder.kept_caps()[k].axis, kept[k].axis);
        EXPECT_EQ(builder.kept_caps()[k].t, kept[k].t);
    }
}

void expect_consistent(const ContourBuilder& builder, const std::vector<Cap>& caps) {
    expect_exposed_arcs(builder, caps);
    expect_closed_loops(builder);
    expect_kept_caps_suffice(builder, caps);
    expect_caps_are_those_numbered(builder, caps);
}

// The arcs by the atoms of their caps: cap, from, to.
std::set<std::array<std::uint32_t, 3>> named_arcs(const ContourBuilder& builder, const std::vector<Cap>& caps) {
    const auto name = [&](std::uint32_t k) { return k == kWholeCircle ? kWholeCircle : caps[builder.kept()[k]].atom; };
    std::set<std::array<std::uint32_t, 3>> names;
    for (const ContourArc& arc : builder.arcs()) names.insert({name(arc.cap), name(arc.from), name(arc.to)});
    return names;
}

TEST(Contour, WithoutCapsEverythingIsExposed) {
    ContourBuilder builder;
    EXPECT_TRUE(builder.build(CapColumns()));
    EXPECT_TRUE(builder.exposed());
    EXPECT_TRUE(builder.arcs().empty());
    EXPECT_TRUE(builder.kept().empty());
}

TEST(Contour, OneCapLeavesItsWholeRim) {
    for (const double t : {-0.9, 0.0, 0.9}) {
        const std::vector<Cap> caps = {{kZ, t, 0}};
        ContourBuilder builder;
        ASSERT_TRUE(builder.build(columns_of(caps)));
        ASSERT_EQ(builder.arcs().size(), 1U);
        EXPECT_EQ(builder.arcs()[0].from, kWholeCircle);
        EXPECT_EQ(builder.arcs()[0].sweep, 4.0);
        expect_consistent(builder, caps);
    }
}

TEST(Contour, TwoCrossingCapsLeaveAnArcOfEach) {
    const std::vector<Cap> caps = {{kX, 0.5, 0}, {kY, 0.6, 1}};
    ContourBuilder builder;
    ASSERT_TRUE(builder.build(columns_of(caps)));
    EXPECT_EQ(named_arcs(builder, caps), (std::set<std::array<std::uint32_t, 3>>{{0, 1, 1}, {1, 0, 0}}));
    expect_consistent(builder, caps);
    const double z = std::sqrt(1.0 - 0.25 - 0.36);
    EXPECT_NEAR(std::abs(rim_crossing(caps[0], caps[1]).z), z, 1e-15);
    EXPECT_NEAR(rim_crossing(caps[0], caps[1]).z, -rim_crossing(caps[1], caps[0]).z, 1e-15);
}

TEST(Contour, ArcsRunClockwiseAroundTheirCaps) {
    const std::vector<Cap> caps = {{kX, 0.5, 0}, {kY, 0.6, 1}};
    ContourBuilder builder;
    ASSERT_TRUE(builder.build(columns_of(caps)));
    const std::vector<Cap> kept = kept_of(builder, caps);
    for (const ContourArc& arc : builder.arcs()) {
        const Cap& cap = kept[arc.cap];
        const Vec3 before = rim_crossing(kept[arc.from], cap);
        const Vec3 after = on_arc(kept, arc, 0.1 * arc.sweep);
        EXPECT_LT(dot(cross(before, after - before), cap.axis), 0.0);
    }
}

TEST(Contour, ACapInsideAnotherChangesNothing) {
    const std::vector<Cap> caps = {{kZ, 0.2, 0}, {normalised({0.1, 0, 1}), 0.9, 1}};
    ContourBuilder builder;
    ASSERT_TRUE(builder.build(columns_of(caps)));
    EXPECT_EQ(named_arcs(builder, caps).size(), 1U);
    EXPECT_EQ(builder.kept().size(), 1U);
    expect_consistent(builder, caps);
}

TEST(Contour, ALargerCapReplacesTheOneInsideIt) {
    const std::vector<Cap> caps = {{normalised({0.1, 0, 1}), 0.9, 0}, {kZ, 0.2, 1}};
    ContourBuilder builder;
    ASSERT_TRUE(builder.build(columns_of(caps)));
    EXPECT_EQ(named_arcs(builder, caps), (std::set<std::array<std::uint32_t, 3>>{{1, kWholeCircle, kWholeCircle}}));
    expect_consistent(builder, caps);
}

TEST(Contour, DisjointCapsLeaveBothRims) {
    const std::vector<Cap> caps = {{kZ, 0.5, 0}, {-kZ, 0.3, 1}};
    ContourBuilder builder;
    ASSERT_TRUE(builder.build(columns_of(caps)));
    EXPECT_EQ(builder.arcs().size(), 2U);
    expect_consistent(builder, caps);
}

TEST(Contour, TwoCapsCanCoverTheSphereWithoutCrossing) {
    const std::vector<Cap> caps = {{kZ, -0.1, 0}, {-kZ, -0.2, 1}};
    ContourBuilder builder;
    ASSERT_TRUE(builder.build(columns_of(caps)));
    EXPECT_FALSE(builder.exposed());
    expect_kept_caps_suffice(builder, caps);
}

TEST(Contour, SixCapsCanCoverTheSphereTogether) {
    std::vector<Cap> caps = {{kX, 0.5, 0}, {-kX, 0.5, 1}, {kY, 0.5, 2}, {-kY, 0.5, 3}, {kZ, 0.5, 4}, {-kZ, 0.5, 5}};
    ContourBuilder builder;
    ASSERT_TRUE(builder.build(columns_of(caps)));
    EXPECT_FALSE(builder.exposed());
    expect_kept_caps_suffice(builder, caps);
    for (Cap& cap : caps) cap.t = 0.6;  // now the eight directions (±1, ±1, ±1) are free
    ASSERT_TRUE(builder.build(columns_of(caps)));
    EXPECT_EQ(builder.arcs().size(), 24U);
    expect_consistent(builder, caps);
}

TEST(Contour, ABuriedMiddleNeedsACapWhoseRimIsCovered) {
    // Four caps cover the rim of the first, which alone buries the pole.
    std::vector<Cap> caps = {{kZ, 0.9, 0}};
    std::uint32_t atom = 1;
    for (const Vec3 side : {kX, -kX, kY, -kY}) caps.push_back({normalised(side + 1.2 * kZ), 0.8, atom++});
    ContourBuilder builder;
    ASSERT_TRUE(builder.build(columns_of(caps)));
    expect_consistent(builder, caps);
    EXPECT_TRUE(std::any_of(builder.kept().begin(), builder.kept().end(),
                            [&](std::uint32_t k) { return inside(caps[k], kZ); }));
}

TEST(Contour, RandomCapsGiveConsistentContours) {
    ContourBuilder builder;
    int with_vertices = 0;
    for (std::uint32_t seed = 0; seed < 150; ++seed) {
        const std::vector<Cap> caps = random_caps(seed, 3 + seed % 30, 0.5, 0.98);
        ASSERT_TRUE(builder.build(columns_of(caps)));
        expect_consistent(builder, caps);
        with_vertices += builder.arcs().size() > 6 ? 1 : 0;
    }
    EXPECT_GT(with_vertices, 60);
}

TEST(Contour, CapsLargerThanAHemisphereGiveConsistentContours) {
    ContourBuilder builder;
    for (std::uint32_t seed = 0; seed < 150; ++seed) {
        const std::vector<Cap> caps = random_caps(seed, 2 + seed % 4, -0.8, 0.5);
        ASSERT_TRUE(builder.build(columns_of(caps)));
        expect_consistent(builder, caps);
    }
}

TEST(Contour, DoesNotDependOnTheOrderOfInsertion) {
    ContourBuilder builder;
    std::mt19937_64 random(5);
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        std::vector<Cap> caps = random_caps(seed, 12, 0.3, 0.9);
        ASSERT_TRUE(builder.build(columns_of(caps)));
        const auto expected = named_arcs(builder, caps);
        for (int repeat = 0; repeat < 3; ++repeat) {
            std::shuffle(caps.begin(), caps.end(), random);
            ASSERT_TRUE(builder.build(columns_of(caps)));
            EXPECT_EQ(named_arcs(builder, caps), expected);
        }
    }
}

TEST(Contour, ExtendedContourIsThatOfAllCaps) {
    ContourBuilder builder;
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        const std::vector<Cap> caps = random_caps(seed, 30, 0.5, 0.98);
        ASSERT_TRUE(builder.build(columns_of(caps)));
        const auto expected = named_arcs(builder, caps);
        ASSERT_TRUE(builder.build_in_order(columns_of(std::span(caps).first(8))));
        ASSERT_TRUE(builder.extend(columns_of(caps)));
        EXPECT_EQ(named_arcs(builder, caps), expected);
        expect_consistent(builder, caps);
    }
}

TEST(Contour, PerpendicularIsAUnitVectorAcross) {
    std::mt19937_64 random(6);
    std::vector<Vec3> axes = {kX, kY, kZ, -kX, -kY, -kZ};
    for (int i = 0; i < 100; ++i) axes.push_back(random_direction(random));
    for (const Vec3& axis : axes) {
        EXPECT_NEAR(dot(perpendicular(axis), axis), 0.0, 1e-15);
        EXPECT_NEAR(norm(perpendicular(axis)), 1.0, 1e-15);
    }
}

TEST(Contour, RimsCrossExactlyWhereTheirAnglesAllow) {
    std::mt19937_64 random(7);
    std::uniform_real_distribution<double> t(-0.99, 0.99);
    for (int i = 0; i < 2000; ++i) {
        const Cap a{random_direction(random), t(random), 0};
        const Cap b{random_direction(random), t(random), 1};
        const double between = std::acos(dot(a.axis, b.axis));
        const double first = std::acos(a.t);
        const double second = std::acos(b.t);
        const double turn = 2.0 * std::acos(-1.0);
        const bool cross =
            between < first + second && between > std::abs(first - second) && between + first + second < turn;
        EXPECT_EQ(cross_rims(a, b).crosses, cross);
    }
}

// Of spheres next to each other as rounding has it, of which only the perturbation tells which buries which.
TEST(Contour, RimsThatAllButCoincideCrossWhereTheirAnglesAllow) {
    constexpr double kAngle = 1e-9;
    const Cap a{{0.0, 0.0, 1.0}, 0.3, 0};
    for (const double shift : {-1e-8, -2e-9, -5e-10, 5e-10, 2e-9, 1e-8}) {
        const Cap b{{kAngle, 0.0, 1.0}, 0.3 + shift, 1};
        const RimCrossing crossing = cross_rims(a, b);
        EXPECT_EQ(crossing.crosses, std::abs(shift) < kAngle * std::sqrt(1.0 - 0.09)) << shift;
        if (!crossing.crosses) continue;
        EXPECT_NEAR(crossing.onto.x, shift / kAngle, 1e-6);
        EXPECT_NEAR(norm(crossing.back), 1.0, 1e-6);
    }
    EXPECT_FALSE(cross_rims(a, {a.axis, 0.3 + 1e-10, 1}).crosses);
    EXPECT_FALSE(cross_rims(a, a).crosses);
}

}  // namespace
}  // namespace meniscus::testing
