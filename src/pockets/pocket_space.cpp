// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pockets/pocket_space.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "band/surface_blocks.h"
#include "core/workspaces.h"
#include "meniscus/errors.h"
#include "nearest/box_features.h"
#include "platform/memory.h"
#include "space/box_tree.h"

namespace meniscus {
namespace {

constexpr double kMargin = 3.0;  // Å around the atoms' centres
constexpr std::size_t kBlocksPerTask = 4;
constexpr std::size_t kRow = 64;  // nodes of a batch

using NodeDistances = std::array<double, kBlockNodes>;

Lattice lattice_of(std::span<const Vec3> centres, double spacing) {
    const Vec3 low = box_of(centres).low;
    return {spacing, {std::floor(low.x - kMargin), std::floor(low.y - kMargin), std::floor(low.z - kMargin)}};
}

Box box_of_block(const Lattice& lattice, const BlockCoord& block) {
    const double last = (kBlockEdge - 1) * lattice.spacing;
    const Vec3 corner = lattice.corner(block);
    return {corner, corner + Vec3{last, last, last}};
}

std::vector<BlockCoord> around(std::span<const BlockCoord> blocks, int reach) {
    std::vector<BlockCoord> result(blocks.begin(), blocks.end());
    const auto spread = [&](auto member) {
        const std::size_t count = result.size();
        for (std::size_t i = 0; i < count; ++i)
            for (int d = -reach; d <= reach; ++d) {
                if (d == 0) continue;
                BlockCoord other = result[i];
                other.*member += d;
                result.push_back(other);
            }
        std::sort(result.begin(), result.end());
        result.erase(std::unique(result.begin(), result.end()), result.end());
    };
    spread(&BlockCoord::x);
    spread(&BlockCoord::y);
    spread(&BlockCoord::z);
    return result;
}

// Blocks that may hold a point inside the SES of the large probe: no such point is farther than the probe's radius from
// an atom.
std::vector<BlockCoord> candidates(const Lattice& lattice, std::span<const Vec3> centres, double reach) {
    std::vector<BlockCoord> blocks;
    blocks.reserve(centres.size());
    for (const Vec3& centre : centres) blocks.push_back(lattice.block_of(centre));
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    return around(blocks, static_cast<int>(std::ceil(reach / lattice.block_edge())));
}

double ramp(double distance, double spacing) { return std::clamp(0.5 - distance / spacing, 0.0, 1.0); }

// Of one block: both distances at its nodes, unless no cube of it reaches into pocket space.
class BlockDistances {
public:
    BlockDistances(const AccessibleSurface& small, const AccessibleSurface& large, const Lattice& lattice)
        : small_(small), large_(large), lattice_(lattice) {}

    bool find(const BlockCoord& block, NodeDistances& inner, NodeDistances& outer) {
        const Box box = box_of_block(lattice_, block);
        const double reach = 0.5 * norm(box.high - box.low) + lattice_.spacing;
        if (large_.enter(box) > reach || small_.enter(box) < -reach) return false;
        set(box, large_, outer);
        if (std::none_of(outer.begin(), outer.end(), [&](double d) { return d < 0.5 * lattice_.spacing; }))
            return false;
        set(box, small_, inner);
        return true;
    }

private:
    void set(const Box& box, BoxFeatures& exact, NodeDistances& distances) const {
        std::array<Vec3, kRow> points;
        for (int z = 0; z < kBlockEdge; ++z) {
            for (int y = 0; y < kBlockEdge; ++y)
                for (int x = 0; x < kBlockEdge; ++x)
                    points[static_cast<std::size_t>(node_in_block(x, y, 0))] =
                        box.low + lattice_.spacing * Vec3{double(x), double(y), double(z)};
            exact.find(points, std::span(distances).subspan(static_cast<std::size_t>(node_in_block(0, 0, z)), kRow));
        }
    }

    BoxFeatures small_;
    BoxFeatures large_;
    const Lattice& lattice_;
};

struct BlockVoxels {
    std::vector<std::uint16_t> nodes;
    std::vector<double> inner;
    std::vector<double> outer;
    std::vector<double> shares;
};

std::vector<BlockVoxels> voxels_of_blocks(const AccessibleSurface& small, const AccessibleSurface& large,
                                          const Lattice& lattice, std::span<const BlockCoord> blocks) {
    std::vector<BlockVoxels> found(blocks.size());
    parallel_chunks_with(
        blocks.size(), kBlocksPerTask, [&] { return std::make_unique<BlockDistances>(small, large, lattice); },
        [&](std::size_t begin, std::size_t end, BlockDistances& distances) {
            NodeDistances inner;
            NodeDistances outer;
            for (std::size_t b = begin; b < end; ++b) {
                if (!distances.find(blocks[b], inner, outer)) continue;
                for (std::size_t i = 0; i < kBlockNodes; ++i) {
                    const double share = ramp(outer[i], lattice.spacing) - ramp(inner[i], lattice.spacing);
                    if (share <= 0.0) continue;
                    found[b].nodes.push_back(static_cast<std::uint16_t>(i));
                    found[b].inner.push_back(inner[i]);
                    found[b].outer.push_back(outer[i]);
                    found[b].shares.push_back(share);
                }
            }
        });
    return found;
}

std::vector<BlockCoord> occupied(std::span<const BlockCoord> blocks, std::span<const BlockVoxels> found) {
    std::vector<BlockCoord> result;
    for (std::size_t b = 0; b < blocks.size(); ++b)
        if (!found[b].nodes.empty()) result.push_back(blocks[b]);
    return result;
}

void append(std::vector<double>& list, const std::vector<double>& more) {
    list.insert(list.end(), more.begin(), more.end());
}

}  // namespace

VoxelId PocketSpace::voxel_near(BlockId block, int x, int y, int z) const {
    const BlockId holder =
        grid.neighbours(block)[static_cast<std::size_t>(neighbour_slot(side_of(x), side_of(y), side_of(z)))];
    if (holder == kNoBlock) return kNoVoxel;
    const int node = node_in_block(place_in_block(x), place_in_block(y), place_in_block(z));
    return voxel_of[std::size_t{holder} * kBlockNodes + static_cast<std::size_t>(node)];
}

VoxelId PocketSpace::voxel_at(const Vec3& point) const {
    const Vec3 steps = (1.0 / grid.spacing()) * (point - grid.origin());
    const auto x = static_cast<std::int64_t>(std::floor(steps.x + 0.5));
    const auto y = static_cast<std::int64_t>(std::floor(steps.y + 0.5));
    const auto z = static_cast<std::int64_t>(std::floor(steps.z + 0.5));
    const BlockId block = grid.find({.z = block_of_node(z), .y = block_of_node(y), .x = block_of_node(x)});
    if (block == kNoBlock) return kNoVoxel;
    return voxel_near(block, place_in_block(x), place_in_block(y), place_in_block(z));
}

PocketSpace pocket_space(const AccessibleSurface& small, const AccessibleSurface& large, std::span<const Vec3> centres,
                         double spacing) {
    const Lattice lattice = lattice_of(centres, spacing);
    const CanonicalAtoms& atoms = large.data().atoms;
    const double thickest = *std::max_element(atoms.radii.begin(), atoms.radii.end());
    const std::vector<BlockCoord> blocks = candidates(lattice, centres, thickest + large.probe() + spacing);
    const std::vector<BlockVoxels> found = voxels_of_blocks(small, large, lattice, blocks);
    PocketSpace space{BlockGrid(spacing, lattice.origin, around(occupied(blocks, found), 1)), {}, {}, {}, {}, {}};
    if (space.grid.node_count() >= kNoVoxel)
        throw LimitError("the grid of pockets has more than 4e9 nodes; choose a coarser spacing");
    space.voxel_of.assign(space.grid.node_count(), kNoVoxel);
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        if (found[b].nodes.empty()) continue;
        const std::size_t first = std::size_t{space.grid.find(blocks[b])} * kBlockNodes;
        for (const std::uint16_t node : found[b].nodes) {
            space.voxel_of[first + node] = static_cast<VoxelId>(space.nodes.size());
            space.nodes.push_back(static_cast<std::uint32_t>(first + node));
        }
        append(space.inner, found[b].inner);
        append(space.outer, found[b].outer);
        append(space.shares, found[b].shares);
    }
    return space;
}

}  // namespace meniscus
