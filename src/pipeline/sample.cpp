// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/sample.h"

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/number_text.h"
#include "core/requirements.h"
#include "geometry/accessible_surface.h"
#include "meniscus/errors.h"
#include "meniscus/threads.h"
#include "mesh/spread_points.h"
#include "platform/memory.h"
#include "project/finish_vertices.h"
#include "project/surface_projector.h"

namespace meniscus {
namespace {

// A candidate has a place, a normal, a cell and some eighteen neighbours.
constexpr double kBytesPerPoint = 320.0 * static_cast<double>(kCandidatesPerPoint);

std::size_t count_of(const Surface& surface, const SampleOptions& options) {
    require_positive("density", options.density);
    check_threads(options.threads);
    const double count = std::round(options.density * surface.measures.area);
    constexpr double kMost =
        static_cast<double>(std::numeric_limits<std::uint32_t>::max()) / static_cast<double>(kCandidatesPerPoint);
    if (count > kMost || count * kBytesPerPoint > static_cast<double>(available_memory()))
        throw LimitError(joined("density ", in_short(options.density), ": ", in_short(count, 3),
                                " points would not fit into memory; choose fewer per Å²"));
    return static_cast<std::size_t>(count);
}

// Puts points of a mesh's triangles onto the surface.
class Projection {
public:
    explicit Projection(const Surface& surface)
        : surface_(surface), accessible_(surface.exact.accessible()), level_set_(surface.level_set.get()) {}

    Mesh project(PointsOnMesh spread) const {
        if (surface_.options.remesh.is_on())
            put_on_surface(spread.points, surface_projector(accessible_, level_set_, spacing(), Curvatures::LeftOut));
        Mesh result;
        result.vertices = spread.points;
        VertexDistances distances = finish_vertices({accessible_, level_set_, spacing()}, result);
        project_outliers_again(spread, distances, result);
        return result;
    }

private:
    double spacing() const { return surface_.options.spacing; }

    // Points that did not come to lie on the surface, as one in some 100,000 does between sheets that nearly touch.
    std::vector<VertexId> outliers(const Mesh& points, const VertexDistances& distances) const {
        constexpr double kOnSurface = 1e-6;  // spacings
        std::vector<double> values;
        if (level_set_ != nullptr) values = level_set_->values(points.vertices);
        std::vector<VertexId> result;
        for (VertexId i = 0; i < points.vertices.size(); ++i) {
            const double off = level_set_ != nullptr ? std::abs(values[i]) : distances[i];
            if (!(off < kOnSurface * spacing())) result.push_back(i);
        }
        return result;
    }

    // Outliers start again from nearer to a corner of their triangle, which is on the surface or next to it, and at
    // last from there.
    void project_outliers_again(const PointsOnMesh& spread, VertexDistances& distances, Mesh& points) const {
        constexpr int kTries = 4;
        for (int attempt = 1; attempt <= kTries; ++attempt) {
            const std::vector<VertexId> lost = outliers(points, distances);
            if (lost.empty()) return;
            std::vector<VertexStart> starts;
            starts.reserve(lost.size());
            for (const VertexId i : lost) {
                const Vec3& corner = surface_.mesh.vertices[surface_.mesh.triangles[spread.triangles[i]][0]];
                const double part = static_cast<double>(attempt) / kTries;
                starts.push_back({i, spread.points[i] + part * (corner - spread.points[i])});
            }
            finish_again({accessible_, level_set_, spacing()}, starts, points, distances);
        }
    }

    const Surface& surface_;
    const AccessibleSurface& accessible_;
    const LevelSet* level_set_;
};

}  // namespace

Mesh sample_surface(const Surface& surface, const SampleOptions& options) {
    const std::size_t count = count_of(surface, options);
    const ThreadLimit limit(options.threads);
    const PointsOnMesh spread = spread_points(surface.mesh, count, options.seed);
    Mesh result = Projection(surface).project(spread);
    for (const std::uint32_t triangle : spread.triangles)
        result.components.push_back(surface.mesh.components[surface.mesh.triangles[triangle][0]]);
    result.areas.assign(count, static_cast<float>(surface.measures.area / static_cast<double>(count)));
    return result;
}

}  // namespace meniscus
