// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "grid/block_grid.h"
#include "meniscus/pockets.h"
#include "mesh/extract.h"

namespace meniscus {
namespace {

// A cubic B-spline at 0, 1/2, 1 and 3/2 of its spacing: at all whole numbers, as at all halves, they add up to 1.
constexpr std::array kSpline{2.0 / 3.0, 23.0 / 48.0, 1.0 / 6.0, 1.0 / 48.0};
constexpr int kReach = 3;  // of the spline, in steps of half the spacing

using Node = std::array<std::int64_t, 3>;

// Numbers for places on a grid through the voxels, whose steps may be a part of their spacing.
class NodeNumbers {
public:
    NodeNumbers(const Pockets& pockets, double step)
        : step_(step), origin_(pockets.voxels.empty() ? Vec3{} : pockets.voxels.front().position) {}

    double step() const { return step_; }
    const Vec3& origin() const { return origin_; }
    Node nearest(const Vec3& point) const {
        const Vec3 from = (1.0 / step_) * (point - origin_);
        return {std::llround(from.x), std::llround(from.y), std::llround(from.z)};
    }

private:
    double step_;
    Vec3 origin_;
};

BlockCoord block_of(const Node& node) {
    return {block_of_node(node[2]), block_of_node(node[1]), block_of_node(node[0])};
}

std::size_t entry_of(BlockId block, const Node& node) {
    return std::size_t{block} * kBlockNodes +
           static_cast<std::size_t>(
               node_in_block(place_in_block(node[0]), place_in_block(node[1]), place_in_block(node[2])));
}

// Blocks with all nodes up to `reach` beside the given ones along each axis; reach is less than a block's edge.
BlockGrid grid_around(const NodeNumbers& numbers, std::span<const Node> nodes, int reach) {
    std::set<BlockCoord> blocks;
    for (const Node& n : nodes)
        for (const int dz : {-reach, reach})
            for (const int dy : {-reach, reach})
                for (const int dx : {-reach, reach}) blocks.insert(block_of({n[0] + dx, n[1] + dy, n[2] + dz}));
    return {numbers.step(), numbers.origin(), {blocks.begin(), blocks.end()}};
}

constexpr std::size_t kNoEntry = ~std::size_t{0};

// Calls visit(entry, steps) for a node and those beside it; kNoEntry for those in blocks that the grid has not.
template <class Visit>
void for_each_around(const BlockGrid& grid, const Node& node, int reach, const Visit& visit) {
    const BlockId block = grid.find(block_of(node));
    const auto& around = grid.neighbours(block);
    const std::array at{place_in_block(node[0]), place_in_block(node[1]), place_in_block(node[2])};
    for (int dz = -reach; dz <= reach; ++dz)
        for (int dy = -reach; dy <= reach; ++dy)
            for (int dx = -reach; dx <= reach; ++dx) {
                const int slot = neighbour_slot(side_of(at[0] + dx), side_of(at[1] + dy), side_of(at[2] + dz));
                const BlockId there = around[static_cast<std::size_t>(slot)];
                visit(there == kNoBlock ? kNoEntry : entry_of(there, {node[0] + dx, node[1] + dy, node[2] + dz}),
                      std::array{dx, dy, dz});
            }
}

// How full of a pocket space is, smoothed.
std::vector<float> fillings(const BlockGrid& grid, std::span<const Node> nodes, std::span<const float> shares) {
    std::vector<float> filled(grid.node_count());
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for_each_around(grid, nodes[i], kReach, [&](std::size_t entry, const std::array<int, 3>& d) {
            double weight = shares[i];
            for (const int along : d) weight *= kSpline[static_cast<std::size_t>(std::abs(along))];
            filled[entry] += static_cast<float>(weight);
        });
    return filled;
}

// The value that is exceeded in a given volume.
float level_for(std::span<const float> filled, double volume, double step) {
    std::vector<float> values;
    std::copy_if(filled.begin(), filled.end(), std::back_inserter(values), [](float value) { return value > 0.0F; });
    const auto count = static_cast<std::size_t>(std::lround(volume / (step * step * step)));
    const std::size_t last = std::clamp<std::size_t>(count, 1, values.size() - 1);
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(last), values.end(),
                     std::greater<>{});
    const float beyond = values[last];
    const float within = *std::min_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(last));
    return 0.5F * (within + beyond);
}

void add_normals(Mesh& mesh) {
    std::vector<Vec3> sums(mesh.vertices.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 area = cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]);
        for (const VertexId v : {a, b, c}) sums[v] += area;
    }
    for (const Vec3& sum : sums) mesh.normals.push_back(to_small(norm(sum) > 0.0 ? normalised(sum) : Vec3{0, 0, 1}));
}

Mesh body_of(const Pockets& pockets, const Pocket& pocket, const NodeNumbers& numbers) {
    std::vector<Node> nodes;
    std::vector<float> shares;
    for (const std::uint32_t v : pocket.voxels) {
        nodes.push_back(numbers.nearest(pockets.voxels[v].position));
        shares.push_back(pockets.voxels[v].share);
    }
    if (std::all_of(shares.begin(), shares.end(), [](float share) { return share <= 0.0F; })) return {};
    const BlockGrid grid = grid_around(numbers, nodes, kReach + 1);  // one more for the outside of the last cells
    std::vector<float> values = fillings(grid, nodes, shares);
    const float level = level_for(values, pocket.volume, numbers.step());
    for (float& value : values) value = level - value;
    Mesh body = extract_zero_set(grid, values);
    add_normals(body);
    return body;
}

void append(Mesh& all, const Mesh& part, std::uint32_t component) {
    const auto first = static_cast<VertexId>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), part.vertices.begin(), part.vertices.end());
    all.normals.insert(all.normals.end(), part.normals.begin(), part.normals.end());
    all.components.insert(all.components.end(), part.vertices.size(), component);
    for (const Triangle& t : part.triangles) all.triangles.push_back({first + t[0], first + t[1], first + t[2]});
}

// Finds the pocket to which most of the space around a point belongs.
class VoxelsAround {
public:
    explicit VoxelsAround(const Pockets& pockets)
        : pockets_(pockets),
          numbers_(pockets, pockets.options.spacing),
          nodes_(nodes_of(pockets, numbers_)),
          grid_(grid_around(numbers_, nodes_, 1)),
          voxel_at_(grid_.node_count(), kNone) {
        for (std::uint32_t v = 0; v < nodes_.size(); ++v)
            voxel_at_[entry_of(grid_.find(block_of(nodes_[v])), nodes_[v])] = v;
    }

    /// An index into Pockets::pockets, or kNone where most belongs to none.
    std::uint32_t pocket_at(const Vec3& point) const {
        const Node middle = numbers_.nearest(point);
        std::vector<std::pair<std::uint32_t, double>> votes;
        if (grid_.find(block_of(middle)) == kNoBlock) return kNone;
        for_each_around(grid_, middle, 1, [&](std::size_t entry, const std::array<int, 3>&) {
            if (entry == kNoEntry || voxel_at_[entry] == kNone) return;
            const PocketVoxel& voxel = pockets_.voxels[voxel_at_[entry]];
            const double weight = voxel.share * std::max(0.0, kFar - norm(point - voxel.position) / numbers_.step());
            const auto known =
                std::find_if(votes.begin(), votes.end(), [&](const auto& vote) { return vote.first == voxel.pocket; });
            if (known == votes.end())
                votes.emplace_back(voxel.pocket, weight);
            else
                known->second += weight;
        });
        const auto most = std::max_element(votes.begin(), votes.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        return most == votes.end() || most->second <= 0.0 ? kNone : most->first;
    }

private:
    static constexpr double kFar = 1.5;  // spacings: where a voxel has no say

    static std::vector<Node> nodes_of(const Pockets& pockets, const NodeNumbers& numbers) {
        std::vector<Node> nodes;
        for (const PocketVoxel& voxel : pockets.voxels) nodes.push_back(numbers.nearest(voxel.position));
        return nodes;
    }

    const Pockets& pockets_;
    NodeNumbers numbers_;
    std::vector<Node> nodes_;
    BlockGrid grid_;
    std::vector<std::uint32_t> voxel_at_;  // per node
};

float rank_of(const Pockets& pockets, std::uint32_t pocket) {
    return pocket == kNone ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(pockets.pockets[pocket].rank);
}

}  // namespace

Mesh pocket_bodies(const Pockets& pockets) {
    const NodeNumbers numbers(pockets, 0.5 * pockets.options.spacing);
    Mesh bodies;
    for (std::uint32_t p = 0; p < pockets.pockets.size(); ++p)
        append(bodies, body_of(pockets, pockets.pockets[p], numbers), p);
    VertexValues ranks{kPocketValues, {}};
    for (const std::uint32_t p : bodies.components) ranks.values.push_back(rank_of(pockets, p));
    bodies.values.push_back(std::move(ranks));
    return bodies;
}

VertexValues pocket_values(const Pockets& pockets, const Mesh& mesh) {
    const VoxelsAround around(pockets);
    VertexValues ranks{kPocketValues, {}};
    ranks.values.reserve(mesh.vertices.size());
    for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
        const Vec3 normal = mesh.normals[v];
        ranks.values.push_back(
            rank_of(pockets, around.pocket_at(mesh.vertices[v] + 0.5 * pockets.options.spacing * normal)));
    }
    return ranks;
}

}  // namespace meniscus
