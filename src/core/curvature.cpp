// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/curvature.h"

#include "core/elementary.h"

namespace meniscus {

double PrincipalCurvatures::shape_index() const {
    constexpr double kHuge = 1e100;  // as good as infinite, but with differences and quotients
    const double k1 = std::clamp(largest, -kHuge, kHuge);
    const double k2 = std::clamp(smallest, -kHuge, kHuge);
    return elementary::atan2(k1 + k2, k1 - k2) * (2.0 * std::numbers::inv_pi);
}

}  // namespace meniscus
