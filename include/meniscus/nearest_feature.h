// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What is nearest to a point on the solvent-excluded surface, and how the surface curves there.
#pragma once

#include <cstdint>

#include "meniscus/mesh.h"
#include "meniscus/vec3.h"

namespace meniscus {

/// The point of the SES that is nearest to a query point, seen through its nearest feature of the SAS.
struct NearestFeature {
    double signed_distance = 0.0;  ///< Å, negative inside; see ExactSurface::signed_distance()
    PatchKind patch = PatchKind::Contact;
    std::uint32_t atom = 0;           ///< nearest atom of the feature, in the caller's order
    double mean_curvature = 0.0;      ///< of the parallel surface through the point, Å^-1; may be ±inf at cusps
    double gaussian_curvature = 0.0;  ///< of the same surface, Å^-2; may be ±inf at cusps
    Vec3 foot;                        ///< nearest place where a probe's centre may be, Å
    Vec3 normal;                      ///< gradient of the signed distance; unit vector, zero where undefined
};

}  // namespace meniscus
