// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/exact_surface.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <thread>
#include <vector>

#include "geometry/accessible_surface.h"
#include "meniscus/errors.h"
#include "support/arrangements.h"

namespace meniscus::testing {
namespace {

const Atoms kTwo{{{0, 0, 0}, {5, 0, 0}}, {1.5, 2.0}};

TEST(ExactSurface, IsTheExcludedSurfaceOfBalls) {
    const ExactSurface ses(kTwo, {.probe = 1.25});
    EXPECT_EQ(ses.balls().radii, kTwo.radii);
    EXPECT_EQ(ses.probe_of_balls(), 1.25);
    const ExactSurface sas = ses.of_same_atoms({SurfaceKind::Sas, 1.25});
    EXPECT_EQ(sas.balls().radii, (std::vector<double>{2.75, 3.25}));
    EXPECT_EQ(sas.balls().centres, kTwo.centres);
    EXPECT_EQ(sas.probe_of_balls(), 0.0);
    EXPECT_EQ(sas.atoms().radii, kTwo.radii);
    const ExactSurface vdw(kTwo, {SurfaceKind::Vdw, 1.25});
    EXPECT_EQ(vdw.balls().radii, kTwo.radii);
    EXPECT_EQ(vdw.probe_of_balls(), 0.0);
}

TEST(ExactSurface, IsBuiltAndMeasuredOnceForAllCopies) {
    const ExactSurface exact(random_cluster(40, 9.0, 5), {.probe = 1.1});
    const std::size_t before = accessible_surfaces_built();
    const Measures& measures = exact.measures();
    EXPECT_EQ(accessible_surfaces_built() - before, 1U);
    const std::vector<ExactSurface> copies{exact};
    const ExactSurface& copy = copies.front();
    EXPECT_EQ(&copy.measures(), &measures);
    EXPECT_EQ(&copy.of_same_atoms({.probe = 1.1}).measures(), &measures);
    EXPECT_EQ(copy.signed_distance(exact.atoms().centres).size(), exact.atoms().size());
    EXPECT_EQ(accessible_surfaces_built() - before, 1U);
    const ExactSurface larger = copy.of_same_atoms({.probe = 2.0});
    larger.accessible();
    exact.of_same_atoms({.probe = 2.0}).nearest_features(exact.atoms().centres);
    EXPECT_EQ(accessible_surfaces_built() - before, 2U);
}

TEST(ExactSurface, HasTheMeasuresOfItsAtoms) {
    const Atoms atoms = random_cluster(40, 9.0, 5);
    const Measures alone = measure(atoms, {.probe = 1.1});
    const ExactSurface exact(atoms, {.probe = 1.1});
    const Measures& own = exact.measures();
    EXPECT_EQ(own.totals.ses_area, alone.totals.ses_area);
    EXPECT_EQ(own.errors.ses_volume, alone.errors.ses_volume);
    EXPECT_EQ(own.components.size(), alone.components.size());
}

TEST(ExactSurface, OutlivesTheOneItWasMadeFrom) {
    ExactSurface other;
    {
        const ExactSurface exact(kTwo);
        other = exact.of_same_atoms({.probe = 3.0});
    }
    EXPECT_EQ(other.atoms().radii, kTwo.radii);
    EXPECT_NEAR(other.signed_distance(std::vector<Vec3>{{0, 0, 1.0}}).front(), -0.5, 1e-9);
}

TEST(ExactSurface, MayBeAskedBySeveralThreads) {
    const ExactSurface exact(random_cluster(60, 10.0, 3));
    std::vector<const Measures*> seen(4);
    std::vector<std::thread> threads;
    for (const Measures*& own : seen) threads.emplace_back([&exact, &own] { own = &exact.measures(); });
    for (std::thread& thread : threads) thread.join();
    for (const Measures* own : seen) EXPECT_EQ(own, &exact.measures());
}

TEST(ExactSurface, RefusesWhatHasNoGeometryWhenItIsAsked) {
    EXPECT_THROW(ExactSurface().accessible(), std::invalid_argument);
    EXPECT_THROW(ExactSurface({{{0, 0, 0}}, {0.0}}).accessible(), std::invalid_argument);
    for (const double radius : {0.0, -1.0}) {
        const ExactSurface sas({{{0, 0, 0}}, {radius}}, {SurfaceKind::Sas, 1.4});
        EXPECT_THROW(sas.accessible(), std::invalid_argument) << radius;
    }
}

TEST(ExactSurface, RefusesProbesThatAreNoRadii) {
    const ExactSurface exact(kTwo);
    for (const double probe : {-1.0, std::numeric_limits<double>::infinity(), std::nan("")}) {
        EXPECT_THROW(ExactSurface(kTwo, {.probe = probe}), UsageError) << probe;
        EXPECT_THROW(exact.of_same_atoms({.probe = probe}), UsageError) << probe;
    }
}

}  // namespace
}  // namespace meniscus::testing
