// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The space of cavities that are filled: where a surface with its cavities says outside, and inside is meant.
#pragma once

#include <vector>

#include "meniscus/cavities.h"
#include "space/box_tree.h"
#include "space/triangle_tree.h"

namespace meniscus {

class FilledSpace {
public:
    /// Keeps a reference to the cavities.
    ///
    /// spacing   of the grid that their walls are made on, Å
    FilledSpace(const FilledCavities& filled, double spacing);

    bool empty() const { return boxes_.empty(); }

    /// Whether a point lies within the wall of a filled cavity.
    /// cost     that of its triangles where the point lies in its box
    bool contains(const Vec3& point) const;

    /// The signed distance to what is left of the surface, from that to the surface with all its cavities.
    double distance(const Vec3& point, double with_cavities) const;

private:
    bool surrounds(std::size_t piece, const Vec3& point) const;

    const FilledCavities& filled_;
    double spacing_;
    TriangleTree walls_;
    TriangleTree rest_;
    std::vector<Box> boxes_;                             // per piece
    std::vector<std::vector<std::uint32_t>> triangles_;  // the same
};

}  // namespace meniscus
