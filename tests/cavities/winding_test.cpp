// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "cavities/winding.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace meniscus {
namespace {

// Corners at round coordinates: rays meet edges and vertices.
Mesh solid_cube(double half) {
    Mesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.push_back({i % 2 == 0 ? -half : half, i / 2 % 2 == 0 ? -half : half, i / 4 == 0 ? -half : half});
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

void add(Mesh& mesh, const Mesh& other, bool turned) {
    const auto first = static_cast<VertexId>(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& [a, b, c] : other.triangles)
        mesh.triangles.push_back({a + first, (turned ? c : b) + first, (turned ? b : c) + first});
}

TEST(WindingNumbers, TellInsideFromOutside) {
    const std::vector<Vec3> points{{0, 0, 0}, {0.5, 0.5, 0.9}, {0, 0, 1.1},      {0, 0, -3},
                                   {2, 0, 0}, {0.25, 0.5, 0},  {-0.5, 0.5, -0.5}};
    EXPECT_EQ(winding_numbers(solid_cube(1.0), points), (std::vector<int>{1, 1, 0, 0, 0, 1, 1}));
}

TEST(WindingNumbers, OfAWallWithinAWall) {
    Mesh hollow = solid_cube(2.0);
    add(hollow, solid_cube(1.0), true);
    const std::vector<Vec3> points{{0, 0, 0}, {0, 0, 1.5}, {1.5, 1.5, 0}, {3, 0, 0}};
    EXPECT_EQ(winding_numbers(hollow, points), (std::vector<int>{0, 1, 1, 0}));
}

TEST(WindingNumbers, OfThousandsOfPoints) {
    Mesh hollow = solid_cube(2.0);
    add(hollow, solid_cube(1.0), true);
    std::vector<Vec3> points;
    std::vector<int> expected;
    for (double z = -2.25; z < 2.5; z += 0.25)
        for (double y = -2.25; y < 2.5; y += 0.25)
            for (double x = -2.25; x < 2.5; x += 0.25) {
                const double farthest = std::max({std::abs(x), std::abs(y), std::abs(z)});
                if (farthest == 1.0 || farthest == 2.0) continue;  // on a wall
                points.push_back({x, y, z});
                expected.push_back(farthest > 1.0 && farthest < 2.0 ? 1 : 0);
            }
    EXPECT_EQ(winding_numbers(hollow, points), expected);
}

TEST(WindingNumbers, OfNothing) {
    EXPECT_EQ(winding_numbers(Mesh{}, std::vector<Vec3>{{0, 0, 0}}), std::vector<int>{0});
    EXPECT_TRUE(winding_numbers(solid_cube(1.0), {}).empty());
}

}  // namespace
}  // namespace meniscus
