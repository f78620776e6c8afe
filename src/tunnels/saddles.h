// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Saddles of clearance: the gates between three atoms, through one of which every widest path has its narrowest place.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "meniscus/vec3.h"
#include "tunnels/clearance.h"

namespace meniscus {

/// A ball that touches three atoms, with its centre in the plane of theirs and within their triangle, and no other.
struct Saddle {
    std::array<std::uint32_t, 3> atoms{};  ///< canonical numbers, rising
    Vec3 position;
    Vec3 normal;          ///< of the plane; clearance rises in both directions
    double radius = 0.0;  ///< Å
};

/// The balls outside three balls that touch all of them and have their centres in the plane of theirs, within the
/// triangle: none, one, or two where the radii differ much. No other atom is looked at.
std::vector<Saddle> tangent_balls(const std::array<Vec3, 3>& centres, const std::array<double, 3>& radii);

/// Where and how saddles are looked for.
struct SaddleSearch {
    Box box;                  ///< where their positions are
    double min_radius = 0.5;  ///< Å, of the balls
    double cube = 4.0;        ///< Å: edge of the cubes that the search begins with; does not change the result
};

/// All saddles, by their atoms. None is missing: cubes are divided until either no ball can be in a cube or few atoms
/// can touch one there, and then all triples of these are tried. Of saddles at the same place in the same plane, as
/// those of a ring of many atoms, there is one.
///
/// cost     some 20 µs per atom of a protein, parallel
std::vector<Saddle> find_saddles(const Clearance& clearance, const SaddleSearch& search);

}  // namespace meniscus
