// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Where a mesh passes through itself.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// A triangle that others are held against.
class HeldTriangle {
public:
    /// By the numbers and the places of its corners.
    HeldTriangle(const Triangle& corners, const std::array<Vec3, 3>& at);
    HeldTriangle(const Mesh& mesh, const Triangle& corners);

    /// Where another meets it and should not, Å: without a shared vertex, or with one and beyond it. Triangles that
    /// only touch, that lie in one plane or share an edge do not.
    std::optional<Vec3> meeting(const Triangle& other, const std::array<Vec3, 3>& at) const;
    /// The same of another of a mesh.
    std::optional<Vec3> meeting(const Mesh& mesh, const Triangle& other) const;

private:
    // With one that shares no edge.
    std::optional<Vec3> place_of_meeting(const Triangle& other, const std::array<Vec3, 3>& at) const;

    Triangle corners_;
    std::array<Vec3, 3> at_;
    Vec3 normal_;  // as long as twice the area
};

/// A point for every pair of triangles that meet where they should not.
///
/// cost     O(n log n), parallel over triangles
std::vector<Vec3> places_of_self_intersections(const Mesh& mesh);

/// The triangles of these pairs, rising.
std::vector<std::uint32_t> self_intersecting_triangles(const Mesh& mesh);

}  // namespace meniscus
