// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Sparse cell list: finds the atoms near a point without allocating the bounding box.
#pragma once

#include <cstdint>
#include <vector>

#include "space/box_tree.h"
#include "space/canonical_atoms.h"

namespace meniscus {

class CellList {
public:
    /// Keeps a reference to `atoms`, whose order already groups atoms of the same cell.
    explicit CellList(const CanonicalAtoms& atoms);

    /// Calls visit(begin, end) for the atoms of each cell that is within `reach` (Å) of a box along each axis.
    template <class Visit>
    void for_each_cell_near(const Box& box, double reach, const Visit& visit) const {
        const Vec3 low = box.low - atoms_->corner;
        const Vec3 high = box.high - atoms_->corner;
        const Range x = cells(low.x - reach, high.x + reach);
        const Range y = cells(low.y - reach, high.y + reach);
        const Range z = cells(low.z - reach, high.z + reach);
        for (std::uint32_t k = z.first; k <= z.last; ++k)
            for (std::uint32_t j = y.first; j <= y.last; ++j)
                for (std::uint32_t i = x.first; i <= x.last; ++i) visit_cell(morton_key(i, j, k), visit);
    }

private:
    struct Range {
        std::uint32_t first;
        std::uint32_t last;
    };
    struct Cell {
        std::uint64_t key;
        std::uint32_t begin;
        std::uint32_t end;
    };

    Range cells(double low, double high) const;

    template <class Visit>
    void visit_cell(std::uint64_t key, const Visit& visit) const {
        for (std::size_t slot = slot_of(key); table_[slot].end != 0; slot = (slot + 1) & (table_.size() - 1))
            if (table_[slot].key == key) {
                visit(table_[slot].begin, table_[slot].end);
                return;
            }
    }

    std::size_t slot_of(std::uint64_t key) const {
        return static_cast<std::size_t>((key * 0x9E3779B97F4A7C15ULL) >> 20U) & (table_.size() - 1);
    }

    const CanonicalAtoms* atoms_;
    std::vector<Cell> table_;  // open addressing; end == 0 marks a free slot
};

}  // namespace meniscus
