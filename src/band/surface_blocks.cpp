// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/surface_blocks.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_set>

#include "core/parallel.h"
#include "geometry/accessible_surface_data.h"
#include "meniscus/errors.h"

namespace meniscus {
namespace {

using BlockSet = std::unordered_set<BlockCoord, BlockCoordHash>;

// At least one point of the van der Waals spheres on every piece of the surface.
std::vector<Vec3> points_on_surface(const AccessibleSurface::Data& data) {
    std::vector<Vec3> points;
    const auto add = [&](std::uint32_t atom, const Vec3& towards) {
        const Vec3& centre = data.atoms.centres[atom];
        points.push_back(centre + (data.atoms.radii[atom] / norm(towards - centre)) * (towards - centre));
    };
    for (const SasArc& arc : data.arcs)
        for (const std::uint32_t atom : arc.atoms) add(atom, arc.centre + arc.radius * arc.middle);
    for (std::uint32_t i = 0; i < data.atoms.size(); ++i)
        if (data.exposed[i] != 0 && data.caps_of(i).empty()) add(i, data.atoms.centres[i] + Vec3{0.0, 0.0, 1.0});
    return points;
}

}  // namespace

BlockCoord Lattice::block_of(const Vec3& point) const {
    const auto index = [&](double offset) {
        const double block = std::floor(offset / block_edge());
        if (!(std::abs(block) < (1 << 30)))
            throw LimitError("the atoms are too far from the origin for this grid spacing; enlarge --spacing");
        return static_cast<std::int32_t>(block);
    };
    const Vec3 offset = point - origin;
    return {.z = index(offset.z), .y = index(offset.y), .x = index(offset.x)};
}

std::vector<BlockCoord> blocks_near_surface(const AccessibleSurface& surface, const Lattice& lattice, double margin,
                                            std::size_t max_blocks) {
    const double reach = margin + 0.5 * std::numbers::sqrt3 * lattice.block_edge();
    const Vec3 to_centre = 0.5 * lattice.block_edge() * Vec3{1.0, 1.0, 1.0};
    BlockSet seen;
    std::vector<BlockCoord> frontier;
    for (const Vec3& point : points_on_surface(surface.data()))
        if (const BlockCoord block = lattice.block_of(point); seen.insert(block).second) frontier.push_back(block);

    std::vector<BlockCoord> result;
    std::vector<std::uint8_t> near;
    while (!frontier.empty()) {
        near.assign(frontier.size(), 0);
        parallel_for(frontier.size(), 16, [&](std::size_t b) {
            const Vec3 centre = lattice.corner(frontier[b]) + to_centre;
            near[b] = std::abs(surface.nearest(centre).signed_distance) < reach ? 1 : 0;
        });
        std::vector<BlockCoord> next;
        for (std::size_t b = 0; b < frontier.size(); ++b) {
            if (near[b] == 0) continue;
            const BlockCoord at = frontier[b];
            result.push_back(at);
            for (int dz = -1; dz <= 1; ++dz)
                for (int dy = -1; dy <= 1; ++dy)
                    for (int dx = -1; dx <= 1; ++dx) {
                        const BlockCoord beside{.z = at.z + dz, .y = at.y + dy, .x = at.x + dx};
                        if (seen.insert(beside).second) next.push_back(beside);
                    }
        }
        if (result.size() > max_blocks)
            throw LimitError("the narrow band would not fit into memory; enlarge --spacing or raise --memory");
        frontier = std::move(next);
    }
    std::sort(result.begin(), result.end());
    return result;
}

}  // namespace meniscus
