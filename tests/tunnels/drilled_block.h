// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Blocks of beads with holes, whose narrowest places are rings and triangles of beads: tunnels with closed forms.
#pragma once

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "meniscus/atoms.h"

namespace meniscus::testing {

constexpr double kExact = 1e-9;  // Å

inline void add_bead(Atoms& atoms, const Vec3& centre, double radius) {
    atoms.centres.push_back(centre);
    atoms.radii.push_back(radius);
}

/// A ring of beads of radius 1 round a parallel of the z axis; a ball of radius `free` fits into it. So many beads that
/// nothing passes between them.
inline void add_ring(Atoms& atoms, const Vec3& middle, double free) {
    constexpr double kBead = 1.0;
    const double radius = free + kBead;
    const int count = static_cast<int>(std::ceil(2.0 * std::numbers::pi * radius));
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i + 0.3) / count;
        add_bead(atoms, middle + Vec3{radius * std::cos(angle), radius * std::sin(angle), 0.0}, kBead);
    }
}

/// Beads of radius 1 on a lattice so dense that nothing passes between them, in a box round the origin with the given
/// half edges, but only at least 1 Å away from where `is_free` says so: what is free stays free.
inline Atoms block(const Vec3& half, const std::function<bool(const Vec3&)>& is_filled) {
    constexpr double kStep = 1.05;
    Atoms atoms;
    for (double x = -half.x; x <= half.x; x += kStep)
        for (double y = -half.y; y <= half.y; y += kStep)
            for (double z = -half.z; z <= half.z; z += kStep)
                if (is_filled({x, y, z})) add_bead(atoms, {x, y, z}, 1.0);
    return atoms;
}

/// Beads at random places of a box with the given edge, not overlapping by more than a third.
inline Atoms random_beads(unsigned seed, int count, double edge) {
    std::mt19937 random(seed);
    const auto unit = [&] { return static_cast<double>(random()) / 4294967296.0; };
    Atoms atoms;
    for (int tries = 0; static_cast<int>(atoms.size()) < count && tries < 100000; ++tries) {
        const Vec3 place{edge * unit(), edge * unit(), edge * unit()};
        const double radius = 1.0 + unit();
        bool fits = true;
        for (std::size_t i = 0; i < atoms.size() && fits; ++i)
            fits = norm(place - atoms.centres[i]) > 0.67 * (radius + atoms.radii[i]);
        if (fits) add_bead(atoms, place, radius);
    }
    return atoms;
}

}  // namespace meniscus::testing
