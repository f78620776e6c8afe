// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pockets/place_regions.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/parallel.h"
#include "meniscus/measures.h"
#include "pockets/voxel_neighbours.h"
#include "space/box_tree.h"

namespace meniscus {
namespace {

// A connected part of what is in reach of a place.
struct Part {
    std::vector<VoxelId> voxels;
    double size = 0.0;  // in cubes
    bool closed = false;
    bool named = false;  // holds a point of the place
};

std::vector<std::uint32_t> nearest_places(const PocketSpace& space, std::span<const PocketPlace> places) {
    std::vector<std::uint32_t> labels(space.size(), kNone);
    std::vector<double> nearest(space.size(), std::numeric_limits<double>::infinity());
    for (std::uint32_t p = 0; p < places.size(); ++p) {
        const PocketPlace& place = places[p];
        const Box box = box_of(place.points);
        const double squared_reach = place.reach * place.reach;
        parallel_for(space.size(), 1024, [&](std::size_t v) {
            const Vec3 at = space.position(static_cast<VoxelId>(v));
            if (box.squared_distance(at) > squared_reach) return;
            for (const Vec3& point : place.points) {
                const double squared = squared_norm(at - point);
                if (squared > squared_reach || squared >= nearest[v]) continue;
                nearest[v] = squared;
                labels[v] = p;
            }
        });
    }
    return labels;
}

class PartFinder {
public:
    PartFinder(const PocketSpace& space, std::span<const std::uint32_t> cavities, std::span<const std::uint32_t> labels)
        : space_(space), cavities_(cavities), labels_(labels), part_of_(space.size(), kNone) {}

    // Those of each place.
    std::vector<std::vector<Part>> find(std::span<const PocketPlace> places) {
        std::vector<std::vector<Part>> parts(places.size());
        for (VoxelId v = 0; v < space_.size(); ++v)
            if (labels_[v] != kNone && part_of_[v] == kNone) {
                std::vector<Part>& list = parts[labels_[v]];
                list.push_back(grow(v, static_cast<std::uint32_t>(list.size())));
            }
        for (std::uint32_t p = 0; p < places.size(); ++p)
            for (const Vec3& point : places[p].points)
                if (const VoxelId v = space_.voxel_at(point); v != kNoVoxel && labels_[v] == p)
                    parts[p][part_of_[v]].named = true;
        return parts;
    }

private:
    Part grow(VoxelId from, std::uint32_t number) {
        Part part{{from}, 0.0, cavities_[from] != kNone, false};
        part_of_[from] = number;
        for (std::size_t i = 0; i < part.voxels.size(); ++i) {
            const VoxelId voxel = part.voxels[i];
            part.size += space_.shares[voxel];
            for_each_neighbour(space_, voxel, [&](VoxelId other) {
                if (part_of_[other] != kNone || labels_[other] != labels_[from] || cavities_[other] != cavities_[from])
                    return;
                part_of_[other] = number;
                part.voxels.push_back(other);
            });
        }
        return part;
    }

    const PocketSpace& space_;
    std::span<const std::uint32_t> cavities_;
    std::span<const std::uint32_t> labels_;
    std::vector<std::uint32_t> part_of_;
};

std::vector<Part> those_that_count(std::vector<Part> parts) {
    const auto is_named = [](const Part& part) { return part.named; };
    if (std::none_of(parts.begin(), parts.end(), is_named)) {
        const auto largest =
            std::max_element(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.size < b.size; });
        if (largest != parts.end()) largest->named = true;
    }
    std::erase_if(parts, [](const Part& part) { return !part.named; });
    if (std::any_of(parts.begin(), parts.end(), [](const Part& part) { return !part.closed; }))
        std::erase_if(parts, [](const Part& part) { return part.closed; });
    return parts;
}

}  // namespace

std::vector<std::uint32_t> place_regions(const PocketSpace& space, std::span<const PocketPlace> places,
                                         std::span<const std::uint32_t> cavities) {
    const std::vector<std::uint32_t> nearest = nearest_places(space, places);
    std::vector<std::vector<Part>> parts = PartFinder(space, cavities, nearest).find(places);
    std::vector<std::uint32_t> labels(space.size(), kNone);
    for (std::uint32_t p = 0; p < places.size(); ++p)
        for (const Part& part : those_that_count(std::move(parts[p])))
            for (const VoxelId v : part.voxels) labels[v] = p;
    return labels;
}

}  // namespace meniscus
