// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Cavities that are left out of a mesh: dropped, or filled.
#pragma once

#include <cstddef>

#include "meniscus/mesh.h"

namespace meniscus {

/// Numbers of the pieces that SurfaceOptions::min_cavity has dropped.
struct DroppedPieces {
    std::size_t cavities = 0;
    std::size_t islands = 0;  ///< outer pieces within these cavities
};

/// The cavities that SurfaceOptions::fill_cavities has filled.
struct FilledCavities {
    std::size_t cavities = 0;
    std::size_t islands = 0;  ///< outer pieces within these cavities
    double volume = 0.0;      ///< Å³ between the walls of the cavities and the islands in them
    Mesh walls;               ///< walls of the cavities and their islands, as triangles of the grid, with components
    Mesh rest;                ///< all other triangles of the grid; empty if nothing was filled
};

}  // namespace meniscus
