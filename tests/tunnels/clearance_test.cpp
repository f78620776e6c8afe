// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "tunnels/clearance.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tunnels/drilled_block.h"

namespace meniscus {
namespace {

double brute_force(const Atoms& atoms, const Vec3& point) {
    double best = 1e300;
    for (std::size_t i = 0; i < atoms.size(); ++i)
        best = std::min(best, norm(point - atoms.centres[i]) - atoms.radii[i]);
    return best;
}

TEST(Clearance, IsTheLeastOverAllAtomsInsideAndOutside) {
    const Atoms atoms = testing::random_beads(3, 200, 20.0);
    const Clearance clearance(atoms);
    for (double x = -6.0; x < 26.0; x += 1.7)
        for (double y = -6.0; y < 26.0; y += 1.9)
            for (double z = -6.0; z < 26.0; z += 2.1) {
                const Vec3 p{x, y, z};
                EXPECT_DOUBLE_EQ(clearance.at(p), brute_force(atoms, p));
            }
}

TEST(Clearance, AlongASegmentIsThatOfItsWorstPoint) {
    const Atoms atoms = testing::random_beads(5, 100, 16.0);
    const Clearance clearance(atoms);
    for (int i = 0; i < 50; ++i) {
        const Vec3 begin{0.31 * i, 16.0 - 0.2 * i, 0.17 * i};
        const Vec3 end{16.0 - 0.25 * i, 0.3 * i, 8.0};
        double sampled = 1e300;
        for (int k = 0; k <= 1000; ++k)
            sampled = std::min(sampled, brute_force(atoms, begin + (k / 1000.0) * (end - begin)));
        EXPECT_LE(clearance.along(begin, end), sampled + 1e-12);
        EXPECT_GE(clearance.along(begin, end), sampled - 1e-3 * norm(end - begin));
    }
}

TEST(Clearance, ListsTheAtomsUpToALimit) {
    const Atoms atoms = testing::random_beads(7, 150, 18.0);
    const Clearance clearance(atoms);
    const Vec3 point{9.0, 8.0, 7.0};
    std::vector<std::uint32_t> list;
    for (const double most : {-0.5, 0.0, 1.0, 4.0}) {
        clearance.list_atoms(point, most, list);
        std::size_t expected = 0;
        for (std::size_t i = 0; i < atoms.size(); ++i)
            expected += static_cast<std::size_t>(norm(point - atoms.centres[i]) - atoms.radii[i] <= most);
        EXPECT_EQ(list.size(), expected);
        EXPECT_TRUE(std::is_sorted(list.begin(), list.end()));
    }
}

}  // namespace
}  // namespace meniscus
