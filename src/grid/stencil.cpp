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

}  // namespace meniscus
