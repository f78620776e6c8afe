// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How wide the narrow band of a computation is, and how large it may become.
#pragma once

#include <cstddef>

#include "meniscus/surface.h"

namespace meniscus {

/// Nodes of a cell that the surface cuts are within its diagonal, the root of three spacings.
inline constexpr double kCutCell = 1.8;  // spacings

/// How far the band reaches on both sides of the surface, Å.
double band_margin(const SurfaceOptions& options);

/// The number of blocks that memory has room for.
std::size_t block_limit(const SurfaceOptions& options, std::size_t memory_limit_mb);

}  // namespace meniscus
