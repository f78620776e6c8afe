// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/cell_cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace meniscus {
namespace {

using Side = std::pair<int, int>;  // from one edge of the cube to another

bool is_inside(int c, int corner) { return ((c >> corner) & 1) != 0; }

bool is_cut(int c, int edge) {
    const int base = edge_base_corner(edge);
    return is_inside(c, base) != is_inside(c, base + (1 << edge_direction(edge)));
}

// The face (2 axis + side) that holds both edges, or -1.
int common_face(int e, int f) {
    for (int axis = 0; axis < 3; ++axis) {
        const int side = edge_base_corner(e) >> axis & 1;
        if (axis != edge_direction(e) && axis != edge_direction(f) && side == (edge_base_corner(f) >> axis & 1))
            return 2 * axis + side;
    }
    return -1;
}

// The sides of triangles that no other triangle of the case runs along backwards.
std::set<Side> open_sides(int c) {
    std::set<Side> sides;
    const CellCase& cut = kCellCases[static_cast<std::size_t>(c)];
    for (std::size_t t = 0; t < cut.count; ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const Side side{cut.triangles[t][i], cut.triangles[t][(i + 1) % 3]};
            if (sides.erase({side.second, side.first}) > 0) continue;
            EXPECT_TRUE(sides.insert(side).second) << "case " << c;
        }
    return sides;
}

TEST(CellCases, CornersAndEdgesAgree) {
    std::set<std::pair<int, int>> ends;
    for (int e = 0; e < kCellEdges; ++e) {
        const int base = edge_base_corner(e);
        EXPECT_EQ(base & (1 << edge_direction(e)), 0);
        ends.insert({base, base | (1 << edge_direction(e))});
    }
    EXPECT_EQ(ends.size(), 12U);
}

TEST(CellCases, NothingWhereAllCornersAgree) {
    EXPECT_EQ(kCellCases[0].count, 0);
    EXPECT_EQ(kCellCases[255].count, 0);
}

TEST(CellCases, OneCornerGivesOneTriangleFacingAwayFromIt) {
    // Corner 0 inside, cut on the edges along x, y, z: counter-clockwise seen from (1, 1, 1).
    const CellCase& cut = kCellCases[1];
    ASSERT_EQ(cut.count, 1);
    auto triangle = cut.triangles[0];
    std::rotate(triangle.begin(), std::min_element(triangle.begin(), triangle.end()), triangle.end());
    EXPECT_EQ(triangle, (std::array<std::uint8_t, 3>{0, 4, 8}));
}

TEST(CellCases, TrianglesUseExactlyTheCutEdges) {
    for (int c = 0; c < 256; ++c) {
        std::set<int> used;
        const CellCase& cut = kCellCases[static_cast<std::size_t>(c)];
        for (std::size_t t = 0; t < cut.count; ++t) used.insert(cut.triangles[t].begin(), cut.triangles[t].end());
        for (int e = 0; e < kCellEdges; ++e) EXPECT_EQ(used.contains(e), is_cut(c, e)) << "case " << c << " edge " << e;
    }
}

TEST(CellCases, SidesOnFacesAreTheOpenOnesAndNoOthers) {
    for (int c = 0; c < 256; ++c) {
        const std::set<Side> open = open_sides(c);
        const CellCase& cut = kCellCases[static_cast<std::size_t>(c)];
        for (std::size_t t = 0; t < cut.count; ++t)
            for (std::size_t i = 0; i < 3; ++i) {
                const Side side{cut.triangles[t][i], cut.triangles[t][(i + 1) % 3]};
                EXPECT_EQ(common_face(side.first, side.second) >= 0, open.contains(side)) << "case " << c;
            }
    }
}

TEST(CellCases, OpenSidesFormLoopsThroughEveryCutEdgeOnce) {
    for (int c = 0; c < 256; ++c) {
        std::map<int, int> from;
        std::map<int, int> to;
        for (const auto& [e, f] : open_sides(c)) {
            ++from[e];
            ++to[f];
        }
        for (int e = 0; e < kCellEdges; ++e) {
            EXPECT_EQ(from[e], is_cut(c, e) ? 1 : 0) << "case " << c;
            EXPECT_EQ(to[e], is_cut(c, e) ? 1 : 0) << "case " << c;
        }
    }
}

// Open sides on one face, with edges named as the neighbour across that face names them.
std::set<Side> sides_on_face(int c, int face, bool as_neighbour) {
    const int axis = face / 2;
    const auto mirrored = [&](int e) {
        for (int f = 0; f < kCellEdges; ++f)
            if (edge_direction(f) == edge_direction(e) && edge_base_corner(f) == (edge_base_corner(e) ^ (1 << axis)))
                return f;
        return -1;
    };
    std::set<Side> sides;
    for (const auto& [e, f] : open_sides(c))
        if (common_face(e, f) == face) sides.insert(as_neighbour ? Side{mirrored(e), mirrored(f)} : Side{e, f});
    return sides;
}

TEST(CellCases, NeighboursDrawTheSameSegmentsInOppositeDirections) {
    for (int axis = 0; axis < 3; ++axis)
        for (int c = 0; c < 256; ++c)
            for (int d = 0; d < 256; ++d) {
                bool fit = true;  // corners of c on its upper face are those of d on its lower face
                for (int k = 0; k < kCellCorners; ++k)
                    if (((k >> axis) & 1) == 0) fit = fit && is_inside(d, k) == is_inside(c, k | (1 << axis));
                if (!fit) continue;
                std::set<Side> reversed;
                for (const auto& [e, f] : sides_on_face(d, 2 * axis, false)) reversed.insert({f, e});
                EXPECT_EQ(sides_on_face(c, 2 * axis + 1, true), reversed) << c << " next to " << d;
            }
}

TEST(CellCases, InsideCornersOnAnAmbiguousFaceAreCutOffOneByOne) {
    // Corners 0 and 3 of the face z = 0: two triangles that do not touch each other.
    EXPECT_EQ(kCellCases[0b1001].count, 2);
    EXPECT_EQ(open_sides(0b1001).size(), 6U);
    // The opposite signs: one loop through all six cut edges.
    EXPECT_EQ(kCellCases[0b11110110].count, 4);
}

}  // namespace
}  // namespace meniscus
