// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/side_kernels.h"

#include <optional>
#include <span>

#include "simd/kernels.h"

#define MENISCUS_KERNELS "band/side_kernels.inc"

namespace meniscus {
namespace {

#include "simd/kernel_sets.inc"

}  // namespace

// With u = 2^-24 and lengths up to m, coordinates are off by 4 u m, depths by 12 u m, what a direction exceeds a cap by
// by 26 u m, and distances from arcs, of which the axis is rounded, too, by 45 u m. Of the squares that tell whether a
// ball may be deeper one is off by 11 u m² (twice 4 u m for its length, and its sum), the other by 20 u m² (twice 9.5 u
// m), their difference by u m², and what is gained in a cube, of which half an edge is less than m / 4, by 18 u m².
SideLimits::SideLimits(double probe, double radius, double reach_of_points, double longest) {
    constexpr double kRounding = 64 * 0x1p-24;
    const double off = kRounding * longest;
    near = static_cast<float>(probe - radius - off);
    far = static_cast<float>(probe + radius + off);
    reach = static_cast<float>(reach_of_points);
    slack = static_cast<float>(off);
    squared_slack = static_cast<float>(off * longest);
}

std::vector<SideKernels> supported_side_kernels() { return kernels_of_this_machine(); }
const SideKernels& side_kernels() { return chosen_kernels(); }

}  // namespace meniscus
