// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <stdexcept>

#include "exact/measure_surface.h"
#include "geometry/accessible_surface.h"
#include "meniscus/errors.h"
#include "meniscus/measures.h"
#include "support/arrangements.h"

namespace meniscus {
namespace {

Atoms random_cluster(std::size_t count, double extent, unsigned seed) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> within(0.0, extent);
    std::uniform_real_distribution<double> size(1.2, 2.0);
    Atoms atoms;
    for (std::size_t i = 0; i < count; ++i) {
        atoms.centres.push_back({within(random), within(random), within(random)});
        atoms.radii.push_back(size(random));
    }
    return atoms;
}

// A closed shell of atoms: its inside is a cavity.
Atoms shell(double radius, int count, const Vec3& centre = {}) {
    Atoms atoms;
    for (int i = 0; i < count; ++i) {  // Fibonacci sphere
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double angle = 2.399963229728653 * i;
        const double r = std::sqrt(1.0 - z * z);
        atoms.centres.push_back(centre + radius * Vec3{r * std::cos(angle), r * std::sin(angle), z});
        atoms.radii.push_back(1.7);
    }
    return atoms;
}

void append(Atoms& atoms, const Atoms& more) {
    atoms.centres.insert(atoms.centres.end(), more.centres.begin(), more.centres.end());
    atoms.radii.insert(atoms.radii.end(), more.radii.begin(), more.radii.end());
}

TEST(Measure, ASurfaceThatIsThereAlreadyGivesTheSame) {
    const Atoms atoms = random_cluster(40, 9.0, 5);
    const Measures alone = measure(atoms, {.probe = 1.1});
    const Measures m = measure(AccessibleSurface(atoms, 1.1), atoms, {.probe = 7.0});
    EXPECT_EQ(m.options.probe, 1.1) << "of the surface";
    EXPECT_EQ(m.totals.ses_area, alone.totals.ses_area);
    EXPECT_EQ(m.totals.ses_volume, alone.totals.ses_volume);
    EXPECT_EQ(m.errors.ses_area, alone.errors.ses_area);
    EXPECT_EQ(m.patches.size(), alone.patches.size());
}

TEST(Measure, OneSphereHasItsClosedForms) {
    const Measures m = measure({{{1, 2, 3}}, {1.7}});
    EXPECT_NEAR(m.totals.ses_area, 4 * std::numbers::pi * 1.7 * 1.7, 1e-9 * m.totals.ses_area);
    EXPECT_NEAR(m.totals.ses_volume, 4 * std::numbers::pi / 3 * std::pow(1.7, 3), 1e-9 * m.totals.ses_volume);
    EXPECT_NEAR(m.totals.sas_area, 4 * std::numbers::pi * 3.1 * 3.1, 1e-9 * m.totals.sas_area);
    EXPECT_NEAR(m.totals.sas_volume, 4 * std::numbers::pi / 3 * std::pow(3.1, 3), 1e-9 * m.totals.sas_volume);
    ASSERT_EQ(m.components.size(), 1U);
    EXPECT_EQ(m.components[0].kind, ComponentKind::Outer);
    EXPECT_EQ(m.components[0].inside_of, kNone);
    EXPECT_NEAR(norm(m.components[0].centre - Vec3{1, 2, 3}), 0.0, 1e-12);
    EXPECT_LE(std::abs(m.totals.ses_area - 4 * std::numbers::pi * 1.7 * 1.7), m.errors.ses_area)
        << "the error estimate holds";
}

// SES of two spheres whose probe circle exists: on each side of its plane a cap of the sphere, and the torus from there
// to the plane, or to the axis where the circle is smaller than the probe.
struct TwoSpheres {
    double area = 0.0;
    double volume = 0.0;
};

TwoSpheres two_spheres(double r1, double r2, double d, double probe) {
    const double rho1 = r1 + probe;
    const double rho2 = r2 + probe;
    const double h1 = (d * d + rho1 * rho1 - rho2 * rho2) / (2 * d);
    const double a = std::sqrt(rho1 * rho1 - h1 * h1);
    const double cut = a < probe ? std::acos(a / probe) : 0.0;
    TwoSpheres result;
    const auto add_side = [&](double r, double height) {
        const double rho = r + probe;
        const double x = r * height / rho;  // where the cap ends
        result.area += 2 * std::numbers::pi * r * (r + x);
        result.volume += std::numbers::pi / 3 * (2 * r * r * r + 3 * r * r * x - x * x * x);
        // Along the torus y = a - R cos ψ, dx = R cos ψ dψ.
        const auto area_to = [&](double psi) {
            return 2 * std::numbers::pi * probe * (a * psi - probe * std::sin(psi));
        };
        const auto volume_to = [&](double psi) {
            const double sine = std::sin(psi);
            return std::numbers::pi * probe *
                   (a * a * sine - a * probe * (psi + sine * std::cos(psi)) +
                    probe * probe * (sine - sine * sine * sine / 3));
        };
        const double end = std::atan2(height, a);
        result.area += area_to(end) - area_to(cut);
        result.volume += volume_to(end) - volume_to(cut);
    };
    add_side(r1, h1);
    add_side(r2, d - h1);
    return result;
}

TEST(Measure, TwoSpheresHaveTheirClosedForms) {
    for (const testing::TwoSpheresReference& c : testing::kTwoSpheresReferences) {
        const Measures m =
            measure({{{0.1, 0.2, 0.3}, {0.1 + 0.6 * c.d, 0.2, 0.3 + 0.8 * c.d}}, {c.r1, c.r2}}, {.probe = c.probe});
        EXPECT_NEAR(m.totals.ses_area, c.area, 1e-6);
        EXPECT_NEAR(m.totals.ses_volume, c.volume, 1e-6);
        const TwoSpheres exact = two_spheres(c.r1, c.r2, c.d, c.probe);
        EXPECT_NEAR(m.totals.ses_area / exact.area, 1.0, 1e-9);
        EXPECT_NEAR(m.totals.ses_volume / exact.volume, 1.0, 1e-9);
    }
}

TEST(Measure, SharesAndPiecesSumToTheTotals) {
    const Measures m = measure(random_cluster(150, 16.0, 3), {.patches = true});
    double atoms_ses = 0.0;
    double atoms_sas = 0.0;
    for (const AtomMeasure& atom : m.atoms) {
        atoms_ses += atom.ses_area();
        atoms_sas += atom.sas_area;
    }
    EXPECT_NEAR(atoms_ses / m.totals.ses_area, 1.0, 1e-11);
    EXPECT_NEAR(atoms_sas / m.totals.sas_area, 1.0, 1e-11);
    double area = 0.0;
    double volume = 0.0;
    double sas = 0.0;
    for (const SurfaceComponent& c : m.components) {
        area += c.ses_area;
        sas += c.sas_area;
        volume += c.kind == ComponentKind::Outer ? c.ses_volume : -c.ses_volume;
        EXPECT_NEAR(c.contact_area + c.toroidal_area + c.reentrant_area, c.ses_area, 1e-9);
    }
    EXPECT_NEAR(area / m.totals.ses_area, 1.0, 1e-11);
    EXPECT_NEAR(sas / m.totals.sas_area, 1.0, 1e-11);
    EXPECT_NEAR(volume / m.totals.ses_volume, 1.0, 1e-11);
    double patches = 0.0;
    for (const PatchMeasure& patch : m.patches) patches += patch.ses_area;
    EXPECT_NEAR(patches / m.totals.ses_area, 1.0, 1e-11);
}

TEST(Measure, ShellHasOneCavityWithItsInscribedSphere) {
    const Measures m = measure(shell(7.0, 110));
    ASSERT_EQ(m.components.size(), 2U);
    EXPECT_EQ(m.components[1].kind, ComponentKind::Cavity);
    EXPECT_EQ(m.components[1].inside_of, 0U);
    EXPECT_NEAR(m.components[1].inscribed_radius, 7.0 - 1.7, 0.02);
    EXPECT_LT(norm(m.components[1].inscribed_centre), 0.3);
    EXPECT_EQ(m.components[1].atoms.size(), 110U);
}

TEST(Measure, AnIslandInACavityIsInsideTheCavity) {
    Atoms atoms = shell(11.0, 270);
    append(atoms, {{{0.5, 0.3, -0.2}, {30.0, 0.0, 0.0}}, {2.0, 1.5}});  // one in the cavity, one far outside
    const Measures m = measure(atoms);
    ASSERT_EQ(m.components.size(), 4U);
    EXPECT_EQ(m.components[0].kind, ComponentKind::Outer);
    EXPECT_EQ(m.components[0].inside_of, kNone);
    EXPECT_EQ(m.components[1].kind, ComponentKind::Cavity);
    EXPECT_EQ(m.components[1].inside_of, 0U);
    EXPECT_EQ(m.components[2].kind, ComponentKind::Outer);
    EXPECT_EQ(m.components[2].inside_of, 1U) << "the island";
    EXPECT_NEAR(m.components[2].ses_volume, 4 * std::numbers::pi / 3 * 8.0, 1e-6);
    EXPECT_EQ(m.components[3].inside_of, kNone) << "the one far outside";
}

TEST(Measure, TwoShellsAreTwoPiecesWithACavityEach) {
    Atoms atoms = shell(7.0, 110);
    append(atoms, shell(8.0, 140, {40.0, 3.0, 1.0}));
    const Measures m = measure(atoms);
    ASSERT_EQ(m.components.size(), 4U);
    for (const SurfaceComponent& c : m.components) {
        if (c.kind == ComponentKind::Outer) continue;
        ASSERT_NE(c.inside_of, kNone);
        EXPECT_LT(norm(c.centre - m.components[c.inside_of].centre), 1.0);
    }
}

// Turned, the same atoms are perturbed otherwise: what both say lies within both estimates.
TEST(Measure, ErrorEstimatesOfPiecesHold) {
    Atoms atoms = shell(11.0, 270);
    append(atoms, {{{0.5, 0.3, -0.2}, {2.5, 0.3, 1.1}, {30.0, 0.0, 0.0}}, {2.0, 1.5, 1.5}});
    append(atoms, random_cluster(150, 16.0, 3));
    Atoms turned = atoms;
    for (Vec3& c : turned.centres) c = {0.6 * c.x - 0.8 * c.y, 0.8 * c.x + 0.6 * c.y, c.z};
    const Measures one = measure(atoms);
    const Measures other = measure(turned);
    ASSERT_GT(one.components.size(), 2U);
    ASSERT_EQ(one.components.size(), other.components.size());
    for (std::size_t i = 0; i < one.components.size(); ++i) {
        const SurfaceComponent& a = one.components[i];
        const SurfaceComponent& b = other.components[i];
        EXPECT_LE(std::abs(a.ses_area - b.ses_area), a.errors.ses_area + b.errors.ses_area);
        EXPECT_LE(std::abs(a.ses_volume - b.ses_volume), a.errors.ses_volume + b.errors.ses_volume);
        EXPECT_LE(std::abs(a.sas_area - b.sas_area), a.errors.sas_area + b.errors.sas_area);
        EXPECT_LE(std::abs(a.sas_volume - b.sas_volume), a.errors.sas_volume + b.errors.sas_volume);
        EXPECT_LE(std::abs(a.reentrant_area - b.reentrant_area), a.errors.reentrant_area + b.errors.reentrant_area);
        EXPECT_LT(a.errors.ses_area, 1e-6 * a.ses_area);
        EXPECT_LT(a.errors.ses_volume, 1e-6 * a.ses_volume);
        EXPECT_GT(a.errors.ses_area, 0.0);
    }
}

// Over each side of a cube a probe touches four atoms: which triangles they make depends on the perturbation.
TEST(Measure, ErrorEstimatesOfPiecesAreSmallWhereProbesTouchManyAtoms) {
    Atoms cube;
    for (const double x : {-3.0, 3.0})
        for (const double y : {-3.0, 3.0})
            for (const double z : {-3.0, 3.0}) append(cube, {{{x, y, z}}, {3.2}});
    const Measures m = measure(cube);
    ASSERT_EQ(m.components.size(), 2U);
    for (const SurfaceComponent& c : m.components) {
        EXPECT_LT(c.errors.ses_area, 1e-5 * c.ses_area);
        EXPECT_LT(c.errors.ses_volume, 1e-5 * c.ses_volume);
    }
}

TEST(Measure, ASpindleTorusSeparatesTwoSpheres) {
    const Measures m = measure({{{0, 0, 0}, {5.9, 0, 0}}, {1.7, 1.7}});
    EXPECT_EQ(m.components.size(), 2U);
    EXPECT_EQ(m.sas_components, 1U);
}

TEST(Measure, ProbeZeroGivesTheVanDerWaalsSurface) {
    const Measures m = measure({{{0, 0, 0}, {1.2, 0, 0}}, {1.7, 1.5}}, {.probe = 0.0});
    const double h = (1.2 * 1.2 + 1.7 * 1.7 - 1.5 * 1.5) / 2.4;
    const double area = 2 * std::numbers::pi * (1.7 * (1.7 + h) + 1.5 * (1.5 + 1.2 - h));
    EXPECT_NEAR(m.totals.ses_area, area, 1e-8);
    EXPECT_NEAR(m.totals.sas_area, area, 1e-8);
    EXPECT_EQ(m.totals.toroidal_area, 0.0);
    EXPECT_EQ(m.totals.reentrant_area, 0.0);
    EXPECT_EQ(m.components.size(), 1U);
}

TEST(Measure, DoesNotDependOnOrderThreadsOrPlace) {
    const Atoms atoms = random_cluster(120, 15.0, 5);
    const Measures m = measure(atoms, {.threads = 1});
    const Measures threads = measure(atoms, {.threads = 2});
    EXPECT_EQ(m.totals.ses_area, threads.totals.ses_area);
    EXPECT_EQ(m.totals.ses_volume, threads.totals.ses_volume);

    std::vector<std::uint32_t> order(atoms.size());
    std::iota(order.begin(), order.end(), 0U);
    std::shuffle(order.begin(), order.end(), std::mt19937(2));
    Atoms shuffled;
    Atoms moved;
    for (const std::uint32_t i : order) {
        const Vec3& c = atoms.centres[i];
        shuffled.centres.push_back(c);
        shuffled.radii.push_back(atoms.radii[i]);
        moved.centres.push_back(Vec3{0.6 * c.x - 0.8 * c.y, 0.8 * c.x + 0.6 * c.y, c.z} + Vec3{310.1, -42.7, 5.3});
        moved.radii.push_back(atoms.radii[i]);
    }
    const Measures other_order = measure(shuffled);
    EXPECT_EQ(m.totals.ses_area, other_order.totals.ses_area);
    for (std::size_t i = 0; i < order.size(); ++i) EXPECT_EQ(other_order.atoms[i].sas_area, m.atoms[order[i]].sas_area);
    const Measures elsewhere = measure(moved);
    EXPECT_NEAR(elsewhere.totals.ses_area / m.totals.ses_area, 1.0, 1e-8);
    EXPECT_NEAR(elsewhere.totals.ses_volume / m.totals.ses_volume, 1.0, 1e-8);
    EXPECT_EQ(elsewhere.components.size(), m.components.size());
}

TEST(Measure, DepthIsTheDistanceBelowTheSurface) {
    const Measures m = measure({{{0, 0, 0}}, {1.7}}, {.depth = true});
    EXPECT_NEAR(m.atoms[0].depth, 1.7, 1e-9);
}

TEST(Measure, DuplicatesCountOnce) {
    const Measures m = measure({{{0, 0, 0}, {0, 0, 0}, {1.5, 0, 0}}, {1.7, 1.7, 1.5}});
    const Measures single = measure({{{0, 0, 0}, {1.5, 0, 0}}, {1.7, 1.5}});
    EXPECT_EQ(m.totals.ses_area, single.totals.ses_area);
    EXPECT_EQ(m.atoms[1].ses_area(), 0.0);
    EXPECT_EQ(m.atoms[0].ses_area(), single.atoms[0].ses_area());
}

// Two spheres an ulp apart: their rims on the third differ by the perturbation alone.
TEST(Measure, SpheresAnUlpApartAreOne) {
    const Measures m = measure({{{1, 0, 0}, {std::nextafter(1.0, 2.0), 0, 0}, {3.2, 0.4, 0.3}}, {2.0, 2.0, 1.7}});
    const Measures single = measure({{{1, 0, 0}, {3.2, 0.4, 0.3}}, {2.0, 1.7}});
    EXPECT_TRUE(m.agreed);
    EXPECT_NEAR(m.totals.ses_area / single.totals.ses_area, 1.0, 1e-9);
    EXPECT_NEAR(m.totals.sas_volume / single.totals.sas_volume, 1.0, 1e-9);
}

// Five atoms, on the brink of a sixth side: the walls of the cavity have no thickness in places, and a step of the
// search for its inscribed sphere led out of it and away.
TEST(Measure, TheInscribedSphereOfASmallCavityStaysInIt) {
    const Measures m =
        measure({{{2, 0, 0}, {4, 2, 2}, {2, 0, 2}, {4, 0, 0}, {2, 2, 0}}, {1.7, 1.7, 1.7, 1.7, 1.7}}, {.probe = 0.0});
    ASSERT_EQ(m.components.size(), 2U);
    EXPECT_NEAR(m.components[1].inscribed_radius, std::sqrt(3.0) - 1.7, 1e-6);
    EXPECT_NEAR(norm(m.components[1].inscribed_centre - Vec3{3, 1, 1}), 0.0, 1e-5);
}

// Two spheres that the probe just fits between leave tiny caps on each other, here in the middle of exposed ground.
TEST(Measure, ACapAtExactContactDividesNothing) {
    const auto with_gap = [](double height) {
        return measure({{{11.7, 0, height},
                         {7.02, 4.68, 0},
                         {4.68, 7.02, 0},
                         {7.02, 7.02, 0},
                         {7.02, 7.02, height},
                         {9.36, 7.02, 0},
                         {7.02, 11.7, 0}},
                        std::vector<double>(7, 1.5)});
    };
    const Measures contact = with_gap(5.799999999999);
    const Measures apart = with_gap(5.8 + 1e-6);
    EXPECT_TRUE(contact.agreed);
    EXPECT_EQ(contact.components.size(), apart.components.size());
    EXPECT_NEAR(contact.totals.ses_area, apart.totals.ses_area, 1e-3);
}

// Two rows of four touching spheres, found by fuzzing: the reentrant patches of two evaluations differed by 3.7 Å².
TEST(Measure, RowsOfTouchingSpheresAreAgreedUpon) {
    Atoms atoms;
    for (const double x : {-4.0, 2.0})
        for (const double y : {-4.0, -2.0, 0.0, 2.0}) atoms.centres.push_back({x, y, 0.0});
    atoms.radii.assign(atoms.centres.size(), 1.0);
    const Measures m = measure(atoms, {.probe = 3.7});
    EXPECT_TRUE(m.agreed);
    EXPECT_LT(m.errors.reentrant_area, 1e-5 * m.totals.reentrant_area);
}

// Each sums its volumes from an origin of its own: what rounding leaves open is not multiplied by the way between.
TEST(Measure, ClustersFarApartAreMeasuredAsTheyAreAlone) {
    Atoms atoms = random_cluster(20, 6.0, 3);
    const Measures alone = measure(atoms);
    for (std::size_t i = 0; i < 20; ++i) {
        atoms.centres.push_back(atoms.centres[i] + Vec3{1e6, 7e5, -3e5});
        atoms.radii.push_back(atoms.radii[i]);
    }
    const Measures both = measure(atoms);
    EXPECT_TRUE(both.agreed);
    EXPECT_NEAR(both.totals.ses_volume / alone.totals.ses_volume, 2.0, 1e-8);
    EXPECT_NEAR(both.totals.sas_volume / alone.totals.sas_volume, 2.0, 1e-8);
    EXPECT_NEAR(norm(both.components[0].centre - both.components[1].centre), norm(Vec3{1e6, 7e5, -3e5}), 1e-3);
}

// The surface is then that of the atoms' convex hull (Steiner's formula), summed of areas that are larger as the probe
// squared: what they lose by rounding has to be in the errors, and where it is much, evaluations must not agree.
TEST(Measure, ErrorEstimatesOfHugeProbesHold) {
    constexpr double kRadius = 1.5;
    const double edge = 2.0 * std::numbers::sqrt2;
    const Atoms atoms{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, {kRadius, kRadius, kRadius, kRadius}};
    const double faces = std::sqrt(3.0) * edge * edge;
    const double curvature = 3.0 * edge * (std::numbers::pi - std::acos(1.0 / 3.0));
    const double area = faces + 2.0 * curvature * kRadius + 4.0 * std::numbers::pi * kRadius * kRadius;
    const double volume = edge * edge * edge / (6.0 * std::numbers::sqrt2) + faces * kRadius +
                          curvature * kRadius * kRadius + 4.0 / 3.0 * std::numbers::pi * std::pow(kRadius, 3);
    for (const double probe : {1e5, 1e6, 1e7, 1e8, 1e9}) {
        SCOPED_TRACE(probe);
        const Measures m = measure(atoms, {.probe = probe});
        const double sag = 100.0 / probe;  // of what lies between the atoms
        EXPECT_NEAR(m.totals.ses_area, area, m.errors.ses_area + sag);
        EXPECT_NEAR(m.totals.ses_volume, volume, m.errors.ses_volume + sag);
        EXPECT_EQ(m.agreed, m.disputed.empty());
        EXPECT_TRUE(!m.agreed || std::abs(m.totals.ses_volume - volume) < 1e-5 * volume);
    }
}

// Places have the rounding of their coordinates, which two evaluations have in common.
TEST(Measure, ErrorEstimatesFarFromTheOriginHold) {
    Atoms atoms = random_cluster(60, 9.0, 8);
    for (Vec3& c : atoms.centres)
        c = {std::ldexp(std::round(std::ldexp(c.x, 10)), -10), std::ldexp(std::round(std::ldexp(c.y, 10)), -10),
             std::ldexp(std::round(std::ldexp(c.z, 10)), -10)};
    const Measures near = measure(atoms);
    for (const int power : {20, 30, 34, 38}) {
        SCOPED_TRACE(power);
        const double far = std::ldexp(1.0, power);
        Atoms moved = atoms;
        for (Vec3& c : moved.centres) c = c + Vec3{far, -far, far};
        const Measures m = measure(moved);
        EXPECT_NEAR(m.totals.ses_area, near.totals.ses_area, near.errors.ses_area + m.errors.ses_area);
        EXPECT_NEAR(m.totals.ses_volume, near.totals.ses_volume, near.errors.ses_volume + m.errors.ses_volume);
        EXPECT_EQ(m.agreed, power < 31);
        EXPECT_EQ(m.agreed, m.disputed.empty());
    }
}

TEST(Measure, ErrorEstimatesOfSmallSpheresHold) {
    for (const double radius : {1.0, 0.1, 1e-2, 1e-3})
        for (int k = 0; k < 40; ++k) {
            const Measures m = measure({{{0.37 * k, 1.0, -0.11 * k}}, {radius}}, {.probe = 0.0});
            EXPECT_NEAR(m.totals.ses_area, 4.0 * std::numbers::pi * radius * radius, m.errors.ses_area)
                << radius << ' ' << k;
            EXPECT_NEAR(m.totals.ses_volume, 4.0 / 3.0 * std::numbers::pi * std::pow(radius, 3), m.errors.ses_volume);
        }
}

TEST(Measure, WhatIsDisputedHasAName) {
    const Measures m = measure({{{0, 0, 0}}, {1e-3}}, {.probe = 1.4});
    EXPECT_FALSE(m.agreed) << "the perturbation of 1e-10 Å is more than 1e-7 of the area";
    EXPECT_EQ(m.disputed.size(), 1U);
}

TEST(Measure, ProbeOutOfRangeIsAUsageError) {
    EXPECT_THROW(measure({{{0, 0, 0}}, {1.7}}, {.probe = -1.0}), UsageError);
    EXPECT_THROW(measure({}, {}), std::invalid_argument);
}

TEST(Measure, TheLargestPieceOfTheSasHasItsOwnPatchesOnly) {
    const Measures one = measure({{{0, 0, 0}, {2.5, 0, 0}, {1.2, 2.2, 0}}, {1.7, 1.6, 1.5}});
    EXPECT_NEAR(one.largest_sas_piece.sum(), one.totals.ses_area, 1e-9);
    EXPECT_NEAR(one.largest_sas_piece.reentrant, one.totals.reentrant_area, 1e-9);
    const Measures two = measure({{{0, 0, 0}, {2.5, 0, 0}, {1.2, 2.2, 0}, {30, 0, 0}}, {1.7, 1.6, 1.5, 1.7}});
    EXPECT_NEAR(two.largest_sas_piece.sum(), one.totals.ses_area, 1e-9);
    EXPECT_EQ(two.sas_components, 2U);
}

}  // namespace
}  // namespace meniscus
