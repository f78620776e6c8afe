// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pockets/lattice_average.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <vector>

namespace meniscus::testing {
namespace {

// Voxels at random nodes of some blocks, one of them far away.
PocketSpace random_space(double spacing) {
    PocketSpace space{
        BlockGrid(spacing, {1.0, -2.0, 3.0}, {{0, 0, 0}, {0, 0, 1}, {0, 1, 0}, {1, 0, 0}, {2, 2, 2}, {9, 9, 9}}),
        {},
        {},
        {},
        {},
        {}};
    space.voxel_of.assign(space.grid.node_count(), kNoVoxel);
    std::mt19937 random(1);
    for (std::uint32_t node = 0; node < space.grid.node_count(); ++node) {
        if (random() % 3 != 0) continue;
        space.voxel_of[node] = static_cast<VoxelId>(space.nodes.size());
        space.nodes.push_back(node);
    }
    return space;
}

double weight(double steps, double sigma, double spacing) {
    const double s = sigma / spacing;
    const int reach = static_cast<int>(3.0 * s + 0.5);
    double sum = 0.0;
    for (int k = -reach; k <= reach; ++k) sum += std::exp(-k * k / (2.0 * s * s));
    return std::abs(steps) > reach + 0.25 ? 0.0 : std::exp(-steps * steps / (2.0 * s * s)) / sum;
}

TEST(LatticeAverage, IsTheSumOverAllVoxels) {
    for (const double spacing : {1.0, 0.5}) {
        const PocketSpace space = random_space(spacing);
        std::vector<double> values(space.size());
        for (std::size_t i = 0; i < values.size(); ++i) values[i] = std::sin(static_cast<double>(i));
        for (const double sigma : {1.5, 5.0}) {
            const std::vector<double> averages = gaussian_average(space, values, sigma);
            for (VoxelId v = 0; v < space.size(); v += 101) {
                double sum = 0.0;
                for (VoxelId w = 0; w < space.size(); ++w) {
                    const Vec3 d = (1.0 / spacing) * (space.position(w) - space.position(v));
                    sum += values[w] * weight(d.x, sigma, spacing) * weight(d.y, sigma, spacing) *
                           weight(d.z, sigma, spacing);
                }
                EXPECT_NEAR(averages[v], sum, 1e-12);
            }
        }
    }
}

}  // namespace
}  // namespace meniscus::testing
