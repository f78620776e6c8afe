// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact/piece_points.h"

#include <map>

#include "core/disjoint_sets.h"
#include "exact/patch_integrals.h"
#include "geometry/accessible_surface_data.h"

namespace meniscus {
namespace {

// Probe positions, one per set of vertices that arcs join; whole circles have none and stand for themselves.
void add_probe_positions(const AccessibleSurface::Data& data, std::vector<DeepPoint>& points) {
    DisjointSets stretches(data.vertices.size());
    for (const SasArc& arc : data.arcs) {
        if (arc.whole_circle())
            points.push_back({arc.centre + arc.radius * arc.middle, data.probe, false});
        else
            stretches.join(arc.start, arc.end);
    }
    for (std::uint32_t v = 0; v < data.vertices.size(); ++v)
        if (stretches.root(v) == v) points.push_back({data.vertices[v].position, data.probe, false});
}

// Contact patches on both sides of a torus in one piece belong to the same piece of the SES.
void add_atoms(const AccessibleSurface::Data& data, std::vector<DeepPoint>& points) {
    DisjointSets clusters(data.atoms.size());
    for (const SasArc& arc : data.arcs)
        if (!meets_its_axis(arc, data.probe)) clusters.join(arc.atoms[0], arc.atoms[1]);
    std::map<std::uint32_t, std::uint32_t> largest;  // of each root
    for (std::uint32_t i = 0; i < data.atoms.size(); ++i) {
        if (data.exposed[i] == 0) continue;
        const auto [known, is_new] = largest.try_emplace(clusters.root(i), i);
        if (!is_new && data.atoms.radii[i] > data.atoms.radii[known->second]) known->second = i;
    }
    for (const auto& [root, i] : largest) points.push_back({data.atoms.centres[i], data.atoms.radii[i], true});
}

}  // namespace

std::vector<DeepPoint> piece_points(const AccessibleSurface& surface) {
    std::vector<DeepPoint> points;
    add_probe_positions(surface.data(), points);
    add_atoms(surface.data(), points);
    return points;
}

}  // namespace meniscus
