// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Closed-form integrals over the three kinds of patches of the solvent-excluded surface.
#pragma once

#include <optional>

#include "geometry/accessible_surface_data.h"
#include "geometry/spherical_region.h"
#include "meniscus/vec3.h"

namespace meniscus {

/// Integrals over a piece of surface with outward normal n (into the solvent).
struct PatchIntegrals {
    double area = 0.0;    ///< Å²
    double volume = 0.0;  ///< ⅓ ∮ x·n, Å³: sums to the volume enclosed by a closed surface
    Vec3 first_moment;    ///< ∮ x, Å³: divided by the area, the centroid of the surface

    PatchIntegrals& operator+=(const PatchIntegrals& other) {
        area += other.area;
        volume += other.volume;
        first_moment += other.first_moment;
        return *this;
    }
};

/// Part of a sphere with the outside of the ball as the solvent (side = 1) or the inside (side = -1).
/// centre   relative to the origin of the volume integral, Å
PatchIntegrals sphere_patch(const Vec3& centre, double radius, const SphericalRegion& region, int side);

/// The parts of the torus that the probe sweeps along an exposed arc.
///
/// ψ turns about the probe centre from the inward radial direction, negative towards atoms[0]. A torus that meets
/// its own axis (circle radius below the probe radius) is cut there and falls into two pieces, one per atom.
struct ToroidalPatch {
    struct Angle {
        double psi = 0.0;  ///< radian
        double sine = 0.0;
        double cosine = 1.0;
    };
    /// Limits of the pieces: [0] at atoms[0], [1] at atoms[1]; one piece alone is [0].
    struct Range {
        Angle begin;
        Angle end;
    };
    std::array<Range, 2> pieces{};
    int count = 0;
};

/// Whether the torus of an arc meets its own axis between the atoms.
bool meets_its_axis(const SasArc& arc, double probe);

ToroidalPatch toroidal_patch(const SasArc& arc, double probe);

/// The area of a piece on the side of atoms[0], Å².
double toroidal_area_at_first(const SasArc& arc, double probe, const ToroidalPatch::Range& range);

/// Integrals over a range of ψ; centre: of the arc's circle, relative to the origin of the volume integral, Å.
PatchIntegrals toroidal_piece(const SasArc& arc, double probe, const ToroidalPatch::Range& range, const Vec3& centre);

}  // namespace meniscus
