// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/gaussian_density.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parallel.h"
#include "meniscus/errors.h"
#include "meniscus/threads.h"
#include "support/arrangements.h"
#include "support/sampled_field.h"

namespace meniscus::testing {
namespace {

constexpr std::size_t kNoLimit = 1'000'000;

// Φ0 from its definition; the largest term is factored out.
double by_hand(const Atoms& atoms, double c, const Vec3& p) {
    const auto exponent = [&](std::size_t i) {
        return c * (squared_norm(p - atoms.centres[i]) - atoms.radii[i] * atoms.radii[i]);
    };
    double largest = exponent(0);
    for (std::size_t i = 1; i < atoms.size(); ++i) largest = std::max(largest, exponent(i));
    double sum = 0.0;
    for (std::size_t i = 0; i < atoms.size(); ++i) sum += std::exp(exponent(i) - largest);
    const double mean =
        std::accumulate(atoms.radii.begin(), atoms.radii.end(), 0.0) / static_cast<double>(atoms.size());
    return (largest + std::log(sum)) / (2.0 * c * mean);
}

// The paper's G, whose zero set is the start.
double density(const Atoms& atoms, double c, const Vec3& p) {
    double sum = -1.0;
    for (std::size_t i = 0; i < atoms.size(); ++i)
        sum += std::exp(c * (squared_norm(p - atoms.centres[i]) - atoms.radii[i] * atoms.radii[i]));
    return sum;
}

struct Sampled {
    Sampled(Atoms the_atoms, double c, double h, double band_margin)
        : atoms(std::move(the_atoms)), surface(atoms, 1.4), margin(band_margin), lattice{.spacing = h, .origin = {}} {
        const GaussianDensity gaussian(surface, c);
        grid = BlockGrid(h, {}, gaussian.blocks_near_surface(lattice, margin, kNoLimit));
        values = gaussian.sample(grid, margin);
    }
    Vec3 position(std::size_t n) const {
        const int node = static_cast<int>(n % kBlockNodes);
        return node_position(grid, static_cast<BlockId>(n / kBlockNodes), node % 8, node / 8 % 8, node / 64);
    }

    Atoms atoms;
    AccessibleSurface surface;
    double margin;
    Lattice lattice;
    BlockGrid grid{1.0, {}, {}};
    NodeField values;
};

// Against the definition wherever |Φ0| < near; clamped elsewhere.
void expect_by_hand(const Sampled& sampled, double c, double near, double tolerance) {
    std::size_t compared = 0;
    for (std::size_t n = 0; n < sampled.values.size(); ++n) {
        ASSERT_LE(std::abs(double{sampled.values[n]}), sampled.margin * (1.0 + 1e-6));  // and not NaN
        const double expected = by_hand(sampled.atoms, c, sampled.position(n));
        if (std::abs(expected) >= near) continue;
        ASSERT_NEAR(sampled.values[n], expected, tolerance);
        ++compared;
    }
    EXPECT_GT(compared, 100U);
}

// Signs agree with G; every cell of the lattice in which G changes sign lies in listed blocks.
void expect_sign_changes_listed(const Sampled& sampled, double c, double extent) {
    const double h = sampled.lattice.spacing;
    const int last = static_cast<int>(std::ceil(extent / h));
    const auto listed = [&](const Vec3& p) { return sampled.grid.find(sampled.lattice.block_of(p)) != kNoBlock; };
    for (int z = -last; z <= last; ++z)
        for (int y = -last; y <= last; ++y)
            for (int x = -last; x <= last; ++x) {
                const Vec3 p = h * Vec3{1.0 * x, 1.0 * y, 1.0 * z};
                const bool inside = density(sampled.atoms, c, p) > 0.0;
                for (const Vec3 step : {Vec3{h, 0, 0}, Vec3{0, h, 0}, Vec3{0, 0, h}})
                    if (inside != (density(sampled.atoms, c, p + step) > 0.0)) {
                        ASSERT_TRUE(listed(p + 1e-9 * Vec3{1, 1, 1}));
                        ASSERT_TRUE(listed(p + step + 1e-9 * Vec3{1, 1, 1}));
                    }
            }
}

TEST(GaussianDensity, OfOneAtomIsAParabolaWithSlopeOne) {
    const Vec3 centre{0.1, 0.2, 0.3};
    const double r = 1.7;
    for (const double c : {-4.0, -1.0, -0.2}) {
        const Sampled sampled({{centre}, {r}}, c, 0.25, 0.8);
        for (std::size_t n = 0; n < sampled.values.size(); ++n) {
            const double parabola = (squared_norm(sampled.position(n) - centre) - r * r) / (2.0 * r);
            ASSERT_NEAR(sampled.values[n], std::clamp(parabola, -0.8, 0.8), 1e-5);
        }
    }
}

TEST(GaussianDensity, OfTwoAtomsIsItsDefinition) {
    for (const double c : {-4.0, -1.0, -0.2}) expect_by_hand({two_spheres(2.5, 1.7, 1.5), c, 0.25, 0.7}, c, 0.7, 2e-4);
}

TEST(GaussianDensity, OfAClusterIsItsDefinitionNearItsZeroSet) {
    for (const double c : {-4.0, -1.0, -0.2}) {
        const Atoms atoms = random_cluster(1, 60, 10.0);
        expect_by_hand({atoms, c, 0.5, 2.5}, c, 0.3, 2e-3);
    }
}

TEST(GaussianDensity, IsNegativeWhereThePapersDensityIsPositive) {
    for (const double c : {-4.0, -0.2}) {
        const Sampled sampled(random_cluster(2, 20, 6.0), c, 0.5, 2.5);
        for (std::size_t n = 0; n < sampled.values.size(); ++n) {
            const double g = density(sampled.atoms, c, sampled.position(n));
            if (std::abs(g) > 1e-3) {
                ASSERT_EQ(sampled.values[n]<0.0F, g> 0.0);
            }
        }
    }
}

TEST(GaussianDensity, ListsEveryCellWhereItsSignChanges) {
    for (const double c : {-4.0, -1.0, -0.2}) {
        expect_sign_changes_listed({two_spheres(2.5, 1.7, 1.5), c, 0.4, 0.4}, c, 6.0);
        expect_sign_changes_listed({octahedron(3.5, 1.7), c, 0.5, 0.1}, c, 8.0);
        expect_sign_changes_listed({hollow_shell(60, 5.0, 1.6), c, 0.5, 0.5}, c, 10.0);
    }
}

// The surface crosses x = 3.75, between the last nodes of one block and the first of the next.
TEST(GaussianDensity, ListsBothBlocksWhereItsSignChangesBetweenThem) {
    expect_sign_changes_listed({{{{0, 0, 0}}, {3.75}}, -1.0, 0.5, 1e-3}, -1.0, 5.0);
}

TEST(GaussianDensity, TakesHugeAndTinyAtomsTogether) {
    const Atoms atoms{{{0, 0, 0}, {101, 0, 0}, {0, 100, 0}}, {100.0, 0.01, 2.0}};
    for (const double c : {-4.0, -0.2}) {
        const AccessibleSurface surface(atoms, 1.4);
        const GaussianDensity gaussian(surface, c);
        const Lattice lattice{.spacing = 2.0, .origin = {}};
        const BlockGrid grid(2.0, {}, gaussian.blocks_near_surface(lattice, 10.0, kNoLimit));
        EXPECT_GT(grid.block_count(), 0U);
        for (const float v : gaussian.sample(grid, 10.0)) ASSERT_LE(std::abs(v), 10.0F);
        EXPECT_NE(grid.find(lattice.block_of({0, 0, 99.9})), kNoBlock);
    }
}

TEST(GaussianDensity, IsOutsideFarFromEveryAtom) {
    const AccessibleSurface surface(two_spheres(3.0), 1.4);
    const BlockGrid grid(0.5, {}, {{.z = 500, .y = 0, .x = 0}});
    for (const float v : GaussianDensity(surface, -1.0).sample(grid, 2.0)) EXPECT_EQ(v, 2.0F);
}

TEST(GaussianDensity, KeepsItsBitsForAnyNumberOfThreadsAndOrderOfAtoms) {
    const Atoms atoms = random_cluster(3, 200, 16.0);
    const Sampled two(atoms, -1.0, 0.5, 2.5);
    const ThreadLimit limit(1);
    const Sampled one(shuffled(atoms, 4).atoms, -1.0, 0.5, 2.5);
    EXPECT_TRUE(std::equal(one.grid.coords().begin(), one.grid.coords().end(), two.grid.coords().begin(),
                           two.grid.coords().end()));
    EXPECT_EQ(one.values, two.values);
}

TEST(GaussianDensity, RefusesMoreBlocksThanTheLimit) {
    const AccessibleSurface surface(random_cluster(4, 100, 15.0), 1.4);
    const GaussianDensity gaussian(surface, -1.0);
    const Lattice lattice{.spacing = 0.25, .origin = {}};
    const std::size_t count = gaussian.blocks_near_surface(lattice, 1.0, kNoLimit).size();
    EXPECT_EQ(gaussian.blocks_near_surface(lattice, 1.0, count).size(), count);
    EXPECT_THROW(gaussian.blocks_near_surface(lattice, 1.0, count - 1), LimitError);
    EXPECT_THROW(gaussian.blocks_near_surface({.spacing = 1e-4, .origin = {}}, 1e-3, 1000), LimitError);
}

}  // namespace
}  // namespace meniscus::testing
