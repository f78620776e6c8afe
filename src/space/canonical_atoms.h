// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Atoms in one canonical spatial order, so that nothing later depends on the order of the file.
#pragma once

#include <cstdint>
#include <vector>

#include "meniscus/atoms.h"

namespace meniscus {

/// Atoms with distinct centres sorted along a space-filling curve of cells, ties by coordinates and radius.
struct CanonicalAtoms {
    std::vector<Vec3> centres;
    std::vector<double> radii;
    std::vector<std::uint32_t> original;   ///< index in the caller's order
    double cell = 0.0;                     ///< edge of the cells, Å
    Vec3 corner;                           ///< lower corner of cell (0, 0, 0)
    std::vector<std::uint64_t> cell_keys;  ///< of each atom, ascending

    std::size_t size() const { return centres.size(); }
};

/// Sorts, and keeps of atoms with exactly the same centre the one that holds the others: the largest, of equal ones the
/// first.
///
/// cell     edge of the sorting cells, Å; enlarged where the extent would need more than 2^20 of them
/// throws   std::invalid_argument for no atoms, a radius that is not positive and finite, a coordinate that
///          is not finite; LimitError for coordinates or radii beyond 1e12 Å
/// cost     O(n log n)
CanonicalAtoms canonical_atoms(const Atoms& atoms, double cell);

/// Morton key of the cell (x, y, z); 21 bits each.
std::uint64_t morton_key(std::uint32_t x, std::uint32_t y, std::uint32_t z);

/// Offset in [-1, 1] that depends only on the atom itself and `seed`: breaks ties between atoms.
double symmetry_breaking_offset(const Vec3& centre, double radius, std::uint64_t seed);

}  // namespace meniscus
