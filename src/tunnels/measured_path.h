// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// From a polyline to a way with its profile and its bottleneck.
#pragma once

#include <cstddef>
#include <vector>

#include "meniscus/tunnels.h"
#include "tunnels/clearance.h"
#include "tunnels/saddles.h"

namespace meniscus {

/// What is left of a way up when its start is moved along it, as far as the radius allows.
std::vector<Vec3> moved(std::vector<Vec3> up, double radius);

/// A polyline that passes saddles.
struct Way {
    std::vector<Vec3> points;
    std::vector<std::size_t> saddle_points;  ///< indices of the points that are saddles, rising
    std::vector<Saddle> saddles;             ///< one for each of them

    /// Appends a polyline that begins where this one ends, or anywhere if this one is empty.
    void append(const std::vector<Vec3>& more);
    void append(const std::vector<Vec3>& more, const Saddle& saddle);
};

/// The same way by fewer points where they lie close, and by more where they lie far apart, with no less clearance.
Way resampled(const Clearance& clearance, const Way& way);

Bottleneck bottleneck_of(const Clearance& clearance, const Way& way);

/// Its profile and bottleneck, and the proof of it.
TunnelPath measured(const Clearance& clearance, const Way& way);

}  // namespace meniscus
