// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Clearance: how large a ball may be whose centre is at a point, before it touches an atom.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "meniscus/atoms.h"
#include "meniscus/vec3.h"
#include "space/box_tree.h"
#include "space/canonical_atoms.h"

namespace meniscus {

inline constexpr double kClearanceRounding = 1e-12;  ///< Å: how much clearances that are equal may differ

/// The clearance of a point is its smallest distance from an atom's centre less the atom's radius, negative within
/// atoms. Atoms are numbered in their canonical order.
class Clearance {
public:
    /// throws   as canonical_atoms()
    explicit Clearance(const Atoms& atoms);

    const CanonicalAtoms& atoms() const { return atoms_; }
    const Box& box_of_centres() const { return box_; }

    double of_atom(std::uint32_t atom, const Vec3& point) const {
        return norm(point - atoms_.centres[atom]) - atoms_.radii[atom];
    }
    double at(const Vec3& point) const;
    /// The least clearance of a segment's points: the distances of a segment from atoms are known in closed form.
    double along(const Vec3& begin, const Vec3& end) const { return along(begin, end, std::min(at(begin), at(end))); }
    /// The same where the least clearance of both ends is known.
    double along(const Vec3& begin, const Vec3& end, double of_ends) const;

    /// Puts the atoms whose own clearance at a point is at most `most` into a list, in the order of their numbers.
    void list_atoms(const Vec3& point, double most, std::vector<std::uint32_t>& list) const;

private:
    CanonicalAtoms atoms_;
    Box box_;
    BoxTree tree_;  // of the balls
};

}  // namespace meniscus
