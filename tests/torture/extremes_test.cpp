// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Arrangements at the ends of every scale: done within modest memory, or refused with a reason.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "meniscus/errors.h"
#include "support/arrangements.h"
#include "torture/surface_checks.h"

namespace meniscus::testing {
namespace {

constexpr double kPi = std::numbers::pi;

double sphere_area(double radius) { return 4.0 * kPi * radius * radius; }

// The memory is what the library allows itself, 1 GB at most.
Surface modest_surface(const Atoms& atoms, const SurfaceOptions& options) {
    return compute_surface(atoms, options, {.threads = 1, .memory_limit_mb = 1000});
}

void expect_sound(const Atoms& atoms, const SurfaceOptions& options) {
    const Surface surface = modest_surface(atoms, options);
    EXPECT_FALSE(surface.mesh.triangles.empty());
    EXPECT_EQ(what_is_wrong_with_mesh(surface, atoms.size()), "");
    EXPECT_EQ(what_is_wrong_with_size(surface, atoms, 0.5, 0.05), "");
}

// All at one place, of one size, of as many sizes as atoms, or of a few.
Atoms coincident_atoms(std::size_t count, std::size_t sizes) {
    Atoms atoms;
    for (std::size_t i = 0; i < count; ++i) {
        atoms.centres.push_back({1.0, 2.0, 3.0});
        atoms.radii.push_back(1.0 + static_cast<double>(i % sizes) / static_cast<double>(sizes));
    }
    return atoms;
}

TEST(Extremes, AHundredThousandCoincidentAtomsAreTheLargestOfThem) {
    for (const std::size_t sizes : {1U, 7U, 100000U}) {
        const Atoms atoms = coincident_atoms(100000, sizes);
        const double radius = 1.0 + static_cast<double>(sizes - 1) / static_cast<double>(sizes);
        const Measures m = measure(atoms, {.threads = 1});
        EXPECT_TRUE(m.agreed);
        EXPECT_NEAR(m.totals.ses_area, sphere_area(radius), 1e-7);
        EXPECT_NEAR(m.atoms[sizes - 1].ses_area(), sphere_area(radius), 1e-7) << "the first of the largest has it all";
        expect_sound(atoms, {.method = Method::Direct});
    }
}

// Copies of an atom and atoms within others add no surface, so that memory is not refused for them.
TEST(Extremes, CoincidentAtomsAreNotExpectedToCost) {
    const Atoms atoms = coincident_atoms(20000, 7);
    EXPECT_LT(estimate_cost(atoms, {}).area, 2.0 * sphere_area(2.0));
}

TEST(Extremes, CentresAnUlpApart) {
    Atoms atoms;
    for (int i = 0; i < 1000; ++i) {
        const double x = i % 3 == 0 ? std::nextafter(1.0, 2.0) : i % 3 == 1 ? std::nextafter(1.0, 0.0) : 1.0;
        atoms.centres.push_back({x, 2.0, i % 2 == 0 ? 3.0 : std::nextafter(3.0, 4.0)});
        atoms.radii.push_back(i < 6 ? 1.7 : 1.0 + 1e-4 * i / 3.0);
    }
    const Measures m = measure(atoms, {.threads = 1});
    EXPECT_TRUE(m.agreed);
    EXPECT_NEAR(m.totals.ses_area, sphere_area(1.7), 1e-6);
    expect_sound(atoms, {});
}

TEST(Extremes, RadiiFromAHundredthToAHundred) {
    Atoms atoms{{{0, 0, 0}}, {100.0}};
    const std::vector<Vec3> places = hollow_shell(200, 100.5, 1.0).centres;
    for (std::size_t i = 0; i < places.size(); ++i) {
        atoms.centres.push_back(places[i]);
        atoms.radii.push_back(0.01 * std::pow(10.0, static_cast<double>(i) / 50.0));
    }
    for (const double probe : {0.0, 1.4, 10.0}) {
        EXPECT_TRUE(measure(atoms, {.probe = probe, .threads = 1}).agreed);
        const Surface surface = modest_surface(atoms, {.probe = probe, .spacing = 2.0});
        EXPECT_EQ(what_is_wrong_with_mesh(surface, atoms.size()), "");
        EXPECT_EQ(what_is_wrong_with_size(surface, atoms, 1.0, 0.02), "");
    }
}

TEST(Extremes, AMillionAngstromsBetweenTwoClusters) {
    Atoms atoms = random_cluster(3, 60, 12.0);
    const Measures near = measure(atoms, {.threads = 1});
    for (std::size_t i = 0; i < 60; ++i) {
        atoms.centres.push_back(atoms.centres[i] + Vec3{1e6, -1e6, 1e6});
        atoms.radii.push_back(atoms.radii[i]);
    }
    const Measures both = measure(atoms, {.threads = 1});
    EXPECT_TRUE(both.agreed);
    EXPECT_NEAR(both.totals.ses_area / near.totals.ses_area, 2.0, 1e-8);
    EXPECT_NEAR(both.totals.ses_volume / near.totals.ses_volume, 2.0, 1e-8);
    EXPECT_EQ(both.components.size(), 2 * near.components.size());
    for (const Method method : {Method::Direct, Method::Flow}) expect_sound(atoms, {.method = method});
}

// A hundred clusters apart: memory goes with the surface, not with the box around it.
TEST(Extremes, AGasOfAMillionAngstroms) {
    Atoms atoms = random_cluster(4, 100, 1e6);
    EXPECT_TRUE(measure(atoms, {.threads = 1}).agreed);
    expect_sound(atoms, {.spacing = 0.4});
}

TEST(Extremes, SpacingsLargerThanTheAtoms) {
    for (const double spacing : {2.0, 5.0, 20.0, 1e3})
        for (const Method method : {Method::Direct, Method::Flow}) {
            const Atoms atoms = random_cluster(5, 40, 12.0);
            const Surface surface = modest_surface(atoms, {.method = method, .spacing = spacing});
            EXPECT_EQ(what_is_wrong_with_mesh(surface, atoms.size()), "");
            EXPECT_TRUE(!surface.mesh.triangles.empty() || !surface.passed()) << "an empty mesh never passes";
        }
}

TEST(Extremes, WhatCannotBeComputedIsRefused) {
    const double infinity = std::numeric_limits<double>::infinity();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const Atoms one{{{0, 0, 0}}, {1.7}};
    EXPECT_THROW(modest_surface({{{0, 0, 0}}, {1e6}}, {}), LimitError);
    EXPECT_THROW(modest_surface(one, {.spacing = 1e-4}), LimitError);
    EXPECT_THROW(modest_surface({{{1e11, 0, 0}}, {1.7}}, {}), LimitError) << "farther than the grid can number";
    EXPECT_THROW(measure({{{1e13, 0, 0}}, {1.7}}), LimitError);
    EXPECT_THROW(measure({{{0, 0, 0}}, {1e13}}), LimitError);
    EXPECT_THROW(measure({{{nan, 0, 0}}, {1.7}}), std::invalid_argument);
    EXPECT_THROW(measure({{{0, infinity, 0}}, {1.7}}), std::invalid_argument);
    EXPECT_THROW(measure({{{0, 0, 0}}, {0.0}}), std::invalid_argument);
    EXPECT_THROW(measure({{{0, 0, 0}}, {nan}}), std::invalid_argument);
    EXPECT_THROW(measure({{{0, 0, 0}}, {}}), std::invalid_argument);
    EXPECT_THROW(measure(one, {.probe = infinity}), UsageError);
    EXPECT_THROW(modest_surface(one, {.spacing = nan}), UsageError);
    EXPECT_THROW(modest_surface(one, {.probe = -0.1}), UsageError);
}

}  // namespace
}  // namespace meniscus::testing
