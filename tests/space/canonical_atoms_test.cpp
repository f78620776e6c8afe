// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "space/canonical_atoms.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>

#include "meniscus/errors.h"
#include "support/arrangements.h"

namespace meniscus::testing {
namespace {

void expect_sorted_with_cells(const CanonicalAtoms& atoms) {
    EXPECT_TRUE(std::is_sorted(atoms.cell_keys.begin(), atoms.cell_keys.end()));
    for (std::size_t i = 0; i < atoms.size(); ++i) {
        const Vec3 at = (1.0 / atoms.cell) * (atoms.centres[i] - atoms.corner);
        EXPECT_EQ(atoms.cell_keys[i], morton_key(static_cast<std::uint32_t>(at.x), static_cast<std::uint32_t>(at.y),
                                                 static_cast<std::uint32_t>(at.z)));
    }
}

TEST(CanonicalAtoms, DoNotDependOnTheOrderOfTheFile) {
    const Atoms atoms = random_cluster(1, 500, 40.0);
    const CanonicalAtoms first = canonical_atoms(atoms, 6.0);
    ASSERT_EQ(first.size(), 500U);
    for (std::uint64_t seed = 0; seed < 5; ++seed) {
        const Shuffled other = shuffled(atoms, seed);
        const CanonicalAtoms second = canonical_atoms(other.atoms, 6.0);
        EXPECT_EQ(first.centres, second.centres);
        EXPECT_EQ(first.radii, second.radii);
        EXPECT_EQ(first.cell_keys, second.cell_keys);
        for (std::size_t i = 0; i < first.size(); ++i) EXPECT_EQ(first.original[i], other.order[second.original[i]]);
    }
}

TEST(CanonicalAtoms, NameTheCallersAtoms) {
    const Atoms atoms = random_cluster(2, 100, 20.0);
    const CanonicalAtoms sorted = canonical_atoms(atoms, 4.0);
    std::set<std::uint32_t> seen(sorted.original.begin(), sorted.original.end());
    EXPECT_EQ(seen.size(), 100U);
    for (std::size_t i = 0; i < sorted.size(); ++i) {
        EXPECT_EQ(sorted.centres[i], atoms.centres[sorted.original[i]]);
        EXPECT_EQ(sorted.radii[i], atoms.radii[sorted.original[i]]);
    }
    expect_sorted_with_cells(sorted);
}

TEST(CanonicalAtoms, KeepTheFirstOfTheLargestOfOneCentre) {
    const CanonicalAtoms sorted = canonical_atoms(
        {{{5, 5, 5}, {0, 0, 0}, {5, 5, 5}, {0.0, -0.0, 0}, {0, 0, 0}, {5, 5, 5}}, {1, 2, 1, 2, 3, 1}}, 2.0);
    ASSERT_EQ(sorted.size(), 2U);
    EXPECT_EQ(sorted.original, (std::vector<std::uint32_t>{4, 0}));
    EXPECT_EQ(sorted.radii, (std::vector<double>{3, 1}));
}

TEST(CanonicalAtoms, EnlargeCellsForHugeExtents) {
    for (const double extent : {1e6, 1e9, 1e12}) {
        Atoms atoms = random_cluster(3, 50, 10.0);
        atoms.centres.push_back({extent, -extent, extent});
        atoms.radii.push_back(1.5);
        const CanonicalAtoms sorted = canonical_atoms(atoms, 6.0);
        EXPECT_EQ(sorted.size(), 51U);
        EXPECT_GE(sorted.cell * (1 << 21), extent);
        expect_sorted_with_cells(sorted);
    }
}

TEST(CanonicalAtoms, KeepTheAskedCellWhereItIsEnough) {
    EXPECT_EQ(canonical_atoms(random_cluster(4, 50, 100.0), 6.0).cell, 6.0);
}

TEST(CanonicalAtoms, RefuseWhatIsFartherThanTheLimit) {
    EXPECT_THROW(canonical_atoms({{{1e13, 0, 0}}, {1.5}}, 6.0), LimitError);
    EXPECT_THROW(canonical_atoms({{{0, 0, 0}}, {1e13}}, 6.0), LimitError);
}

TEST(CanonicalAtoms, RefuseWhatIsNotABall) {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    constexpr double kInfinity = std::numeric_limits<double>::infinity();
    EXPECT_THROW(canonical_atoms({}, 1.0), std::invalid_argument);
    EXPECT_THROW(canonical_atoms({{{0, 0, 0}}, {}}, 1.0), std::invalid_argument);
    for (const double radius : {0.0, -1.0, kNan, kInfinity})
        EXPECT_THROW(canonical_atoms({{{0, 0, 0}}, {radius}}, 1.0), std::invalid_argument);
    for (const double bad : {kNan, kInfinity, -kInfinity}) {
        EXPECT_THROW(canonical_atoms({{{bad, 0, 0}}, {1}}, 1.0), std::invalid_argument);
        EXPECT_THROW(canonical_atoms({{{0, bad, 0}}, {1}}, 1.0), std::invalid_argument);
        EXPECT_THROW(canonical_atoms({{{0, 0, bad}}, {1}}, 1.0), std::invalid_argument);
    }
}

TEST(CanonicalAtoms, ErrorNamesTheAtom) {
    try {
        canonical_atoms({{{0, 0, 0}, {1, 0, 0}}, {1.0, 0.0}}, 1.0);
        FAIL();
    } catch (const std::invalid_argument& error) {
        EXPECT_NE(std::string(error.what()).find("atom 1"), std::string::npos);
    }
}

TEST(MortonKey, InterleavesTheBits) {
    EXPECT_EQ(morton_key(0, 0, 0), 0U);
    EXPECT_EQ(morton_key(1, 0, 0), 1U);
    EXPECT_EQ(morton_key(0, 1, 0), 2U);
    EXPECT_EQ(morton_key(0, 0, 1), 4U);
    EXPECT_EQ(morton_key(2, 3, 1), 0b011110U);
    EXPECT_EQ(morton_key(0x1FFFFF, 0x1FFFFF, 0x1FFFFF), 0x7FFFFFFFFFFFFFFFULL);
}

TEST(SymmetryBreakingOffset, IsBetweenMinusOneAndOneAndSpread) {
    double low = 1.0;
    double high = -1.0;
    double sum = 0.0;
    constexpr int kCount = 10000;
    for (int i = 0; i < kCount; ++i) {
        const double offset = symmetry_breaking_offset({1.0 * i, 0.5 * i, 3.0}, 1.7, 0);
        low = std::min(low, offset);
        high = std::max(high, offset);
        sum += offset;
    }
    EXPECT_GE(low, -1.0);
    EXPECT_LE(high, 1.0);
    EXPECT_LT(low, -0.99);
    EXPECT_GT(high, 0.99);
    EXPECT_NEAR(sum / kCount, 0.0, 0.03);  // five standard deviations
}

TEST(SymmetryBreakingOffset, DependsOnTheAtomAndTheSeedOnly) {
    EXPECT_EQ(symmetry_breaking_offset({1, 2, 3}, 1.7, 4), symmetry_breaking_offset({1, 2, 3}, 1.7, 4));
    EXPECT_EQ(symmetry_breaking_offset({-0.0, 2, 3}, 1.7, 4), symmetry_breaking_offset({0.0, 2, 3}, 1.7, 4));
    EXPECT_NE(symmetry_breaking_offset({1, 2, 3}, 1.7, 4), symmetry_breaking_offset({1, 2, 3}, 1.7, 5));
    EXPECT_NE(symmetry_breaking_offset({1, 2, 3}, 1.7, 4), symmetry_breaking_offset({2, 1, 3}, 1.7, 4));
    EXPECT_NE(symmetry_breaking_offset({1, 2, 3}, 1.7, 4), symmetry_breaking_offset({1, 2, 3}, 1.8, 4));
}

}  // namespace
}  // namespace meniscus::testing
