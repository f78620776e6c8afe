// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/stencil.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meniscus {

Stencil approximate_inverse(const Stencil& s) {
    const double q = std::sqrt(0.5);
    const double f0 = 1.0 / symbol_of(s, q, q, q);
    const double f1 = 1.0 / symbol_of(s, -q, q, q);
    const double f2 = 1.0 / symbol_of(s, -q, -q, q);
    const double f3 = 1.0 / symbol_of(s, -q, -q, -q);
    return {(f0 + 3.0 * f1 + 3.0 * f2 + f3) / 8.0, (f0 + f1 - f2 - f3) / (16.0 * q),
            (f0 - f1 - f2 + f3) / (32.0 * q * q), (f0 - 3.0 * f1 + 3.0 * f2 - f3) / (64.0 * q * q * q)};
}

Range range_of_product(const Stencil& a, const Stencil& b) {
    Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (const double x : {-1.0, 0.0, 1.0})
        for (const double y : {-1.0, 0.0, 1.0})
            for (const double z : {-1.0, 0.0, 1.0}) {
                const double product = symbol_of(a, x, y, z) * symbol_of(b, x, y, z);
                range = {std::min(range.least, product), std::max(range.greatest, product)};
            }
    return range;
}

void apply_stencil(const Stencil& stencil, std::span<const float, kPaddedNodes> padded,
                   std::span<float, kBlockNodes> result) {
    constexpr int kRow = kPaddedEdge;
    constexpr int kSlab = kPaddedEdge * kPaddedEdge;
    const auto centre = static_cast<float>(stencil.centre);
    const auto face = static_cast<float>(stencil.face);
    const auto edge = static_cast<float>(stencil.edge);
    const auto corner = static_cast<float>(stencil.corner);
    for (int z = 0; z < kBlockEdge; ++z)
        for (int y = 0; y < kBlockEdge; ++y) {
            const int first = kRow * (y + 1) + kSlab * (z + 1);
            const float* own = padded.data() + first;
            // The rows beside and diagonal to this one, summed: each node differs in one or two axes from ours.
            float beside[kPaddedEdge];
            float diagonal[kPaddedEdge];
            for (int x = 0; x < kPaddedEdge; ++x) {
                beside[x] = (own[x - kRow] + own[x + kRow]) + (own[x - kSlab] + own[x + kSlab]);
                diagonal[x] =
                    (own[x - kSlab - kRow] + own[x - kSlab + kRow]) + (own[x + kSlab - kRow] + own[x + kSlab + kRow]);
            }
            float* out = result.data() + node_in_block(0, y, z);
            for (int x = 0; x < kBlockEdge; ++x) {
                const float sides = face * (own[x] + own[x + 2]) + edge * (beside[x] + beside[x + 2]) +
                                    corner * (diagonal[x] + diagonal[x + 2]);
                out[x] = centre * own[x + 1] + face * beside[x + 1] + edge * diagonal[x + 1] + sides;
            }
        }
}

}  // namespace meniscus
