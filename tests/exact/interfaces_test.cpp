// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/interfaces.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "meniscus/errors.h"
#include "support/arrangements.h"

namespace meniscus {
namespace {

constexpr double kProbe = 1.4;

using testing::random_cluster;
using testing::two_spheres;

using Pairs = std::vector<std::array<std::uint32_t, 2>>;

// One of two spheres whose circle is wider than the probe: where the other's plane is, and the torus' share.
struct Side {
    double radius;
    double height;  // of the plane of the circle above the centre

    double rho() const { return radius + kProbe; }
    double buried_sas() const { return 2.0 * std::numbers::pi * rho() * (rho() - height); }
    double contact() const { return 2.0 * std::numbers::pi * radius * radius * (1.0 + height / rho()); }
    double torus() const {
        const double circle = std::sqrt(rho() * rho() - height * height);
        const double angle = std::asin(height / rho());
        return 2.0 * std::numbers::pi * kProbe * (circle * angle - kProbe * std::sin(angle));
    }
};

TEST(Interfaces, TwoSpheresHaveTheClosedForm) {
    const double distance = 4.0;
    const double height = (distance * distance + 3.1 * 3.1 - 2.9 * 2.9) / (2.0 * distance);
    const Side a{1.7, height};
    const Side b{1.5, distance - height};
    const Interface found = measure_interface(two_spheres(distance, a.radius, b.radius), {0}, {1});
    EXPECT_NEAR(found.sas_a, 4.0 * std::numbers::pi * 3.1 * 3.1, 1e-6);
    EXPECT_NEAR(found.ses_b, 4.0 * std::numbers::pi * 1.5 * 1.5, 1e-6);
    EXPECT_NEAR(found.buried_sas(), a.buried_sas() + b.buried_sas(), 1e-6);
    EXPECT_NEAR(found.interface_area(), 0.5 * (a.buried_sas() + b.buried_sas()), 1e-6);
    EXPECT_NEAR(found.ses_ab, a.contact() + a.torus() + b.contact() + b.torus(), 1e-6);
    EXPECT_NEAR(found.buried_ses(), found.ses_a + found.ses_b - found.ses_ab, 1e-9);
    EXPECT_LE(std::abs(found.buried_sas() - a.buried_sas() - b.buried_sas()), found.sas_error);
    EXPECT_LT(found.sas_error, 1e-6);
    EXPECT_GT(found.ses_error, 0.0);
    EXPECT_NEAR(found.atoms_a[0].buried_sas(), a.buried_sas(), 1e-6);
    EXPECT_NEAR(found.atoms_b[0].ses_complex, b.contact() + b.torus(), 1e-6);
    EXPECT_TRUE(found.agreed);
}

TEST(Interfaces, GroupsThatDoNotTouchLoseNothing) {
    const Interface found = measure_interface(two_spheres(6.1, 1.7, 1.5), {0}, {1});
    EXPECT_NEAR(found.buried_sas(), 0.0, 1e-9);
    EXPECT_NEAR(found.buried_ses(), 0.0, 1e-9);
}

TEST(Interfaces, AtomsSumToTheTotalsAndBuriedAreaIsNeverNegative) {
    const Atoms atoms = random_cluster(7, 60, 9.0);
    AtomGroup a;
    AtomGroup b;
    for (std::uint32_t i = 0; i < 50; ++i) (atoms.centres[i].x < 4.5 ? a : b).push_back(i);  // ten are in neither
    const Interface found = measure_interface(atoms, a, b);
    ASSERT_EQ(found.atoms_a.size(), a.size());
    ASSERT_EQ(found.atoms_b.size(), b.size());
    InterfaceAtom of_a;
    InterfaceAtom both;
    for (const InterfaceAtom& atom : found.atoms_a) {
        of_a += atom;
        EXPECT_GE(atom.buried_sas(), -1e-7);
    }
    both += of_a;
    for (const InterfaceAtom& atom : found.atoms_b) both += atom;
    EXPECT_NEAR(of_a.sas_alone, found.sas_a, 1e-11 * found.sas_a);
    EXPECT_NEAR(of_a.ses_alone, found.ses_a, 1e-11 * found.ses_a);
    EXPECT_NEAR(both.sas_complex, found.sas_ab, 1e-11 * found.sas_ab);
    EXPECT_NEAR(both.ses_complex, found.ses_ab, 1e-11 * found.ses_ab);
    EXPECT_GT(found.buried_sas(), 1.0);
}

TEST(Interfaces, SidesCanBeExchangedAndMeasuredTogetherWithOthers) {
    const Atoms atoms = random_cluster(3, 30, 9.0);
    std::vector<AtomGroup> groups(3);
    for (std::uint32_t i = 0; i < 30; ++i) groups[i % 3].push_back(i);
    const std::vector<Interface> found = measure_interfaces(atoms, groups, Pairs{{0, 1}, {1, 0}, {1, 2}});
    ASSERT_EQ(found.size(), 3u);
    EXPECT_NEAR(found[0].buried_sas(), found[1].buried_sas(), 1e-7 * found[0].sas_ab);
    EXPECT_EQ(found[0].sas_b, found[2].sas_a);
    EXPECT_NEAR(found[2].sas_ab, measure_interface(atoms, groups[1], groups[2]).sas_ab, 0.0);
}

TEST(Interfaces, RefuseGroupsThatMakeNoSense) {
    const Atoms atoms = two_spheres(4.0, 1.7, 1.5);
    EXPECT_THROW(measure_interface(atoms, {}, {1}), UsageError);
    EXPECT_THROW(measure_interface(atoms, {0}, {2}), UsageError);
    EXPECT_THROW(measure_interface(atoms, {0, 1}, {1}), UsageError);
    EXPECT_THROW(measure_interface(atoms, {0, 0}, {1}), UsageError);
    EXPECT_THROW(measure_interfaces(atoms, std::vector<AtomGroup>{{0}}, Pairs{{0, 1}}), UsageError);
}

TEST(Interfaces, TouchMeansThatSolventAccessibleSpheresMeet) {
    const auto touches = [](double distance) {
        return !touching_groups(two_spheres(distance, 1.7, 1.5), std::vector<std::uint32_t>{0, 1}, 2, kProbe).empty();
    };
    EXPECT_TRUE(touches(5.999));
    EXPECT_FALSE(touches(6.001));
}

TEST(Interfaces, TouchingPairsAreThoseOfEveryPairOfAtoms) {
    const Atoms atoms = random_cluster(11, 40, 9.0);
    std::vector<std::uint32_t> group(40);
    for (std::uint32_t i = 0; i < 40; ++i) group[i] = i % 8 == 7 ? kNone : i % 8;
    Pairs expected;
    for (std::uint32_t a = 0; a < 7; ++a)
        for (std::uint32_t b = a + 1; b < 7; ++b) {
            bool touch = false;
            for (std::size_t i = 0; i < 40; ++i)
                for (std::size_t j = 0; j < 40; ++j)
                    touch = touch || (group[i] == a && group[j] == b &&
                                      norm(atoms.centres[i] - atoms.centres[j]) <= atoms.radii[i] + atoms.radii[j]);
            if (touch) expected.push_back({a, b});
        }
    EXPECT_EQ(touching_groups(atoms, group, 7, 0.0), expected);
}

// The smaller of two atoms at one place is nothing to the surface, but its group touches what it reaches itself.
TEST(Interfaces, AtomsWithinOthersTouchByTheirOwnRadii) {
    Atoms atoms = two_spheres(5.5, 1.5, 1.5);
    atoms.centres.push_back(atoms.centres[0]);
    atoms.radii.push_back(3.0);
    const std::vector<std::uint32_t> group{0, 1, 2};
    EXPECT_EQ(touching_groups(atoms, group, 3, 0.6), (Pairs{{0, 2}, {1, 2}}));
    EXPECT_EQ(touching_groups(atoms, group, 3, 1.4), (Pairs{{0, 1}, {0, 2}, {1, 2}}));
}

TEST(Interfaces, AtomsAtOnePlaceTouch) {
    const Atoms atoms = two_spheres(0.0, 1.5, 1.5);
    EXPECT_EQ(touching_groups(atoms, std::vector<std::uint32_t>{1, 0}, 2, kProbe), (Pairs{{0, 1}}));
    EXPECT_EQ(touching_groups(two_spheres(0.0, 1.5, 1.7), std::vector<std::uint32_t>{0, 1}, 2, kProbe),
              (Pairs{{0, 1}}));
    EXPECT_THROW(touching_groups(atoms, std::vector<std::uint32_t>{0}, 2, kProbe), UsageError);
    EXPECT_THROW(touching_groups(atoms, std::vector<std::uint32_t>{0, 2}, 2, kProbe), UsageError);
}

}  // namespace
}  // namespace meniscus
