// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "space/cell_list.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "support/arrangements.h"

namespace meniscus::testing {
namespace {

// Every atom within `reach` must be visited, and none twice.
void expect_brute_force_neighbours(const CanonicalAtoms& atoms, const std::vector<Vec3>& points, double reach) {
    const CellList cells(atoms);
    for (const Vec3& p : points) {
        std::multiset<std::uint32_t> visited;
        cells.for_each_cell_near({p, p}, reach, [&](std::uint32_t begin, std::uint32_t end) {
            for (std::uint32_t j = begin; j < end; ++j) visited.insert(j);
        });
        for (std::uint32_t j = 0; j < atoms.size(); ++j) {
            EXPECT_LE(visited.count(j), 1U);
            if (norm(atoms.centres[j] - p) <= reach) {
                EXPECT_EQ(visited.count(j), 1U);
            }
        }
    }
}

TEST(CellList, FindsEveryNeighbour) {
    const Atoms atoms = random_cluster(1, 400, 30.0);
    for (const double cell : {0.7, 3.0, 50.0}) {
        const CanonicalAtoms sorted = canonical_atoms(atoms, cell);
        for (const double reach : {0.0, 2.5, 8.0})
            expect_brute_force_neighbours(sorted, random_points_around(atoms, 100, 0.0), reach);
    }
}

TEST(CellList, VisitsOnlyCellsWithinReach) {
    const Atoms atoms = random_cluster(5, 400, 30.0);
    const CanonicalAtoms sorted = canonical_atoms(atoms, 3.0);
    const CellList cells(sorted);
    for (const Vec3& p : random_points_around(atoms, 100, 0.0))
        cells.for_each_cell_near({p, p}, 2.0, [&](std::uint32_t begin, std::uint32_t end) {
            for (const Vec3& centre : std::span(sorted.centres).subspan(begin, end - begin)) {
                const Vec3 d = centre - p;
                EXPECT_LE(std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}), 2.0 + sorted.cell);
            }
        });
}

TEST(CellList, FindsAtomsFromTheirOwnCentres) {
    const CanonicalAtoms lattice = canonical_atoms(cubic_lattice(6, 3.0, 1.5), 3.0);
    expect_brute_force_neighbours(lattice, lattice.centres, 3.0);
}

TEST(CellList, AnswersForPointsOutsideTheBoundingBox) {
    const Atoms atoms = random_cluster(2, 100, 10.0);
    const CanonicalAtoms sorted = canonical_atoms(atoms, 3.0);
    expect_brute_force_neighbours(sorted, random_points_around(atoms, 300, 12.0), 6.0);
}

TEST(CellList, ServesClustersFarApart) {
    Atoms atoms = random_cluster(3, 40, 8.0);
    const Atoms more = random_cluster(4, 40, 8.0);
    for (std::size_t i = 0; i < more.size(); ++i) {
        atoms.centres.push_back(more.centres[i] + Vec3{1e9, -1e9, 3e8});
        atoms.radii.push_back(more.radii[i]);
    }
    const CanonicalAtoms sorted = canonical_atoms(atoms, 6.0);
    expect_brute_force_neighbours(sorted, sorted.centres, 6.0);
}

TEST(CellList, HoldsASingleAtom) {
    const CanonicalAtoms one = canonical_atoms({{{-5, 4, 1e6}}, {1.5}}, 6.0);
    expect_brute_force_neighbours(one, {{-5, 4, 1e6}, {-4, 4, 1e6}, {-20, 4, 1e6}}, 2.0);
}

}  // namespace
}  // namespace meniscus::testing
