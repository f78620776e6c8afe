// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "project/move_corners.h"

#include <algorithm>
#include <span>
#include <vector>

#include "measure/mesh_distance.h"
#include "remesh/balance.h"

namespace meniscus {
namespace {

constexpr std::size_t kMostLookedAt = 16'384;  // triangles: they tell the mean distance of all within 1 %
constexpr double kCertainty = 0.985;           // of the distance to be kept to, therefore
constexpr int kHalvings = 6;                   // of the share

// The least share of the offsets with which mean_distance() of the mesh is at most `near`; the whole if none is enough.
template <class MeanDistance>
double share_needed(Mesh& mesh, std::span<const double> offsets, double near, const MeanDistance& mean_distance) {
    double too_small = 0.0;
    double share = 1.0;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = 0.5 * (too_small + share);
        std::vector<Vec3> moved = vertices_moved(mesh, offsets, middle);
        mesh.vertices.swap(moved);
        const double distance = mean_distance();
        mesh.vertices.swap(moved);
        (distance <= near ? share : too_small) = middle;
    }
    return share;
}

}  // namespace

bool move_corners(Mesh& mesh, const RemeshOptions& even, const AccessibleSurface& surface,
                  const SurfaceProjector& project) {
    if (!even.is_on() || even.corners == Corners::OnSurface) return false;
    const bool whole = even.corners == Corners::Balanced;
    const double near = kCertainty * kDistancePerSquareEdge * even.edge * even.edge;
    const std::size_t step = std::max<std::size_t>(1, mesh.triangles.size() / kMostLookedAt);
    const auto mean_distance = [&] { return mean_distance_to_exact(mesh, surface, step); };
    if (!whole && mean_distance() <= near) return false;
    const std::vector<double> offsets = balancing_offsets(mesh, even.edge, project);
    const double share = whole ? 1.0 : share_needed(mesh, offsets, near, mean_distance);
    move_vertices(mesh, vertices_moved(mesh, offsets, share), even.edge);
    return true;
}

}  // namespace meniscus
