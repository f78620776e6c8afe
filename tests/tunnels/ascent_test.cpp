// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "tunnels/ascent.h"

#include <gtest/gtest.h>

#include <cmath>

#include "support/arrangements.h"
#include "tunnels/drilled_block.h"

namespace meniscus {
namespace {

TEST(StepUp, LeadsStraightAwayFromASingleAtom) {
    const std::vector<AtomView> atoms{{{0.0, 0.6, 0.8}, 1.0}};
    const Vec3 d = step_up(atoms, 2.0);
    EXPECT_NEAR(norm(d - Vec3{0.0, 1.2, 1.6}), 0.0, 1e-9);
}

TEST(StepUp, IsTheBestOfManySteps) {
    const std::vector<AtomView> atoms{
        {{1, 0, 0}, 1.0}, {{-0.6, 0.8, 0}, 1.1}, {{0, 0, 1}, 0.9}, {{0.36, -0.48, 0.8}, 1.0}};
    const auto value = [&](const Vec3& d) {
        double least = 1e300;
        for (const AtomView& a : atoms) least = std::min(least, a.clearance + dot(a.away, d));
        return least - squared_norm(d) / 4.0;
    };
    const double best = value(step_up(atoms, 2.0));
    for (double x = -2.0; x <= 2.0; x += 0.05)
        for (double y = -2.0; y <= 2.0; y += 0.05)
            for (double z = -2.0; z <= 2.0; z += 0.05) EXPECT_LE(value({x, y, z}), best + 1e-9);
}

TEST(Ascent, EndsInTheMiddleOfATetrahedron) {
    const Atoms atoms = testing::tetrahedral_spheres(6.0, 1.5);
    const Clearance clearance(atoms);
    Ascent ascent(clearance);
    const Vec3 end = ascent.climb({0.7, -0.4, 0.5}, [](const Vec3&) { return true; });
    EXPECT_NEAR(norm(end), 0.0, 1e-9);
}

TEST(Ascent, NeverLosesClearanceOnTheWay) {
    const Atoms atoms = testing::random_beads(11, 120, 16.0);
    const Clearance clearance(atoms);
    Ascent ascent(clearance);
    for (int i = 0; i < 40; ++i) {
        Vec3 at{0.4 * i, 8.0 + std::sin(i), 8.0 + std::cos(3.0 * i)};
        ascent.climb(at, [&](const Vec3& next) {
            EXPECT_GE(clearance.along(at, next), clearance.at(at) - 1e-12);
            EXPECT_GT(clearance.at(next), clearance.at(at) - 1e-14);
            at = next;
            return norm(at) < 100.0;
        });
    }
}

// A place is a maximum if and only if the unit vectors from the atoms that touch the ball hold zero between them.
TEST(Ascent, StopsOnlyWhereThereIsNoWayUp) {
    const Atoms atoms = testing::random_beads(13, 150, 16.0);
    const Clearance clearance(atoms);
    Ascent ascent(clearance);
    int maxima = 0;
    for (int i = 0; i < 60; ++i) {
        const Vec3 begin{2.0 + 0.2 * i, 3.0 + std::fmod(7.3 * i, 10.0), 3.0 + std::fmod(4.1 * i, 10.0)};
        const Vec3 end = ascent.climb(begin, [&](const Vec3& p) { return norm(p) < 100.0; });
        if (norm(end) >= 100.0) continue;
        ++maxima;
        const double here = clearance.at(end);
        for (double x = -1.0; x <= 1.0; x += 0.25)
            for (double y = -1.0; y <= 1.0; y += 0.25)
                for (double z = -1.0; z <= 1.0; z += 0.25)
                    EXPECT_LE(clearance.at(end + 1e-3 * Vec3{x, y, z}), here + 1e-9);
    }
    EXPECT_GT(maxima, 10);
}

}  // namespace
}  // namespace meniscus
