// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <cmath>

#include "meniscus/pockets.h"
#include "space/box_tree.h"

namespace meniscus {

Volume pocket_volume(const Pockets& pockets, VolumeContent content) {
    Box box;
    for (const PocketVoxel& voxel : pockets.voxels) box.include(voxel.position);
    if (pockets.voxels.empty()) box.include(Vec3{});
    const double spacing = pockets.options.spacing;
    const auto place = [&](double at, double from) {
        return static_cast<std::size_t>(std::lround((at - from) / spacing));
    };
    Volume volume;
    volume.grid = {
        {place(box.high.x, box.low.x) + 1, place(box.high.y, box.low.y) + 1, place(box.high.z, box.low.z) + 1},
        box.low,
        {spacing, spacing, spacing}};
    volume.values.resize(volume.grid.size());
    for (const PocketVoxel& voxel : pockets.voxels) {
        const Vec3& p = voxel.position;
        const std::size_t node = volume.grid.index(place(p.x, box.low.x), place(p.y, box.low.y), place(p.z, box.low.z));
        if (content == VolumeContent::Probability)
            volume.values[node] = voxel.probability;
        else if (voxel.pocket != kNone)
            volume.values[node] = static_cast<float>(pockets.pockets[voxel.pocket].rank);
    }
    return volume;
}

}  // namespace meniscus
