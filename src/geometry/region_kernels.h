// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The inner loops of SphericalRegions, arcs of a contour side by side, for several instruction sets, all of which give
// the same bits: vectors hold different arcs, whose numbers never meet.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/contour.h"

namespace meniscus {

/// An arc of a contour with its true angles.
struct MeasuredArc {
    double angle = 0.0;   ///< swept along the rim, radian
    double corner = 0.0;  ///< that the contour turns by at the start, radian; 0 for a whole rim
    Vec3 start;           ///< directions of its ends; equal for a whole rim
    Vec3 end;
    Vec3 area;                 ///< its part of the vector area of the region
    std::uint32_t region = 0;  ///< the region on its exposed side
};

struct RegionKernels {
    std::string_view instructions;  ///< "plain", "avx2" or "avx512"
    /// Sets the starts, as cross_rims has them, and the corners; without sense for whole rims.
    void (*find_corners)(std::span<const CapPlane> caps, std::span<const ContourArc> arcs,
                         std::span<MeasuredArc> measured);
    /// Sets the rest but for the regions. Every arc a ends where arc next[a] starts.
    void (*measure_arcs)(std::span<const CapPlane> caps, std::span<const ContourArc> arcs,
                         std::span<const std::uint32_t> next, std::span<MeasuredArc> measured);
};

/// Those that this machine can run, the plainest first.
std::vector<RegionKernels> supported_region_kernels();

/// Those with the instructions that the environment variable MENISCUS_INSTRUCTIONS names, else the last ones.
const RegionKernels& region_kernels();

}  // namespace meniscus
