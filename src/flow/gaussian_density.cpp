// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/gaussian_density.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/parallel.h"
#include "grid/block_kernels.h"
#include "meniscus/errors.h"

namespace meniscus {
namespace {

constexpr double kSmallestExponent = 12.0;
constexpr std::size_t kBlocksPerChunk = 64;

double squared_farthest(const Box& box, const Vec3& p) {
    const double dx = std::max(p.x - box.low.x, box.high.x - p.x);
    const double dy = std::max(p.y - box.low.y, box.high.y - p.y);
    const double dz = std::max(p.z - box.low.z, box.high.z - p.z);
    return dx * dx + dy * dy + dz * dz;
}

Box box_of(const Vec3& corner, double spacing) {
    const double edge = (kBlockEdge - 1) * spacing;
    return {corner, corner + Vec3{edge, edge, edge}};
}

// exp(C d²) at the nodes of a row, relative to its largest. From the node that is nearest to the atom outwards every
// term is the one before times a ratio, which itself changes by a constant factor. offset: of the first node from the
// atom; ratio_change: exp(2 C spacing²). Returns d² of the nearest node.
double fill_axis(double c, double offset, double spacing, double ratio_change, std::span<double, kBlockEdge> term) {
    const int nearest = static_cast<int>(std::clamp(0.5 - offset / spacing, 0.0, kBlockEdge - 1.0));
    const double d = offset + spacing * nearest;
    term[nearest] = 1.0;
    if (nearest < kBlockEdge - 1) {
        double ratio = std::exp(c * spacing * (spacing + 2.0 * d));
        for (int n = nearest + 1; n < kBlockEdge; ++n, ratio *= ratio_change) term[n] = term[n - 1] * ratio;
    }
    if (nearest > 0) {
        double ratio = std::exp(c * spacing * (spacing - 2.0 * d));
        for (int n = nearest - 1; n >= 0; --n, ratio *= ratio_change) term[n] = term[n + 1] * ratio;
    }
    return d * d;
}

bool contains(const Box& outer, const Box& inner) {
    return outer.low.x <= inner.low.x && outer.low.y <= inner.low.y && outer.low.z <= inner.low.z &&
           inner.high.x <= outer.high.x && inner.high.y <= outer.high.y && inner.high.z <= outer.high.z;
}

void keep_distinct(std::vector<BlockCoord>& blocks) {
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
}

// Adds to every block its neighbours up to `steps` away along one axis.
template <class Along>
void widen(std::vector<BlockCoord>& blocks, int steps, std::size_t max_blocks, Along along) {
    const std::size_t count = blocks.size();
    if (count * (2 * static_cast<std::size_t>(steps) + 1) > 64 * max_blocks)
        throw LimitError("the density map would not fit into memory; enlarge --spacing or raise --memory");
    for (std::size_t b = 0; b < count; ++b)
        for (int step = -steps; step <= steps; ++step) {
            if (step == 0) continue;
            BlockCoord block = blocks[b];
            block.*along += step;
            blocks.push_back(block);
        }
    keep_distinct(blocks);
}

}  // namespace

GaussianDensity::GaussianDensity(const AccessibleSurface& surface, double c) : data_(&surface.data()), c_(c) {
    const std::vector<double>& radii = data_->atoms.radii;
    mean_radius_ = std::accumulate(radii.begin(), radii.end(), 0.0) / static_cast<double>(radii.size());
    const double r_max = *std::max_element(radii.begin(), radii.end());
    reach_ = std::sqrt(r_max * r_max + kSmallestExponent / -c);
}

// How the terms of a block's nodes are summed.
struct GaussianDensity::NodeSums {
    BlockNodes block;
    double ratio_change;  // of fill_axis()
    double unit;          // sums are in units of its exponential
    double negligible;    // of a sum, in these units
};

class GaussianDensity::AtomsAround {
public:
    explicit AtomsAround(const GaussianDensity& density) : data_(*density.data_), reach_(density.reach_) {}

    std::span<const std::uint32_t> find(const Box& box) {
        if (!contains(row_, box)) gather_row(box);
        found_.clear();
        for (const std::uint32_t i : around_row_)
            if (box.squared_distance(data_.atoms.centres[i]) < reach_ * reach_) found_.push_back(i);
        return found_;
    }

private:
    static constexpr double kRow = 5.0;  // boxes along x

    void gather_row(const Box& box) {
        row_ = box;
        row_.high.x = box.low.x + kRow * (box.high.x - box.low.x);
        around_row_.clear();
        data_.atom_tree.for_each_overlapping(row_.grown(reach_), [&](std::uint32_t i) {
            if (row_.squared_distance(data_.atoms.centres[i]) < reach_ * reach_) around_row_.push_back(i);
        });
    }

    const AccessibleSurface::Data& data_;
    double reach_;
    Box row_;
    std::vector<std::uint32_t> around_row_;
    std::vector<std::uint32_t> found_;
};

// Bounds the sum over the box by its terms at the nearest and farthest points.
GaussianDensity::Where GaussianDensity::classify(const Box& box, double margin,
                                                 std::span<const std::uint32_t> atoms) const {
    double most = 0.0;
    double least = 0.0;
    for (const std::uint32_t i : atoms) {
        const Vec3& centre = data_->atoms.centres[i];
        most += std::exp(exponent(i, box.squared_distance(centre)));
        const double at_farthest = exponent(i, squared_farthest(box, centre));
        if (at_farthest > -kSmallestExponent) least += std::exp(at_farthest);
    }
    const double scale = 2.0 * c_ * mean_radius_;  // negative: Φ0 = ln(sum) / scale
    if (most == 0.0 || std::log(most) / scale > margin) return Where::Outside;
    return std::log(least) / scale < -margin ? Where::Inside : Where::Near;
}

std::vector<BlockCoord> GaussianDensity::blocks_near_surface(const Lattice& lattice, double margin,
                                                             std::size_t max_blocks) const {
    std::vector<BlockCoord> blocks;
    for (const Vec3& centre : data_->atoms.centres) blocks.push_back(lattice.block_of(centre));
    keep_distinct(blocks);
    const int steps = static_cast<int>(std::ceil(reach_ / lattice.block_edge()));
    widen(blocks, steps, max_blocks, &BlockCoord::x);
    widen(blocks, steps, max_blocks, &BlockCoord::y);
    widen(blocks, steps, max_blocks, &BlockCoord::z);
    std::vector<Where> where(blocks.size());
    parallel_chunks(blocks.size(), kBlocksPerChunk, [&](std::size_t begin, std::size_t end) {
        AtomsAround around(*this);
        for (std::size_t b = begin; b < end; ++b) {
            // With the cells to the neighbouring blocks: where the sign changes, both sides are kept.
            const Box box = box_of(lattice.corner(blocks[b]), lattice.spacing).grown(lattice.spacing);
            where[b] = classify(box, margin, around.find(box));
        }
    });
    std::vector<BlockCoord> near;
    for (std::size_t b = 0; b < blocks.size(); ++b)
        if (where[b] == Where::Near) near.push_back(blocks[b]);
    if (near.size() > max_blocks)
        throw LimitError("the density map would not fit into memory; enlarge --spacing or raise --memory");
    return near;
}

// Adds the terms of an atom to the sums at the nodes. The Gaussian is a product over the axes: three short tables
// instead of an exponential per node.
void GaussianDensity::add_terms(std::uint32_t atom, const NodeSums& to, std::span<double, kBlockNodes> sums) const {
    const Vec3 from = to.block.corner - data_->atoms.centres[atom];
    const double h = to.block.spacing;
    AxisProduct product;
    const double squared_nearest = fill_axis(c_, from.x, h, to.ratio_change, product.x) +
                                   fill_axis(c_, from.y, h, to.ratio_change, product.y) +
                                   fill_axis(c_, from.z, h, to.ratio_change, product.z);
    const double scale = std::exp(exponent(atom, squared_nearest) - to.unit);
    for (double& z : product.z) z *= scale;
    block_kernels().add_product(product, to.negligible, sums.data());
}

// Φ0 at every node. Sums are in units of the largest term of the block, so that nothing overflows; where they are past
// the margin there is no need of their logarithm.
void GaussianDensity::evaluate(const BlockNodes& block, double margin, std::span<const std::uint32_t> atoms,
                               std::span<float, kBlockNodes> values) const {
    const Box box = box_of(block.corner, block.spacing);
    double largest = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : atoms)
        largest = std::max(largest, exponent(i, box.squared_distance(data_->atoms.centres[i])));
    const double per_length = 2.0 * -c_ * mean_radius_;
    const double most = std::exp(margin * per_length - largest);
    const double least = std::exp(-margin * per_length - largest);
    double sums[kBlockNodes] = {};
    const NodeSums to{.block = block,
                      .ratio_change = std::exp(2.0 * c_ * block.spacing * block.spacing),
                      .unit = largest,
                      .negligible = least * std::exp(-kSmallestExponent)};
    for (const std::uint32_t i : atoms) add_terms(i, to, sums);
    for (int n = 0; n < kBlockNodes; ++n) {
        double value = 0.0;
        if (sums[n] > 0.0 && sums[n] >= most)
            value = -margin;
        else if (least > 0.0 && sums[n] <= least)
            value = margin;
        else
            value = -(sums[n] > 0.0 ? largest + std::log(sums[n]) : largest_exponent(block, n, atoms)) / per_length;
        values[static_cast<std::size_t>(n)] = static_cast<float>(std::clamp(value, -margin, margin));
    }
}

// Where sums underflow, far from all atoms or with huge ones, the largest term of the node stands for the sum.
double GaussianDensity::largest_exponent(const BlockNodes& block, int node,
                                         std::span<const std::uint32_t> atoms) const {
    const int x = node % kBlockEdge;
    const int y = node / kBlockEdge % kBlockEdge;
    const int z = node / (kBlockEdge * kBlockEdge);
    const Vec3 p = block.corner + block.spacing * Vec3{1.0 * x, 1.0 * y, 1.0 * z};
    double largest = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : atoms)
        largest = std::max(largest, exponent(i, squared_norm(p - data_->atoms.centres[i])));
    return largest;
}

NodeField GaussianDensity::sample(const BlockGrid& grid, double margin) const {
    NodeField values(grid.node_count(), 0.0F);
    parallel_chunks(grid.block_count(), kBlocksPerChunk, [&](std::size_t begin, std::size_t end) {
        AtomsAround around(*this);
        for (std::size_t b = begin; b < end; ++b) {
            const BlockNodes block{grid.corner(static_cast<BlockId>(b)), grid.spacing()};
            const Box box = box_of(block.corner, block.spacing);
            const std::span<const std::uint32_t> atoms = around.find(box);
            const std::span<float, kBlockNodes> out(values.data() + b * kBlockNodes, kBlockNodes);
            const Where where = classify(box, margin, atoms);
            if (where == Where::Near)
                evaluate(block, margin, atoms, out);
            else
                std::ranges::fill(out, static_cast<float>(where == Where::Inside ? -margin : margin));
        }
    });
    return values;
}

}  // namespace meniscus
