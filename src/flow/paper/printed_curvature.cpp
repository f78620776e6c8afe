// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/paper/printed_curvature.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "nearest/nearest_feature.h"

namespace meniscus {
namespace {

using Data = AccessibleSurface::Data;

bool intersect(const Data& data, const SasArc& arc) {
    const auto [i, j] = arc.atoms;
    return norm(data.atoms.centres[i] - data.atoms.centres[j]) < data.atoms.radii[i] + data.atoms.radii[j];
}

double toroidal_curvature_as_printed(const Data& data, const SasArc& arc, const Vec3& p, BridgedPair bridged) {
    if (bridged == BridgedPair::Reentrant && !intersect(data, arc)) return -1.0 / data.probe;
    const ArcFoot foot = foot_on_arc(arc, p);
    const double distance = std::sqrt(foot.squared_distance);
    // The point of the torus lies on the probe's circle, in the half-plane of p.
    const double d = arc.radius - data.probe * (arc.radius - foot.from_axis) / distance;
    return 0.5 * (1.0 / std::abs(d) - 1.0 / data.probe);
}

double curvature_as_printed(const Data& data, const Vec3& p, BridgedPair bridged) {
    const NearestHit hit = nearest_hit(data, p);
    if (hit.by_ball) return 1.0 / data.atoms.radii[hit.ball.atom];
    if (hit.edge.vertex != kNoVertex) return -1.0 / data.probe;
    return toroidal_curvature_as_printed(data, data.arcs[hit.edge.arc], p, bridged);
}

}  // namespace

NodeField sample_printed_curvature(const AccessibleSurface& surface, const BlockGrid& grid, BridgedPair bridged) {
    const double limit = 1.0 / grid.spacing();
    NodeField field(grid.node_count(), 0.0F);
    parallel_for(field.size(), kBlockNodes, [&](std::size_t n) {
        const double h = curvature_as_printed(surface.data(), grid.position(n), bridged);
        field[n] = static_cast<float>(h > -limit ? std::min(h, limit) : -limit);
    });
    return field;
}

}  // namespace meniscus
