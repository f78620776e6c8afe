// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The 256 ways in which a surface can cut a cube of eight nodes: triangles between the cube's edges.
//
// Corners: number x + 2 y + 4 z for x, y, z in {0, 1}. Edges: number 4 d + k, where d is the direction (0 x, 1 y,
// 2 z) and k counts the four corners whose coordinate along d is 0, in rising order. A case is the set of inside
// corners as bits.
#pragma once

#include <array>
#include <cstdint>

namespace meniscus {

inline constexpr int kCellCorners = 8;
inline constexpr int kCellEdges = 12;
inline constexpr int kMaxCellTriangles = 5;

/// The end of an edge that is nearer to corner 0.
constexpr int edge_base_corner(int edge) {
    constexpr std::array<std::int8_t, kCellEdges> kBase{0, 2, 4, 6, 0, 1, 4, 5, 0, 1, 2, 3};
    return kBase[static_cast<std::size_t>(edge)];
}

/// 0, 1, 2 for an edge along x, y, z.
constexpr int edge_direction(int edge) { return edge / 4; }

/// Triangles of one case: edge numbers, counter-clockwise seen from the outside corners.
struct CellCase {
    std::uint8_t count = 0;
    std::array<std::array<std::uint8_t, 3>, kMaxCellTriangles> triangles{};
};

/// All cases, by set of inside corners.
///
/// Every cut edge of the cube is a vertex of exactly one loop; a loop runs over the faces of the cube. On a face with
/// four cut edges each inside corner is cut off on its own: the rule sees nothing but the face, so both cells of a face
/// draw the same segments, in opposite directions. No triangle has a side across a face other than these segments, so
/// two cells never share a side by accident: cells glued face to face make an oriented 2-manifold for any signs.
extern const std::array<CellCase, 256> kCellCases;

}  // namespace meniscus
