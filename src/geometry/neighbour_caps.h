// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The caps that the neighbours of an atom bury on its enlarged sphere.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/accessible_surface_data.h"
#include "geometry/cap_kernels.h"
#include "space/cell_list.h"

namespace meniscus {

/// The caps that atoms bury on a sphere, and whose they are.
struct CapList {
    CapColumns planes;
    std::vector<std::uint32_t> atoms;

    void clear();
    void add(const Cap& cap);
};

/// The cap that atom j buries on the enlarged sphere of atom i; t <= -1 if all of it, t >= 1 if nothing.
Cap cap_between(const AccessibleSurface::Data& data, std::uint32_t i, std::uint32_t j);

/// Finds the caps of one atom after the other. Atoms of a cell share a search of the cells around: ask for them one
/// after the other, as they are numbered.
class NeighbourCaps {
public:
    /// Keeps references to both.
    NeighbourCaps(const AccessibleSurface::Data& data, const CellList& cells) : data_(data), cells_(cells) {}

    /// Appends the caps that neighbours bury on atom i, but those of `known` atoms.
    ///
    /// returns  false if one neighbour covers all of the atom: then some caps are missing
    /// cost     O(atoms of the cells around)
    bool gather(std::uint32_t i, std::span<const std::uint32_t> known, CapList& caps);

private:
    // Atoms that the candidates are complete for, and where these begin among the candidates.
    struct Searched {
        std::uint32_t begin = 0;
        std::uint32_t end = 0;
        std::size_t place = 0;
    };

    void search_around(std::uint32_t i);
    void find_neighbours(std::uint32_t i, std::span<const std::uint32_t> known);

    const AccessibleSurface::Data& data_;
    const CellList& cells_;
    Searched searched_;
    std::vector<std::uint32_t> candidates_;
    SmallBallColumns balls_;                 // of candidates_, from the first of these atoms on
    std::vector<std::uint64_t> marks_;       // of candidates_: those that meet the atom asked for, and few others
    std::vector<std::uint32_t> neighbours_;  // these atoms
};

}  // namespace meniscus
