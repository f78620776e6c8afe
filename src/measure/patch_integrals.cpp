// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/patch_integrals.h"

#include <cmath>
#include <numeric>

namespace meniscus {

void measure_exposed_regions(const AccessibleSurface::Data& data, std::uint32_t atom, SphericalRegions& regions) {
    const std::span<const Cap> caps = data.caps_of(atom);
    std::vector<std::uint32_t> all(caps.size());
    std::iota(all.begin(), all.end(), 0U);
    regions.measure(caps, data.contour_of(atom), all);
}

PatchIntegrals sphere_patch(const Vec3& centre, double radius, const SphericalRegion& region, int side) {
    const double r2 = radius * radius;
    PatchIntegrals patch;
    patch.area = r2 * region.solid_angle;
    patch.volume = side * (r2 * dot(centre, region.vector_area) + r2 * radius * region.solid_angle) / 3.0;
    patch.first_moment = patch.area * centre + r2 * radius * region.vector_area;
    return patch;
}

ToroidalPatch toroidal_patch(const SasArc& arc, double probe) {
    const double first = -std::atan2(arc.height0, arc.radius);
    const double last = std::atan2(arc.height1, arc.radius);
    ToroidalPatch patch;
    if (arc.radius < probe && first < 0.0 && last > 0.0) {
        const double cusp = std::acos(arc.radius / probe);  // where the probe circle meets the axis
        patch.pieces = {{{first, -cusp}, {cusp, last}}};
        patch.count = 2;
    } else {
        patch.pieces[0] = {first, last};
        patch.count = 1;
    }
    return patch;
}

// x = p - R n with p = centre + a e(θ), n = cos ψ e - sin ψ k, dA = (a - R cos ψ) R dψ dθ.
PatchIntegrals toroidal_piece(const SasArc& arc, double probe, const ToroidalPatch::Range& range, const Vec3& centre) {
    const double a = arc.radius;
    const double turn = range.end - range.begin;
    const double sine = std::sin(range.end) - std::sin(range.begin);
    const double cosine = std::cos(range.end) - std::cos(range.begin);
    const double cos2 = 0.5 * turn + 0.25 * (std::sin(2.0 * range.end) - std::sin(2.0 * range.begin));  // ∫ cos²
    const double sin_cos = 0.5 * (std::pow(std::sin(range.end), 2) - std::pow(std::sin(range.begin), 2));
    const double i0 = a * turn - probe * sine;
    const double i1 = a * sine - probe * cos2;
    const double i2 = -a * cosine - probe * sin_cos;
    const double i3 = (a * a + probe * probe) * sine - a * probe * (cos2 + turn);
    const Vec3 radial = arc.whole_circle() ? Vec3{} : 2.0 * std::sin(0.5 * arc.angle) * arc.middle;  // ∫ e dθ
    const Vec3 normal = probe * (i1 * radial - arc.angle * i2 * arc.axis);                           // ∫ n dA
    PatchIntegrals patch;
    patch.area = arc.angle * probe * i0;
    patch.volume = (dot(centre, normal) + arc.angle * probe * i3) / 3.0;
    patch.first_moment = patch.area * centre + (a * probe * i0) * radial - probe * normal;
    return patch;
}

}  // namespace meniscus
