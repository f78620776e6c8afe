// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/distance_band.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <span>

#include "band/block_groups.h"
#include "band/unit_places.h"
#include "core/bits.h"
#include "geometry/accessible_surface_data.h"
#include "nearest/local_features.h"
#include "nearest/nearest_batch.h"
#include "nearest/nearest_kernels.h"
#include "platform/fresh_memory.h"

namespace meniscus {
namespace {

using Claim = NearestBatch::Claim;

constexpr double kAboveOne = 1.0 + 1e-9;  // for rounding
constexpr double kSingleSlack = 1e-5;     // the same in single precision, of the largest length

constexpr auto kAllNodes = [] {
    std::array<std::uint32_t, kUnitNodes> nodes{};
    std::iota(nodes.begin(), nodes.end(), 0U);
    return nodes;
}();

// Calls visit(node of the unit, node of the block) for the first node of each row along x.
template <class Visit>
void for_each_row(int unit, const Visit& visit) {
    const auto number = [](int node) { return static_cast<std::size_t>(node); };
    const std::size_t first = kUnitEdge * number(node_in_block(unit & 1, unit >> 1 & 1, unit >> 2));
    for (int z = 0; z < kUnitEdge; ++z)
        for (int y = 0; y < kUnitEdge; ++y)
            visit(number(node_in_unit(0, y, z)), first + number(node_in_block(0, y, z)));
}

// Where the samples of one block go.
struct BlockSamples {
    std::span<float, kBlockNodes> distance;
    std::span<float, kBlockNodes> curvature;
};

BlockSamples samples_of(DistanceBand& band, BlockId block) {
    const std::size_t first = std::size_t{block} * kBlockNodes;
    return {std::span<float, kBlockNodes>(band.distance.data() + first, kBlockNodes),
            std::span<float, kBlockNodes>(band.curvature.data() + first, kBlockNodes)};
}

// Goes to blocks, and then to units of each, reusing its memory.
class BlockUnits {
public:
    // margin  Å: up to this distance from the surface nodes have a distance
    BlockUnits(const AccessibleSurface& surface, double spacing, double margin)
        : spacing_(spacing),
          limits_{margin, kSingleSlack *
                              (2.0 * kAboveOne * half_diagonal(kUnitEdge, spacing) + margin + surface.data().rho_max)},
          block_(surface, reach(spacing, margin)),
          batch_(surface) {
        const double near_foot = surface.probe() - margin - limits_.slack;
        if (near_foot > 0.0) limits_.near_foot = static_cast<float>(near_foot * near_foot);
        for (std::size_t n = 0; n < kUnitNodes; ++n) {
            const Vec3 step = spacing * (node_steps(n) - to_middle(kUnitEdge));
            set_point(nodes_.offsets, n, spacing * node_steps(n));
            set_point(nodes_.from_middle, n, step);
            nodes_.lengths[n] = static_cast<float>(norm(step));
        }
    }

    // Up to which distance from the surface features must be gathered, Å.
    static double reach(double spacing, double margin) {
        return margin + kAboveOne * half_diagonal(kUnitEdge, spacing);
    }

    // The distance changes by at most 1 per Å: that of its middle settles a unit that is far from the band.
    // around: features for a box around the block; corner: position of node (0, 0, 0)
    void enter_block(const LocalFeatures& around, const Vec3& corner) {
        entered_.corner = corner;
        block_.gather_from(around, box_of_nodes(corner, kBlockEdge, spacing_));
        Vec3 points[kUnits];
        Box box;
        for (std::size_t u = 0; u < kUnits; ++u) {
            points[u] = corner + spacing_ * (unit_steps(u) + to_middle(kUnitEdge));
            box.include(points[u]);
        }
        const Claim all = batch_.start(block_, box, block_.margin());
        if (all == Claim::Open) batch_.find(points);
        for (std::size_t u = 0; u < kUnits; ++u) {
            Middle& middle = entered_.middles[u];
            middle.side = all == Claim::Open ? batch_.claim(u) : all;
            if (all != Claim::Open || !batch_.found(u)) continue;
            middle.distance = batch_.signed_distance(u);
            middle.to_foot = batch_.foot(u) - points[u];
        }
    }

    // Below or Above if that holds for all nodes of the unit. Open otherwise: then it may be searched.
    Claim enter_unit(int unit) {
        entered_.unit = static_cast<std::size_t>(unit);
        const Claim side = entered_.middles[unit].side;
        if (side == Claim::Below || side == Claim::Above) return side;
        const Vec3 corner = entered_.corner + spacing_ * unit_steps(entered_.unit);
        return batch_.start(block_, box_of_nodes(corner, kUnitEdge, spacing_), limits_.margin);
    }

    // Of the unit that was entered last, nodes in the order of node_in_unit.

    // Which nodes are known to be beyond the margin, and on which side: by the change of the distance from the unit's
    // middle, and by the middle's foot, which is a point of K.
    KnownSides screen() const {
        const Middle& middle = entered_.middles[entered_.unit];
        const Vec3& foot = middle.to_foot;
        const PointScreen known{
            .foot = {static_cast<float>(foot.x), static_cast<float>(foot.y), static_cast<float>(foot.z)},
            .near_foot = limits_.near_foot,
            .near_middle = static_cast<float>(std::abs(middle.distance) - limits_.margin - limits_.slack),
            .middle_inside = middle.distance < 0.0};
        return nearest_kernels().screen(known, nodes_.from_middle, nodes_.lengths);
    }
    // Looks for what is nearest to some nodes, at most kUnitNodes.
    void search(std::span<const std::uint32_t> nodes) {
        const Vec3 corner = entered_.corner + spacing_ * unit_steps(entered_.unit);
        const auto place = [&](std::size_t i, std::size_t n) {
            set_point(points_, i, corner + get_point(nodes_.offsets, n));
        };
        if (nodes.size() == kUnitNodes)
            for (std::size_t n = 0; n < kUnitNodes; ++n) place(n, n);
        else
            for (std::size_t i = 0; i < nodes.size(); ++i) place(i, nodes[i]);
        batch_.find(points_, nodes.size());
    }
    NearestBatch& batch() { return batch_; }  // of these nodes

private:
    // What is known of a unit from its middle.
    struct Middle {
        Claim side = Claim::Open;  // Below and Above are for all nodes of the unit
        double distance = 0.0;     // signed, Å
        Vec3 to_foot;              // nearest point of K
    };

    // What tells that nodes are beyond the margin.
    struct Limits {
        double margin;
        double slack;             // Å: more than all that single precision gets wrong
        float near_foot = -1.0F;  // Å²: nodes so near to a point of K are outside, beyond the margin
    };
    // The nodes of any unit.
    struct UnitNodes {
        LanePoints<double> offsets;     // from the first one
        LanePoints<float> from_middle;  // from the unit's middle
        LaneArray<float> lengths;       // of these
    };
    // Where the block and the unit are that were entered last.
    struct Entered {
        Vec3 corner;  // of the block
        Middle middles[kUnits];
        std::size_t unit = 0;
    };

    double spacing_;
    Limits limits_;
    UnitNodes nodes_;
    LocalFeatures block_;
    NearestBatch batch_;
    Entered entered_;
    LanePoints<double> points_;  // that are searched
};

// Evaluates all nodes of one block after the other.
class BlockDistance {
public:
    BlockDistance(const AccessibleSurface& surface, double spacing, double margin)
        : units_(surface, spacing, margin), spacing_(spacing), margin_(margin) {}

    // around: features for a box around the block; corner: position of node (0, 0, 0)
    void evaluate(const LocalFeatures& around, const Vec3& corner, const BlockSamples& samples) {
        units_.enter_block(around, corner);
        for (int u = 0; u < kUnits; ++u) {
            const Claim side = units_.enter_unit(u);
            if (side == Claim::Below || side == Claim::Above) {
                fill_unit(u, side, samples);
            } else {
                sample_points(nodes_within());
                write_unit(u, samples);
            }
        }
    }

private:
    void fill_unit(int unit, Claim side, const BlockSamples& samples) const {
        const auto distance = static_cast<float>(side == Claim::Below ? -margin_ : margin_);
        for_each_row(unit, [&](std::size_t, std::size_t node) {
            std::fill_n(&samples.distance[node], kUnitEdge, distance);
            std::fill_n(&samples.curvature[node], kUnitEdge, 0.0F);
        });
    }

    // Nodes that may be within the margin. Others get the margin of their side.
    std::span<const std::uint32_t> nodes_within() {
        const auto [inside, settled] = units_.screen();
        if (settled == 0) return kAllNodes;
        for (std::size_t n = 0; n < kUnitNodes; ++n)
            distances_[n] = static_cast<float>((inside >> n & 1U) != 0 ? -margin_ : margin_);
        std::fill_n(curvatures_, kUnitNodes, 0.0F);
        const UnitBits within = ~settled;
        return {nodes_, list_items(&within, kUnitNodes, nodes_)};
    }

    void sample_points(std::span<const std::uint32_t> nodes) {
        if (nodes.empty()) return;
        units_.search(nodes);
        units_.batch().find_curvatures();
        units_.batch().write(nodes, 1.0 / spacing_, distances_, curvatures_);
    }

    void write_unit(int unit, const BlockSamples& samples) const {
        for_each_row(unit, [&](std::size_t point, std::size_t node) {
            std::copy_n(distances_ + point, kUnitEdge, &samples.distance[node]);
            std::copy_n(curvatures_ + point, kUnitEdge, &samples.curvature[node]);
        });
    }

    BlockUnits units_;
    double spacing_;
    double margin_;
    float distances_[kUnitNodes];  // of the unit's nodes
    float curvatures_[kUnitNodes];
    std::uint32_t nodes_[kUnitNodes];  // those that may be within the margin
};

}  // namespace

DistanceBand sample_distance(const AccessibleSurface& surface, const BlockGrid& grid, double margin) {
    DistanceBand band;
    band.margin = margin;
    resize_touched(band.distance, grid.node_count());
    resize_touched(band.curvature, grid.node_count());
    for_each_block(
        grid, LocalFeatures(surface, BlockUnits::reach(grid.spacing(), margin)),
        [&] { return std::make_unique<BlockDistance>(surface, grid.spacing(), margin); },
        [&](BlockDistance& evaluator, const LocalFeatures& around, BlockId b) {
            evaluator.evaluate(around, grid.corner(b), samples_of(band, b));
        });
    return band;
}

}  // namespace meniscus
