// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "space/cell_list.h"

#include <algorithm>
#include <bit>

namespace meniscus {

CellList::CellList(const CanonicalAtoms& atoms) : atoms_(&atoms) {
    std::vector<Cell> cells;
    for (std::uint32_t i = 0; i < atoms.size(); ++i) {
        if (cells.empty() || cells.back().key != atoms.cell_keys[i]) cells.push_back({atoms.cell_keys[i], i, i});
        cells.back().end = i + 1;
    }
    table_.assign(std::bit_ceil(2 * cells.size() + 1), Cell{0, 0, 0});
    for (const Cell& cell : cells) {
        std::size_t slot = slot_of(cell.key);
        while (table_[slot].end != 0) slot = (slot + 1) & (table_.size() - 1);
        table_[slot] = cell;
    }
}

CellList::Range CellList::cells(double low, double high) const {
    constexpr double kLastCell = (1 << 21) - 1;
    const auto index = [&](double at) {
        return static_cast<std::uint32_t>(std::clamp(at / atoms_->cell, 0.0, kLastCell));
    };
    return {index(low), index(high)};
}

}  // namespace meniscus
