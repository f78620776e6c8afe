// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What surrounds pockets: walls of atoms, mouths to the bulk, openings to other pocket space.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meniscus/measures.h"
#include "meniscus/mesh.h"
#include "meniscus/pockets.h"
#include "pockets/pocket_space.h"

namespace meniscus {

/// Which pocket each voxel belongs to, kNone for the rest of pocket space, and how many pockets there are.
struct PocketLabels {
    std::span<const std::uint32_t> of_voxel;
    std::size_t count = 0;
};

/// For each pocket, the atoms whose exact areas line it. Triangles tell how an atom's area is divided among pockets.
///
/// mesh       of the SES of the small probe
/// measures   exact, of that surface
std::vector<std::vector<WallAtom>> walls(const PocketSpace& space, const PocketLabels& labels, const Mesh& mesh,
                                         const Measures& measures);

/// For each pocket, the connected parts of the free surface of the large probe that cover it, largest first. Their
/// areas are scaled so that the parts of all pockets, and of the rest, add up to the exact area.
///
/// mesh       of the SES of the large probe
/// exact_area the exact area of its toroidal and reentrant patches, Å²
std::vector<std::vector<PocketMouth>> mouths(const PocketSpace& space, const PocketLabels& labels, const Mesh& mesh,
                                             double exact_area);

/// For each pocket, the connected parts of its border to other pocket space, largest first.
std::vector<std::vector<PocketMouth>> openings(const PocketSpace& space, const PocketLabels& labels);

}  // namespace meniscus
