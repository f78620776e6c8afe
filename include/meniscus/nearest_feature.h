// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The feature of a molecular surface that is nearest to a point, and the curvature there.
#pragma once

#include <cstdint>

#include "meniscus/mesh.h"
#include "meniscus/vec3.h"

namespace meniscus {

/// The SES where it is nearest to a query point, found by way of the nearest feature of the SAS.
struct NearestFeature {
    double signed_distance = 0.0;  ///< Å, negative inside; see ExactSurface::signed_distance()
    PatchKind patch = PatchKind::Contact;
    std::uint32_t atom = 0;           ///< the feature's atom nearest to the point, as the caller's index
    double mean_curvature = 0.0;      ///< Å^-1, of the parallel surface through the point; may be ±inf at cusps
    double gaussian_curvature = 0.0;  ///< Å^-2, of the parallel surface through the point; may be ±inf at cusps
    Vec3 foot;                        ///< nearest point of the SAS: where the centre of a probe may be, Å
    Vec3 normal;                      ///< gradient of the signed distance; unit vector, zero where undefined
};

}  // namespace meniscus
