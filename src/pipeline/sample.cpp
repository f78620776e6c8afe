// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/sample.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <vector>

#include "core/memory.h"
#include "core/parallel.h"
#include "meniscus/errors.h"
#include "mesh/spread_points.h"
#include "pipeline/surface_mesh.h"
#include "pipeline/surface_projector.h"

namespace meniscus {
namespace {

// A candidate has a place, a normal, a cell and some eighteen neighbours.
constexpr double kBytesPerPoint = 320.0 * static_cast<double>(kCandidatesPerPoint);

std::size_t count_of(const Surface& surface, const SampleOptions& options) {
    if (!(std::isfinite(options.density) && options.density > 0.0))
        throw UsageError(fmt::format("density {:g}: must be finite and positive", options.density));
    if (options.threads < 0)
        throw UsageError(fmt::format("threads {}: must be 0 (all cores) or more", options.threads));
    const double count = std::round(options.density * surface.measures.area);
    constexpr double kMost =
        static_cast<double>(std::numeric_limits<std::uint32_t>::max()) / static_cast<double>(kCandidatesPerPoint);
    if (count > kMost || count * kBytesPerPoint > static_cast<double>(available_memory()))
        throw LimitError(
            fmt::format("density {:g}: {:.3g} points would not fit; choose fewer per Å²", options.density, count));
    return static_cast<std::size_t>(count);
}

// Nearly all candidates are within a few hundredths of an Å of the surface; those of large triangles may not be.
void approach(const SurfaceProjector& project, std::vector<Vec3>& points) {
    std::vector<SurfacePoint> places(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) places[i].position = points[i];
    constexpr std::size_t kPointsPerTask = 1024;
    parallel_chunks(places.size(), kPointsPerTask, [&](std::size_t begin, std::size_t end) {
        project(std::span(places).subspan(begin, end - begin));
    });
    for (std::size_t i = 0; i < points.size(); ++i) points[i] = places[i].position;
}

}  // namespace

Mesh sample_surface(const Surface& surface, const Atoms& atoms, const SampleOptions& options) {
    const std::size_t count = count_of(surface, options);
    const ThreadLimit limit(options.threads);
    PointsOnMesh spread = spread_points(surface.mesh, count, options.seed);
    const AccessibleSurface accessible(atoms, surface.options.probe);
    const LevelSet* level_set = surface.level_set.get();
    if (surface.options.remesh.is_on())
        approach(surface_projector(accessible, level_set, surface.options.spacing), spread.points);
    Mesh result;
    result.vertices = std::move(spread.points);
    finish_vertices(accessible, level_set, surface.options.spacing, result);
    for (const std::uint32_t triangle : spread.triangles)
        result.components.push_back(surface.mesh.components[surface.mesh.triangles[triangle][0]]);
    result.areas.assign(count, static_cast<float>(surface.measures.area / static_cast<double>(count)));
    return result;
}

}  // namespace meniscus
