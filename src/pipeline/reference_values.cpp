// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/reference_values.h"

#include <algorithm>
#include <cmath>

#include "exact/measure_surface.h"
#include "exact/patch_totals.h"
#include "geometry/accessible_surface_data.h"

namespace meniscus {
namespace {

// Volume below which cavities are not in the mesh, Å³.
double least_cavity(const SurfaceOptions& options) { return std::max(options.min_cavity, options.fill_cavities); }

// Whether a piece is too small a cavity or lies within one.
bool is_dropped(const SurfaceComponent& piece, const Measures& exact, double least) {
    if (piece.kind == ComponentKind::Cavity && piece.ses_volume < least) return true;
    return piece.inside_of != kNone && is_dropped(exact.components[piece.inside_of], exact, least);
}

bool keeps_everything(const SurfaceOptions& options) {
    return options.pieces == Pieces::All && least_cavity(options) == 0.0;
}

DeepPoint deepest_point(const SurfaceComponent& piece, const Atoms& atoms) {
    if (piece.kind == ComponentKind::Cavity) return {piece.inscribed_centre, piece.inscribed_radius, false};
    const std::uint32_t largest =
        *std::max_element(piece.atoms.begin(), piece.atoms.end(),
                          [&](std::uint32_t a, std::uint32_t b) { return atoms.radii[a] < atoms.radii[b]; });
    return {atoms.centres[largest], atoms.radii[largest], true};
}

// Whether a mesh of these options is to have the piece.
bool is_kept(const SurfaceComponent& piece, const Measures& exact, const SurfaceOptions& options) {
    const bool outer = piece.kind == ComponentKind::Outer;
    if (options.pieces != Pieces::All && outer != (options.pieces == Pieces::Outer)) return false;
    return !is_dropped(piece, exact, least_cavity(options));
}

void add_piece(PieceCounts& counts, bool outer) { ++(outer ? counts.outer : counts.cavities); }

// On the grid a wall thinner than a cell may be open, and a cavity belong to the outer piece: then it is kept or left
// out with that one. One near the least volume can be on either side.
bool may_change_sides(const SurfaceComponent& piece, const SurfaceOptions& options) {
    return piece.kind == ComponentKind::Cavity && !keeps_everything(options);
}

double sharpest_radius(const Atoms& atoms, const SurfaceOptions& options) {
    const double smallest = *std::min_element(atoms.radii.begin(), atoms.radii.end());
    return std::min(1.0, std::max(smallest, options.spacing));
}

}  // namespace

SurfaceTotals exact_counterpart(const Measures& exact, const SurfaceOptions& options) {
    if (keeps_everything(options)) return exact.totals;
    SurfaceTotals sum;
    for (const SurfaceComponent& c : exact.components) {
        if (!is_kept(c, exact, options)) continue;
        sum.ses_area += c.ses_area;
        sum.ses_volume += c.kind == ComponentKind::Outer ? c.ses_volume : -c.ses_volume;
    }
    return sum;
}

PieceCounts count_pieces(const Measures& exact) {
    PieceCounts counts;
    for (const SurfaceComponent& c : exact.components) add_piece(counts, c.kind == ComponentKind::Outer);
    return counts;
}

PieceCounts count_pieces(const MeshMeasures& mesh) {
    PieceCounts counts;
    for (const MeshComponent& c : mesh.components) add_piece(counts, c.volume > 0.0);
    return counts;
}

PieceCounts count_kept_pieces(const Measures& exact, const SurfaceOptions& options) {
    PieceCounts counts;
    for (const SurfaceComponent& c : exact.components)
        if (is_kept(c, exact, options)) add_piece(counts, c.kind == ComponentKind::Outer);
    return counts;
}

ReferenceValues reference_values_of(const Measures& measured, const Atoms& atoms, const SurfaceOptions& options) {
    ReferenceValues reference{.kept = exact_counterpart(measured, options), .points = {}, .resolved = measured.agreed};
    reference.sharpest = sharpest_radius(atoms, options);
    for (const SurfaceComponent& piece : measured.components) {
        const DeepPoint point = deepest_point(piece, atoms);
        const bool resolved = point.radius > kResolved * options.spacing;
        if (resolved) reference.points.push_back(point);
        if (!resolved || may_change_sides(piece, options)) reference.doubtful += piece.ses_volume;
    }
    return reference;
}

ReferenceValues find_reference_values(const AccessibleSurface& accessible, const Atoms& atoms,
                                      const SurfaceOptions& options) {
    ReferenceValues reference;
    reference.sharpest = sharpest_radius(atoms, options);
    if (keeps_everything(options) && accessible.probe() > kResolved * options.spacing) {
        reference.points = piece_points(accessible);
        const bool resolved = std::all_of(reference.points.begin(), reference.points.end(),
                                          [&](const DeepPoint& p) { return p.radius > kResolved * options.spacing; });
        const PatchTotals sums = resolved ? sum_patches(accessible, 0) : PatchTotals{};
        reference.kept = sums.totals;
        if (resolved && sums.unresolved.empty()) return reference;
    }
    const Measures once = measure_once(accessible, atoms);
    return reference_values_of(once.agreed ? once : measure(accessible, atoms), atoms, options);
}

std::vector<DeepPoint> scattered_points(const AccessibleSurface& accessible, const SurfaceOptions& options) {
    constexpr std::size_t kPoints = 20'000;
    // Kronecker's sequence of the plastic number's generalisation to three dimensions (Roberts 2018).
    constexpr Vec3 kSteps{0.8191725133961645, 0.6710436067037893, 0.5497004779019703};
    const CanonicalAtoms& atoms = accessible.data().atoms;
    Box box;
    for (std::size_t i = 0; i < atoms.size(); ++i) {
        const double r = atoms.radii[i];
        box.include(atoms.centres[i] - Vec3{r, r, r});
        box.include(atoms.centres[i] + Vec3{r, r, r});
    }
    const auto part = [](double step, std::size_t i) {
        const double turns = step * static_cast<double>(i + 1);
        return turns - std::floor(turns);
    };
    const Vec3 size = box.high - box.low;
    std::vector<Vec3> points(kPoints);
    for (std::size_t i = 0; i < kPoints; ++i)
        points[i] = box.low + Vec3{part(kSteps.x, i) * size.x, part(kSteps.y, i) * size.y, part(kSteps.z, i) * size.z};
    const std::vector<double> distances = signed_distance(accessible, points);
    std::vector<DeepPoint> all(kPoints);
    for (std::size_t i = 0; i < kPoints; ++i) all[i] = {points[i], std::abs(distances[i]), distances[i] < 0.0};
    std::erase_if(all, [&](const DeepPoint& p) { return !(p.radius > kResolved * options.spacing); });
    return all;
}

}  // namespace meniscus
