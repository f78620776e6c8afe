// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Where the volume integral ⅓ ∮ x·n of each patch starts from.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/accessible_surface_data.h"

namespace meniscus {

/// Any origin is right for a closed surface, but what rounding and the perturbation leave of ∮ n is multiplied by the
/// distance from it. So clusters of atoms far from each other, which share no piece of surface, have origins of their
/// own: the middles of their boxes.
class VolumeOrigins {
public:
    /// cost   O(n); O(n log n) where the atoms extend over more than 10 000 Å
    explicit VolumeOrigins(const AccessibleSurface::Data& data);

    /// The origin for the patches of an atom (in canonical order).
    const Vec3& of(std::uint32_t atom) const { return origins_[cluster_.empty() ? 0 : cluster_[atom]]; }

private:
    std::vector<Vec3> origins_;
    std::vector<std::uint32_t> cluster_;  // of each atom; empty if there is one cluster
};

}  // namespace meniscus
