// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "meniscus/mesh.h"
#include "meniscus/tables.h"

namespace meniscus {
namespace {

/// An exact cavity and a piece of the mesh are the same if their centroids are no farther apart than this share of the
/// radius of a ball of the same volume, and this length, Å: the mesh's comes from its vertices.
constexpr double kSameShare = 0.5;
constexpr double kSameDistance = 0.5;

/// A wall of the mesh that encloses solvent.
struct Wall {
    std::uint32_t component = 0;
    MeshComponent measures;
    Vec3 centre;
    double radius = 0.0;  // to the farthest vertex
};

std::vector<Wall> walls_of(const Mesh& mesh) {
    if (mesh.components.empty()) return {};
    const std::vector<MeshComponent> pieces = measure_mesh(mesh).components;
    std::vector<Wall> walls(pieces.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) walls[mesh.components[v]].centre += mesh.vertices[v];
    for (std::size_t i = 0; i < walls.size(); ++i) {
        walls[i].component = static_cast<std::uint32_t>(i);
        walls[i].measures = pieces[i];
        walls[i].centre = (1.0 / static_cast<double>(std::max<std::size_t>(pieces[i].vertices, 1))) * walls[i].centre;
    }
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        Wall& wall = walls[mesh.components[v]];
        wall.radius = std::max(wall.radius, norm(mesh.vertices[v] - wall.centre));
    }
    std::erase_if(walls, [](const Wall& wall) { return wall.measures.volume >= 0.0; });
    return walls;
}

const Wall* wall_of(const SurfaceComponent& cavity, const std::vector<Wall>& walls) {
    const auto distance = [&](const Wall& wall) { return norm(wall.centre - cavity.centre); };
    const auto nearest = std::min_element(walls.begin(), walls.end(),
                                          [&](const Wall& a, const Wall& b) { return distance(a) < distance(b); });
    if (nearest == walls.end()) return nullptr;
    return distance(*nearest) <= kSameDistance + kSameShare * std::cbrt(cavity.ses_volume) ? &*nearest : nullptr;
}

std::string lining_of(const SurfaceComponent& cavity, const Structure& structure) {
    std::string text;
    for (const std::uint32_t residue : lining_residues(structure, cavity))
        text.append(text.empty() ? "" : ", ").append(residue_label(structure.residues[residue]));
    return text;
}

ListedCavity from_mesh(const Wall& wall) {
    return {.area = wall.measures.area,
            .volume = -wall.measures.volume,
            .centre = wall.centre,
            .radius = wall.radius,
            .component = wall.component};
}

ListedCavity from_measures(const SurfaceComponent& cavity, const Wall* wall, const Structure& structure) {
    return {.area = cavity.ses_area,
            .volume = cavity.ses_volume,
            .centre = cavity.centre,
            .radius = wall != nullptr ? wall->radius : 2.0 * std::cbrt(cavity.ses_volume),
            .component = wall != nullptr ? wall->component : kNone,
            .lining = lining_of(cavity, structure)};
}

}  // namespace

std::vector<ListedCavity> list_cavities(const Mesh& mesh, const Structure& structure,
                                        std::span<const SurfaceComponent> components) {
    const std::vector<Wall> walls = walls_of(mesh);
    std::vector<ListedCavity> listed;
    for (const SurfaceComponent& c : components)
        if (c.kind == ComponentKind::Cavity) listed.push_back(from_measures(c, wall_of(c, walls), structure));
    if (components.empty())
        for (const Wall& wall : walls) listed.push_back(from_mesh(wall));
    std::stable_sort(listed.begin(), listed.end(),
                     [](const ListedCavity& a, const ListedCavity& b) { return a.volume > b.volume; });
    return listed;
}

}  // namespace meniscus
