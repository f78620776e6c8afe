// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/distance_band.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "core/fresh_memory.h"
#include "core/group_by.h"
#include "core/parallel.h"

namespace meniscus {
namespace {

constexpr std::size_t kGroupsPerChunk = 2;
constexpr double kLargestGroup = 16.0;  // Å: blocks within this share one descent of the trees
constexpr int kLongestShift = 2;
constexpr double kAboveOne = 1.0 + 1e-9;  // for rounding
constexpr double kSingleSlack = 1e-5;     // the same in single precision, of the largest length

// Of a unit's middle from its first node, in spacings.
constexpr double kHalfEdge = 0.5 * (BlockDistance::kUnitEdge - 1);
constexpr Vec3 kToMiddle{kHalfEdge, kHalfEdge, kHalfEdge};

Box box_of_nodes(const Vec3& corner, int edge, double spacing) {
    const double length = (edge - 1) * spacing;
    return {corner, corner + Vec3{length, length, length}};
}

// Of a unit's first node from the block's, in spacings.
Vec3 unit_steps(int unit) {
    return BlockDistance::kUnitEdge * Vec3{1.0 * (unit & 1), 1.0 * (unit >> 1 & 1), 1.0 * (unit >> 2)};
}

// Calls visit(node of the unit, node of the block) for the first node of each row along x.
template <class Visit>
void for_each_row(int unit, const Visit& visit) {
    constexpr int kEdge = BlockDistance::kUnitEdge;
    const int first = kEdge * node_in_block(unit & 1, unit >> 1 & 1, unit >> 2);
    std::size_t point = 0;
    for (int z = 0; z < kEdge; ++z)
        for (int y = 0; y < kEdge; ++y, point += kEdge) {
            const int node = first + node_in_block(0, y, z);
            visit(point, static_cast<std::size_t>(node));
        }
}

// Of a node of a unit from its first one, in spacings.
Vec3 node_offset(int n) {
    constexpr int kEdge = BlockDistance::kUnitEdge;
    const int y = n / kEdge % kEdge;
    const int z = n / (kEdge * kEdge);
    return {static_cast<double>(n % kEdge), static_cast<double>(y), static_cast<double>(z)};
}

// Blocks in cubes of a power of two on an edge, for which features are gathered together, and in halves of these cubes.
class BlockGroups {
public:
    explicit BlockGroups(const BlockGrid& grid) : grid_(grid), shift_(shift_of(grid.spacing())) {
        std::vector<BlockCoord> places;
        places.reserve(grid.block_count());
        for (const BlockCoord& c : grid.coords()) places.push_back(coarser(c, shift_));
        groups_ = group_by<BlockCoordHash>(places);
        for (std::size_t g = 0; g < size(); ++g) {
            const auto first = groups_.items.begin();
            std::stable_sort(first + static_cast<std::ptrdiff_t>(groups_.begins[g]),
                             first + static_cast<std::ptrdiff_t>(groups_.begins[g + 1]),
                             [&](BlockId a, BlockId b) { return part(a) < part(b); });
        }
    }

    std::size_t size() const { return groups_.size(); }
    std::span<const BlockId> blocks(std::size_t group) const { return groups_[group]; }
    // Calls visit(blocks) for each part of a group.
    template <class Visit>
    void for_each_part(std::size_t group, const Visit& visit) const {
        const std::span<const BlockId> all = blocks(group);
        std::size_t begin = 0;
        for (std::size_t i = 1; i <= all.size(); ++i)
            if (i == all.size() || part(all[i]) != part(all[begin])) {
                visit(all.subspan(begin, i - begin));
                begin = i;
            }
    }

private:
    static constexpr int kPartShift = 1;

    BlockCoord part(BlockId b) const { return coarser(grid_.coord(b), std::max(0, shift_ - kPartShift)); }
    static BlockCoord coarser(const BlockCoord& c, int shift) { return {c.z >> shift, c.y >> shift, c.x >> shift}; }
    static int shift_of(double spacing) {
        int shift = 0;
        while (shift < kLongestShift && 2.0 * (kBlockEdge << shift) * spacing <= kLargestGroup) ++shift;
        return shift;
    }

    const BlockGrid& grid_;
    int shift_;
    Groups groups_;
};

Box box_of_blocks(const BlockGrid& grid, std::span<const BlockId> blocks) {
    Box box;
    for (const BlockId b : blocks) box.include(box_of_nodes(grid.corner(b), kBlockEdge, grid.spacing()));
    return box;
}

BlockSamples samples_of(DistanceBand& band, BlockId block) {
    const std::size_t first = std::size_t{block} * kBlockNodes;
    return {std::span<float, kBlockNodes>(band.distance.data() + first, kBlockNodes),
            band.curvature.empty() ? std::span<float>() : std::span(band.curvature).subspan(first, kBlockNodes)};
}

}  // namespace

BlockDistance::BlockDistance(const AccessibleSurface& surface, double spacing, double margin)
    : spacing_(spacing),
      margin_(margin),
      half_unit_(kAboveOne * 0.5 * std::numbers::sqrt3 * (kUnitEdge - 1) * spacing),
      slack_(kSingleSlack * (2.0 * half_unit_ + margin + surface.probe())),
      around_(surface, margin + half_unit_),
      part_(surface, margin + half_unit_),
      block_(surface, margin + half_unit_),
      batch_(surface) {
    const double near_foot = surface.probe() - margin - slack_;
    if (near_foot > 0.0) near_foot2_ = near_foot * near_foot;
    for (int n = 0; n < kUnitNodes; ++n) {
        const auto i = static_cast<std::size_t>(n);
        const Vec3 offset = spacing * node_offset(n);
        const Vec3 step = spacing * (node_offset(n) - kToMiddle);
        offsets_.x[i] = offset.x;
        offsets_.y[i] = offset.y;
        offsets_.z[i] = offset.z;
        steps_.x[i] = static_cast<float>(step.x);
        steps_.y[i] = static_cast<float>(step.y);
        steps_.z[i] = static_cast<float>(step.z);
        from_middle_[i] = static_cast<float>(norm(step));
    }
}

// The distance changes by at most 1 per Å: that of its middle settles a unit that is far from the band.
void BlockDistance::screen_units(const Vec3& corner) {
    Vec3 points[kUnits];
    Box box;
    for (int u = 0; u < kUnits; ++u) {
        points[u] = corner + spacing_ * (unit_steps(u) + kToMiddle);
        box.include(points[u]);
    }
    const Claim all = batch_.start(block_, box, block_.margin());
    if (all == Claim::Open) batch_.find(points);
    for (std::size_t u = 0; u < kUnits; ++u) {
        middles_[u].side = all == Claim::Open ? batch_.claim(u) : all;
        if (all != Claim::Open || !batch_.found(u)) continue;
        middles_[u].distance = batch_.signed_distance(u);
        middles_[u].to_foot = batch_.foot(u) - points[u];
    }
}

void BlockDistance::evaluate(const Vec3& corner, const BlockSamples& samples) {
    curved_ = !samples.curvature.empty();
    block_.gather_from(part_, box_of_nodes(corner, kBlockEdge, spacing_));
    screen_units(corner);
    for (int u = 0; u < kUnits; ++u) evaluate_unit(u, corner + spacing_ * unit_steps(u), samples);
}

void BlockDistance::evaluate_unit(int unit, const Vec3& corner, const BlockSamples& samples) {
    Claim side = middles_[unit].side;
    if (side != Claim::Below && side != Claim::Above)
        side = batch_.start(block_, box_of_nodes(corner, kUnitEdge, spacing_), margin_);
    if (side == Claim::Below || side == Claim::Above) return fill_unit(unit, side, samples);
    screen_nodes(middles_[unit]);
    choose_points(corner);
    sample_points();
    write_unit(unit, samples);
}

void BlockDistance::fill_unit(int unit, Claim side, const BlockSamples& samples) const {
    const auto distance = static_cast<float>(side == Claim::Below ? -margin_ : margin_);
    for_each_row(unit, [&](std::size_t, std::size_t node) {
        std::fill_n(&samples.distance[node], kUnitEdge, distance);
        if (curved_) std::fill_n(&samples.curvature[node], kUnitEdge, 0.0F);
    });
}

// By the change of at most 1 per Å from the middle, and by the middle's foot, which is a point of K.
void BlockDistance::screen_nodes(const Middle& middle) {
    const bool below = middle.distance <= -margin_;
    PointScreen screen;
    screen.foot[0] = static_cast<float>(middle.to_foot.x);
    screen.foot[1] = static_cast<float>(middle.to_foot.y);
    screen.foot[2] = static_cast<float>(middle.to_foot.z);
    screen.near = static_cast<float>(below ? kNever : near_foot2_);
    screen.beyond = static_cast<float>(std::abs(middle.distance) - margin_ - slack_);
    kernels_.screen(screen, steps_, from_middle_, within_);
    std::fill_n(distances_, kUnitNodes, static_cast<float>(below ? -margin_ : margin_));
    if (curved_) std::fill_n(curvatures_, kUnitNodes, 0.0F);
}

void BlockDistance::choose_points(const Vec3& corner) {
    const std::size_t count = marked_positions(std::span(within_.at).first(kUnitNodes), nodes_);
    const auto choose = [&](double from, const LaneArray<double>& offsets, LaneArray<double>& chosen) {
        if (count == kUnitNodes)
            for (std::size_t n = 0; n < kUnitNodes; ++n) chosen[n] = from + offsets[n];
        else
            for (std::size_t i = 0; i < count; ++i) chosen[i] = from + offsets[nodes_[i]];
    };
    choose(corner.x, offsets_.x, points_.x);
    choose(corner.y, offsets_.y, points_.y);
    choose(corner.z, offsets_.z, points_.z);
    count_ = count;
}

void BlockDistance::sample_points() {
    if (count_ == 0) return;
    batch_.find(points_, count_);
    batch_.write_distances(nodes_, distances_);
    if (!curved_) return;
    batch_.find_curvatures();
    batch_.write_curvatures(nodes_, 1.0 / spacing_, curvatures_);
}

void BlockDistance::write_unit(int unit, const BlockSamples& samples) const {
    for_each_row(unit, [&](std::size_t point, std::size_t node) {
        std::copy_n(distances_ + point, kUnitEdge, &samples.distance[node]);
        if (curved_) std::copy_n(curvatures_ + point, kUnitEdge, &samples.curvature[node]);
    });
}

DistanceBand sample_distance(const AccessibleSurface& surface, const BlockGrid& grid, double margin,
                             BandFields fields) {
    DistanceBand band;
    band.margin = margin;
    resize_touched(band.distance, grid.node_count());
    if (fields == BandFields::DistanceAndCurvature) resize_touched(band.curvature, grid.node_count());
    const BlockGroups groups(grid);
    parallel_chunks(groups.size(), kGroupsPerChunk, [&](std::size_t begin, std::size_t end) {
        const auto evaluator = std::make_unique<BlockDistance>(surface, grid.spacing(), margin);
        for (std::size_t g = begin; g < end; ++g) {
            evaluator->enter(box_of_blocks(grid, groups.blocks(g)));
            groups.for_each_part(g, [&](std::span<const BlockId> blocks) {
                evaluator->enter_part(box_of_blocks(grid, blocks));
                for (const BlockId b : blocks) evaluator->evaluate(grid.corner(b), samples_of(band, b));
            });
        }
    });
    return band;
}

}  // namespace meniscus
