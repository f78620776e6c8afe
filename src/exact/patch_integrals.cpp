// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact/patch_integrals.h"

#include <cmath>

#include "core/elementary.h"
#include "simd/pairs.h"

namespace meniscus {
namespace {

// Of the directions from the circle's rim to the centres of both atoms.
std::array<ToroidalPatch::Angle, 2> angles_to_atoms(const SasArc& arc) {
    const Pair height{arc.height0, arc.height1};
    const Pair radius = Pair{} + arc.radius;
    const Pair length = root(height * height + radius * radius);
    const Pair psi = arc_tangent(height, radius);
    const Pair sine = height / length;
    const Pair cosine = radius / length;
    const auto angle = [&](std::size_t i) {
        return length[i] > 0.0 ? ToroidalPatch::Angle{psi[i], sine[i], cosine[i]} : ToroidalPatch::Angle{};
    };
    return {angle(0), angle(1)};
}

// ∫ (a - R cos ψ) dψ
double integral_from_axis(const SasArc& arc, double probe, const ToroidalPatch::Range& range) {
    return arc.radius * (range.end.psi - range.begin.psi) - probe * (range.end.sine - range.begin.sine);
}

double toroidal_area(const SasArc& arc, double probe, const ToroidalPatch::Range& range) {
    return arc.angle * probe * integral_from_axis(arc, probe, range);
}

ToroidalPatch::Angle mirrored(const ToroidalPatch::Angle& angle) { return {-angle.psi, -angle.sine, angle.cosine}; }

}  // namespace

PatchIntegrals sphere_patch(const Vec3& centre, double radius, const SphericalRegion& region, int side) {
    const double r2 = radius * radius;
    PatchIntegrals patch;
    patch.area = r2 * region.solid_angle;
    patch.volume = side * (r2 * dot(centre, region.vector_area) + r2 * radius * region.solid_angle) / 3.0;
    patch.first_moment = patch.area * centre + r2 * radius * region.vector_area;
    return patch;
}

bool meets_its_axis(const SasArc& arc, double probe) {
    return arc.radius < probe && arc.height0 > 0.0 && arc.height1 > 0.0;
}

ToroidalPatch toroidal_patch(const SasArc& arc, double probe) {
    const auto [to_first, last] = angles_to_atoms(arc);
    const ToroidalPatch::Angle first = mirrored(to_first);
    ToroidalPatch patch{.pieces = {{{first, last}}}, .count = 1};
    if (!meets_its_axis(arc, probe)) return patch;
    const double cosine = arc.radius / probe;
    const ToroidalPatch::Angle cusp{elementary::acos(cosine), std::sqrt(1.0 - cosine * cosine), cosine};
    patch.pieces = {{{first, mirrored(cusp)}, {cusp, last}}};
    patch.count = 2;
    return patch;
}

// A torus is divided at the plane of its circle (ψ = 0).
double toroidal_area_at_first(const SasArc& arc, double probe, const ToroidalPatch::Range& range) {
    const auto& [begin, end] = range;
    if (begin.psi > 0.0) return 0.0;
    return toroidal_area(arc, probe, {begin, end.psi < 0.0 ? end : ToroidalPatch::Angle{}});
}

// x = p - R n with p = centre + a e(θ), n = cos ψ e - sin ψ k, dA = (a - R cos ψ) R dψ dθ.
PatchIntegrals toroidal_piece(const SasArc& arc, double probe, const ToroidalPatch::Range& range, const Vec3& centre) {
    const double a = arc.radius;
    const auto& [begin, end] = range;
    const double turn = end.psi - begin.psi;
    const double sine = end.sine - begin.sine;
    const double cosine = end.cosine - begin.cosine;
    const double cos2 = 0.5 * (turn + end.sine * end.cosine - begin.sine * begin.cosine);  // ∫ cos²
    const double sin_cos = 0.5 * (end.sine * end.sine - begin.sine * begin.sine);
    const double i0 = integral_from_axis(arc, probe, range);
    const double i1 = a * sine - probe * cos2;
    const double i2 = -a * cosine - probe * sin_cos;
    const double i3 = (a * a + probe * probe) * sine - a * probe * (cos2 + turn);
    const Vec3 radial = arc.whole_circle() ? Vec3{} : 2.0 * elementary::sin(0.5 * arc.angle) * arc.middle;  // ∫ e dθ
    const Vec3 normal = probe * (i1 * radial - arc.angle * i2 * arc.axis);                                  // ∫ n dA
    PatchIntegrals patch;
    patch.area = arc.angle * probe * i0;
    patch.volume = (dot(centre, normal) + arc.angle * probe * i3) / 3.0;
    patch.first_moment = patch.area * centre + (a * probe * i0) * radial - probe * normal;
    return patch;
}

}  // namespace meniscus
