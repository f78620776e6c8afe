// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/distance_band.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <numeric>

#include "core/parallel.h"

namespace meniscus {
namespace {

constexpr std::size_t kGroupsPerChunk = 2;
constexpr double kLargestGroup = 16.0;  // Å: blocks within this share one descent of the trees
constexpr int kLongestShift = 2;
constexpr double kAboveOne = 1.0 + 1e-9;  // for rounding

// Clamps to ±limit; a NaN (0/0 on the SAS itself) becomes the limit.
double clamped(double value, double limit) { return value > -limit ? (value < limit ? value : limit) : -limit; }

Box box_of_nodes(const Vec3& corner, int edge, double spacing) {
    const double length = (edge - 1) * spacing;
    return {corner, corner + Vec3{length, length, length}};
}

// Of a unit's first node from the block's, in spacings.
Vec3 unit_steps(int unit) {
    return BlockDistance::kUnitEdge * Vec3{1.0 * (unit & 1), 1.0 * (unit >> 1 & 1), 1.0 * (unit >> 2)};
}

// Calls visit(point of the unit, node of the block).
template <class Visit>
void for_each_node(int unit, const Visit& visit) {
    constexpr int kEdge = BlockDistance::kUnitEdge;
    const int first = kEdge * node_in_block(unit & 1, unit >> 1 & 1, unit >> 2);
    std::size_t point = 0;
    for (int z = 0; z < kEdge; ++z)
        for (int y = 0; y < kEdge; ++y)
            for (int x = 0; x < kEdge; ++x) {
                const int node = first + node_in_block(x, y, z);
                visit(point++, static_cast<std::size_t>(node));
            }
}

// Of a node of a unit from its first one, in spacings.
Vec3 node_offset(int n) {
    constexpr int kEdge = BlockDistance::kUnitEdge;
    const int y = n / kEdge % kEdge;
    const int z = n / (kEdge * kEdge);
    return {static_cast<double>(n % kEdge), static_cast<double>(y), static_cast<double>(z)};
}

// Blocks in cubes of a power of two on an edge, for which features are gathered together.
class BlockGroups {
public:
    explicit BlockGroups(const BlockGrid& grid) : shift_(shift_of(grid.spacing())), blocks_(grid.block_count()) {
        std::iota(blocks_.begin(), blocks_.end(), BlockId{0});
        const auto group = [&](BlockId b) { return group_of(grid.coord(b)); };
        std::stable_sort(blocks_.begin(), blocks_.end(), [&](BlockId a, BlockId b) { return group(a) < group(b); });
        for (std::size_t i = 0; i < blocks_.size(); ++i)
            if (i == 0 || group(blocks_[i - 1]) != group(blocks_[i])) begins_.push_back(i);
        begins_.push_back(blocks_.size());
    }

    std::size_t size() const { return begins_.size() - 1; }
    std::span<const BlockId> blocks(std::size_t group) const {
        return std::span(blocks_).subspan(begins_[group], begins_[group + 1] - begins_[group]);
    }

private:
    static int shift_of(double spacing) {
        int shift = 0;
        while (shift < kLongestShift && 2.0 * (kBlockEdge << shift) * spacing <= kLargestGroup) ++shift;
        return shift;
    }
    BlockCoord group_of(const BlockCoord& c) const { return {c.z >> shift_, c.y >> shift_, c.x >> shift_}; }

    int shift_;
    std::vector<BlockId> blocks_;
    std::vector<std::size_t> begins_;
};

}  // namespace

BlockDistance::BlockDistance(const AccessibleSurface& surface, double spacing, double margin)
    : spacing_(spacing),
      margin_(margin),
      half_unit_(kAboveOne * 0.5 * std::numbers::sqrt3 * (kUnitEdge - 1) * spacing),
      around_(surface, margin + half_unit_),
      block_(surface, margin + half_unit_),
      batch_(surface) {
    for (int n = 0; n < kUnitNodes; ++n) offsets_[n] = spacing * node_offset(n);
}

// The distance changes by at most 1 per Å: that of its middle settles a unit that is far from the band.
void BlockDistance::screen_units(const Vec3& corner) {
    const double to_middle = 0.5 * (kUnitEdge - 1);
    Vec3 middles[kUnits];
    Box box;
    for (int u = 0; u < kUnits; ++u) {
        middles[u] = corner + spacing_ * (unit_steps(u) + to_middle * Vec3{1.0, 1.0, 1.0});
        box.include(middles[u]);
    }
    const Claim all = batch_.start(block_, box, block_.margin());
    if (all == Claim::Open) batch_.find(middles);
    for (std::size_t u = 0; u < kUnits; ++u) sides_[u] = all == Claim::Open ? batch_.claim(u) : all;
}

void BlockDistance::evaluate(const Vec3& corner, const BlockSamples& samples) {
    block_.gather_from(around_, box_of_nodes(corner, kBlockEdge, spacing_));
    screen_units(corner);
    for (int u = 0; u < kUnits; ++u) evaluate_unit(u, corner + spacing_ * unit_steps(u), samples);
}

void BlockDistance::evaluate_unit(int unit, const Vec3& corner, const BlockSamples& samples) {
    Claim side = sides_[unit];
    if (side != Claim::Below && side != Claim::Above)
        side = batch_.start(block_, box_of_nodes(corner, kUnitEdge, spacing_), margin_);
    if (side == Claim::Below || side == Claim::Above) return fill_unit(unit, side, samples);
    for (int n = 0; n < kUnitNodes; ++n) points_[n] = corner + offsets_[n];
    batch_.find(points_);
    for_each_node(unit, [&](std::size_t point, std::size_t node) { write(point, node, samples); });
}

void BlockDistance::fill_unit(int unit, Claim side, const BlockSamples& samples) const {
    const auto distance = static_cast<float>(side == Claim::Below ? -margin_ : margin_);
    for_each_node(unit, [&](std::size_t, std::size_t node) {
        samples.distance[node] = distance;
        if (!samples.curvature.empty()) samples.curvature[node] = 0.0F;
    });
}

void BlockDistance::write(std::size_t point, std::size_t node, const BlockSamples& samples) const {
    const double side = batch_.claim(point) == Claim::Below ? -margin_ : margin_;
    const double s = batch_.found(point) ? batch_.signed_distance(point) : side;
    samples.distance[node] = static_cast<float>(clamped(s, margin_));
    if (samples.curvature.empty()) return;
    const bool within = std::abs(s) < margin_;
    samples.curvature[node] = within ? static_cast<float>(clamped(batch_.mean_curvature(point), 1.0 / spacing_)) : 0.0F;
}

DistanceBand sample_distance(const AccessibleSurface& surface, const BlockGrid& grid, double margin,
                             BandFields fields) {
    DistanceBand band;
    band.margin = margin;
    band.distance.resize(grid.node_count());
    if (fields == BandFields::DistanceAndCurvature) band.curvature.resize(grid.node_count());
    const BlockGroups groups(grid);
    parallel_chunks(groups.size(), kGroupsPerChunk, [&](std::size_t begin, std::size_t end) {
        const auto evaluator = std::make_unique<BlockDistance>(surface, grid.spacing(), margin);
        for (std::size_t g = begin; g < end; ++g) {
            Box box;
            for (const BlockId b : groups.blocks(g))
                box.include(box_of_nodes(grid.corner(b), kBlockEdge, grid.spacing()));
            evaluator->enter(box);
            for (const BlockId b : groups.blocks(g)) {
                const std::size_t first = std::size_t{b} * kBlockNodes;
                evaluator->evaluate(grid.corner(b),
                                    {std::span<float, kBlockNodes>(band.distance.data() + first, kBlockNodes),
                                     band.curvature.empty() ? std::span<float>()
                                                            : std::span(band.curvature).subspan(first, kBlockNodes)});
            }
        }
    });
    return band;
}

}  // namespace meniscus
