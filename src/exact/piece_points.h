// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Points deep inside and outside of every exact piece, without asking which pieces there are.
#pragma once

#include <vector>

#include "geometry/accessible_surface.h"

namespace meniscus {

/// A point that is surely inside or outside, with a ball round it on the same side.
struct DeepPoint {
    Vec3 position;        ///< Å
    double radius = 0.0;  ///< of the ball, Å
    bool inside = false;
};

/// A probe position in every stretch of the SAS that arcs hold together, and the middle of the largest exposed atom of
/// every cluster that uncut tori hold together. Each exact piece has at least one of them: a cavity a stretch of the
/// SAS, a piece of the molecule a cluster.
///
/// cost   microseconds per atom; nothing is trimmed or measured
std::vector<DeepPoint> piece_points(const AccessibleSurface& surface);

}  // namespace meniscus
