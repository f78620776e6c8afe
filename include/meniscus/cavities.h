// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Cavities that a mesh does without: dropped from it, or filled.
#pragma once

#include <cstddef>

#include "meniscus/mesh.h"

namespace meniscus {

/// What SurfaceOptions::min_cavity has dropped.
struct DroppedPieces {
    std::size_t cavities = 0;
    std::size_t islands = 0;  ///< outer pieces within these cavities
};

/// What SurfaceOptions::fill_cavities has filled.
struct FilledCavities {
    std::size_t cavities = 0;
    std::size_t islands = 0;  ///< outer pieces within these cavities
    double volume = 0.0;      ///< Å³ between the cavities' walls and the islands in them
    Mesh walls;               ///< of the cavities, and of the islands in them; triangles of the grid, with components
    Mesh rest;                ///< all other triangles of the grid; empty if nothing was filled
};

}  // namespace meniscus
