// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "geometry/neighbour_caps.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <set>
#include <span>

#include "core/perpendicular.h"
#include "geometry/random_caps.h"
#include "support/arrangements.h"

namespace meniscus::testing {
namespace {

constexpr double kProbeRadius = 1.4;

std::set<std::uint32_t> atoms_of(const CapList& caps) {
    std::set<std::uint32_t> atoms;
    for (const std::uint32_t atom : caps.atoms) EXPECT_TRUE(atoms.insert(atom).second);
    return atoms;
}

// Atoms whose enlarged spheres cut that of atom i.
std::set<std::uint32_t> neighbours_of(const AccessibleSurface::Data& data, std::uint32_t i) {
    std::set<std::uint32_t> neighbours;
    for (std::uint32_t j = 0; j < data.atoms.size(); ++j) {
        const double d = norm(data.atoms.centres[j] - data.atoms.centres[i]);
        if (j != i && d < data.rho[i] + data.rho[j] && data.rho[i] < d + data.rho[j]) neighbours.insert(j);
    }
    return neighbours;
}

TEST(NeighbourCaps, FindsTheCapsOfAllNeighbours) {
    const AccessibleSurface surface(random_cluster(1, 400, 30.0), kProbeRadius);
    const AccessibleSurface::Data& data = surface.data();
    const CellList cells(data.atoms);
    NeighbourCaps neighbours(data, cells);
    CapList caps;
    for (std::uint32_t i = 0; i < data.atoms.size(); ++i) {
        caps.clear();
        if (!neighbours.gather(i, {}, caps)) continue;
        EXPECT_EQ(atoms_of(caps), neighbours_of(data, i));
        ASSERT_EQ(caps.planes.size(), caps.atoms.size());
        for (std::size_t k = 0; k < caps.atoms.size(); ++k) {
            const Cap expected = cap_between(data, i, caps.atoms[k]);
            EXPECT_EQ((Vec3{caps.planes[0][k], caps.planes[1][k], caps.planes[2][k]}), expected.axis);
            EXPECT_EQ(caps.planes[3][k], expected.t);
        }
    }
}

// Spheres that touch but for rounding: whether they meet is said alike for one and for many side by side.
TEST(NeighbourCaps, AreThoseOfTheKernelsToTheLastBit) {
    std::mt19937_64 random(2);
    std::uniform_real_distribution<double> rho(1.0, 4.0);
    std::size_t meet = 0;
    std::size_t total = 0;
    for (int pair = 0; pair < 2000; ++pair) {
        AccessibleSurface::Data data;
        data.rho = {rho(random), rho(random)};
        const Vec3 first = 10.0 * random_direction(random);
        Vec3 second = first + (data.rho[0] + data.rho[1]) * random_direction(random);
        for (auto ulp = random() % 5; ulp > 0; --ulp) second.x = std::nextafter(second.x, first.x);
        data.atoms.centres = {first, second};
        for (const std::uint32_t one : {0U, 1U}) {
            const Cap expected = cap_between(data, one, 1 - one);
            meet += expected.t < 1.0 ? 1 : 0;
            ++total;
            for (const CapKernels& kernels : supported_cap_kernels()) {
                const std::vector<std::uint32_t> list(CapColumns::kStep, 1 - one);
                CapColumns caps;
                caps.resize(CapColumns::kStep);
                kernels.find_caps(data.atoms.centres.data(), data.rho.data(), std::span(list).first(1),
                                  data.atoms.centres[one], data.rho[one], 0, caps);
                EXPECT_EQ(caps[3][0] < 1.0, expected.t < 1.0) << kernels.instructions;
                if (expected.t < 1.0) {
                    EXPECT_EQ(caps[3][0], expected.t) << kernels.instructions;
                }
            }
        }
    }
    EXPECT_GT(meet, total / 10);
    EXPECT_LT(meet, total - total / 10);
}

TEST(NeighbourCaps, RimsLieOnBothSpheres) {
    const AccessibleSurface surface(two_spheres(3.0, 1.2, 2.1), kProbeRadius);
    const AccessibleSurface::Data& data = surface.data();
    const Cap cap = cap_between(data, 0, 1);
    const Vec3 direction = cap.t * cap.axis + std::sqrt(1.0 - cap.t * cap.t) * perpendicular(cap.axis);
    const Vec3 point = data.atoms.centres[0] + data.rho[0] * direction;
    EXPECT_NEAR(norm(point - data.atoms.centres[1]), data.rho[1], 1e-14);
}

TEST(NeighbourCaps, LeavesOutAtomsThatAreKnown) {
    const AccessibleSurface surface(random_cluster(2, 60, 8.0), kProbeRadius);
    const AccessibleSurface::Data& data = surface.data();
    const CellList cells(data.atoms);
    NeighbourCaps neighbours(data, cells);
    for (std::uint32_t i = 0; i < data.atoms.size(); ++i) {
        CapList all;
        if (!neighbours.gather(i, {}, all) || all.atoms.size() < 3) continue;
        const std::vector<std::uint32_t> known = {all.atoms[0], all.atoms[2]};
        CapList caps;
        for (const std::uint32_t j : known) caps.add(cap_between(data, i, j));
        ASSERT_TRUE(neighbours.gather(i, known, caps));
        EXPECT_EQ(caps.atoms.size(), all.atoms.size());
        EXPECT_EQ(atoms_of(caps), atoms_of(all));
    }
}

TEST(NeighbourCaps, TellsOfANeighbourThatCoversAll) {
    const AccessibleSurface surface(two_spheres(0.5, 1.0, 3.0), kProbeRadius);
    const AccessibleSurface::Data& data = surface.data();
    const CellList cells(data.atoms);
    NeighbourCaps neighbours(data, cells);
    const std::uint32_t small = data.rho[0] < data.rho[1] ? 0 : 1;
    CapList caps;
    EXPECT_FALSE(neighbours.gather(small, {}, caps));
    caps.clear();
    EXPECT_TRUE(neighbours.gather(1 - small, {}, caps));
    EXPECT_TRUE(caps.atoms.empty());
}

}  // namespace
}  // namespace meniscus::testing
