// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pockets/cavity_voxels.h"

#include <algorithm>
#include <map>

#include "core/parallel.h"
#include "exact/ses_patches.h"
#include "space/box_tree.h"

namespace meniscus {
namespace {

// A cavity's index among the measured components, and a box that holds it.
struct Cavity {
    std::uint32_t component = 0;
    Box box;
};

std::vector<Cavity> cavities_of(const ExactSurface& exact) {
    const Measures& measures = exact.measures();
    std::vector<Cavity> result;
    for (std::uint32_t i = 0; i < measures.components.size(); ++i) {
        const SurfaceComponent& component = measures.components[i];
        if (component.kind != ComponentKind::Cavity) continue;
        Cavity cavity{i, {}};
        for (const std::uint32_t atom : component.atoms) cavity.box.include(exact.balls().centres[atom]);
        result.push_back(cavity);
    }
    return result;
}

bool contains(const Box& box, const Vec3& p) {
    return p.x >= box.low.x && p.x <= box.high.x && p.y >= box.low.y && p.y <= box.high.y && p.z >= box.low.z &&
           p.z <= box.high.z;
}

}  // namespace

std::vector<std::uint32_t> cavity_voxels(const PocketSpace& space, const ExactSurface& exact) {
    std::vector<std::uint32_t> result(space.size(), kNone);
    const std::vector<Cavity> cavities = cavities_of(exact);
    if (cavities.empty()) return result;
    const SesPatches patches(exact.accessible(), 0);
    std::map<std::uint32_t, std::uint32_t> cavity_of;  // by component of `patches`
    for (const Cavity& cavity : cavities)
        cavity_of[patches.component_at(exact.measures().components[cavity.component].inscribed_centre)] =
            cavity.component;
    parallel_for(space.size(), 256, [&](std::size_t v) {
        const Vec3 point = space.position(static_cast<VoxelId>(v));
        if (std::none_of(cavities.begin(), cavities.end(), [&](const Cavity& c) { return contains(c.box, point); }))
            return;
        const auto found = cavity_of.find(patches.component_at(point));
        if (found != cavity_of.end()) result[v] = found->second;
    });
    return result;
}

}  // namespace meniscus
