// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/self_checks.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "cavities/winding.h"
#include "project/level_set_side.h"

namespace meniscus {
namespace {

// A flow's mean distance to the exact surface is near 0.01 spacings; ten times that means something broke.
constexpr double kMeanDistanceBound = 0.1;  // in spacings

// The largest differences of volume found per square of the spacing and area (docs/design/self-checks.md), several
// times over: of smooth surfaces, and of those with creases wherever atoms meet.
constexpr double kVolumeBound = 0.1;         // Å^-1
constexpr double kCreasedVolumeBound = 0.3;  // Å^-1

bool is_inside(const BlockGrid& grid, std::span<const InsideBits> inside, const Vec3& point) {
    if (grid.coords().empty()) return false;
    const Vec3 steps = (1.0 / grid.spacing()) * (point - grid.origin());
    const std::int64_t x = std::llround(steps.x);
    const std::int64_t y = std::llround(steps.y);
    std::int64_t z = std::llround(steps.z);
    BlockCoord at{.z = block_of_node(z), .y = block_of_node(y), .x = block_of_node(x)};
    for (const std::int32_t top = grid.coords().back().z; at.z <= top; ++at.z) {
        if (const BlockId block = grid.find(at); block != kNoBlock) {
            return inside_bit(inside[block], place_in_block(x), place_in_block(y), place_in_block(z));
        }
        z = 0;  // of a block above the first
    }
    return false;
}

// Creases between atoms, or between atoms and a probe that is too small to round them at this spacing.
bool is_creased(const SurfaceOptions& options) {
    return options.surface != SurfaceKind::Ses || options.probe <= kResolved * options.spacing;
}

Check holds(const char* name, bool passed) { return {name, passed, passed ? 1.0 : 0.0, 1.0}; }

}  // namespace

double volume_error_bound(const SurfaceOptions& options, double area) {
    const double step = std::max(options.spacing, options.remesh.edge);
    return (is_creased(options) ? kCreasedVolumeBound : kVolumeBound) * step * step * area;
}

std::size_t count_wrong(std::span<const DeepPoint> points, const LevelSet& level_set) {
    return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](const DeepPoint& point) {
        return is_inside(level_set, point.position) != point.inside;
    }));
}

std::size_t count_wrong(std::span<const DeepPoint> points, const BlockGrid& grid, std::span<const InsideBits> inside) {
    return static_cast<std::size_t>(std::count_if(points.begin(), points.end(), [&](const DeepPoint& point) {
        return is_inside(grid, inside, point.position) != point.inside;
    }));
}

std::size_t count_wrong(std::span<const DeepPoint> points, const Mesh& mesh) {
    std::vector<Vec3> places;
    places.reserve(points.size());
    for (const DeepPoint& point : points) places.push_back(point.position);
    const std::vector<int> numbers = winding_numbers(mesh, places);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < points.size(); ++i) wrong += numbers[i] != (points[i].inside ? 1 : 0) ? 1 : 0;
    return wrong;
}

Check pieces_check(std::size_t wrong) { return {"pieces", wrong == 0, static_cast<double>(wrong), 0.0}; }

Check sides_check(std::size_t wrong) { return {"sides", wrong == 0, static_cast<double>(wrong), 0.0}; }

Check volume_check(const Surface& surface, const ReferenceValues& reference) {
    const double edge = surface.options.remesh.edge;
    const auto changed = static_cast<double>(surface.simplified.handles + surface.simplified.pieces);
    const double difference = std::abs(surface.corrected_volume - reference.kept.ses_volume);
    if (!reference.resolved) return {"volume", false, difference, std::numeric_limits<double>::quiet_NaN()};
    // Chords of sharper spheres lie deeper below them, as 1/r.
    const double bound = volume_error_bound(surface.options, reference.kept.ses_area) / reference.sharpest +
                         reference.doubtful + changed * edge * edge * edge;
    return {"volume", difference <= bound, difference, bound};
}

std::vector<Check> mesh_checks(const Surface& surface) {
    const SurfaceOptions& options = surface.options;
    std::vector<Check> checks;
    if (options.pieces != Pieces::Cavities)  // there may be none
        checks.push_back(holds("not_empty", !surface.mesh.triangles.empty()));
    checks.push_back(holds("closed", surface.measures.closed));
    checks.push_back(holds("manifold", surface.measures.manifold));
    if (options.method == Method::Flow) checks.push_back(holds("converged", surface.flow.converged));
    if (options.method == Method::Gaussian) return checks;
    const double bound = kMeanDistanceBound * options.spacing;
    checks.push_back({"mean_distance", surface.distance.mean <= bound, surface.distance.mean, bound});
    return checks;
}

Check sums_check(const Measures& measured) {
    constexpr double kBound = 1e-9;
    const SurfaceTotals& totals = measured.totals;
    double atoms = 0.0;
    double pieces = 0.0;
    double volume = 0.0;
    double largest_volume = 0.0;
    for (const AtomMeasure& atom : measured.atoms) atoms += atom.ses_area();
    for (const SurfaceComponent& piece : measured.components) {
        pieces += piece.ses_area;
        volume += piece.kind == ComponentKind::Outer ? piece.ses_volume : -piece.ses_volume;
        largest_volume = std::max(largest_volume, piece.ses_volume);
    }
    const double area = std::max(std::abs(atoms - totals.ses_area), std::abs(pieces - totals.ses_area));
    const double value = std::max(area / totals.ses_area, std::abs(volume - totals.ses_volume) / largest_volume);
    return {"sums", value <= kBound, value, kBound};
}

}  // namespace meniscus
