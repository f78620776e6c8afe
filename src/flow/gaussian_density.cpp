// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/gaussian_density.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

#include "core/elementary.h"
#include "core/parallel.h"
#include "flow/density_kernels.h"
#include "grid/block_kernels.h"
#include "meniscus/errors.h"

namespace meniscus {
namespace {

constexpr double kSmallestExponent = 12.0;
constexpr std::size_t kDensityBlocksPerChunk = 64;

Box box_of(const Vec3& corner, double spacing) {
    const double edge = (kBlockEdge - 1) * spacing;
    return {corner, corner + Vec3{edge, edge, edge}};
}

// Adds to every block its neighbours up to `steps` away along one axis. Moving all blocks keeps their order.
void widen(std::vector<BlockCoord>& blocks, int steps, std::size_t max_blocks, std::int32_t BlockCoord::*along) {
    if (blocks.size() * (2 * static_cast<std::size_t>(steps) + 1) > 64 * max_blocks)
        throw LimitError("the density map would not fit into memory; choose a larger spacing, or allow more memory");
    const auto move = [along](std::vector<BlockCoord>& list, int by) {
        for (BlockCoord& block : list) block.*along += by;
    };
    const int width = 2 * steps + 1;
    for (int done = 1, by = 0; done < width; done += by) {
        by = std::min(done, width - done);
        std::vector<BlockCoord> moved = blocks;
        move(moved, by);
        std::vector<BlockCoord> both;
        both.reserve(2 * blocks.size());
        std::set_union(blocks.begin(), blocks.end(), moved.begin(), moved.end(), std::back_inserter(both));
        blocks = std::move(both);
    }
    move(blocks, -steps);
}

}  // namespace

GaussianDensity::GaussianDensity(const AccessibleSurface& surface, double c) : data_(&surface.data()), c_(c) {
    const std::vector<double>& radii = data_->atoms.radii;
    mean_radius_ = std::accumulate(radii.begin(), radii.end(), 0.0) / static_cast<double>(radii.size());
    const double r_max = *std::max_element(radii.begin(), radii.end());
    reach_ = std::sqrt(r_max * r_max + kSmallestExponent / -c);
}

// The atoms whose terms count in a box, gathered for a row of boxes at a time.
class GaussianDensity::AtomsAround {
public:
    explicit AtomsAround(const GaussianDensity& density) : density_(density) {}

    // Goes to a box, and bounds the density over it by its terms at the nearest and farthest points.
    Where enter(const Box& box, double margin) {
        if (!row_box_.contains(box)) gather_row(box);
        density_kernels().bound_terms(row_, box, density_.c_, density_.reach_, within_.data(), largest_.data(),
                                      least_.data());
        const double most = sum_of(largest_);
        const double least = sum_of(least_);
        const double scale = 2.0 * density_.c_ * density_.mean_radius_;  // negative: Φ0 = ln(sum) / scale
        if (most == 0.0 || elementary::log(most) / scale > margin) return Where::Outside;
        return elementary::log(least) / scale < -margin ? Where::Inside : Where::Near;
    }

    // The atoms within reach of the current box.
    const SphereList& atoms() {
        atoms_.select(row_, within_.data());
        return atoms_;
    }

private:
    static constexpr double kRow = 8.0;  // boxes along x

    void gather_row(const Box& box) {
        row_box_ = box;
        row_box_.high.x = box.low.x + kRow * (box.high.x - box.low.x);
        row_.clear();
        const CanonicalAtoms& atoms = density_.data_->atoms;
        const double reach = density_.reach_;
        density_.data_->atom_tree.for_each_overlapping(row_box_.grown(reach), [&](std::uint32_t i) {
            const Vec3& c = atoms.centres[i];
            if (row_box_.squared_distance(c) < reach * reach) row_.add({c.x, c.y, c.z, atoms.radii[i]}, i);
        });
        within_.resize(std::max(within_.size(), words_for(row_.size())));
        largest_.resize(std::max(largest_.size(), row_.padded_size()));
        least_.resize(largest_.size());
    }

    double sum_of(const std::vector<double>& terms) const {
        return std::accumulate(terms.begin(), terms.begin() + static_cast<std::ptrdiff_t>(row_.size()), 0.0);
    }

    const GaussianDensity& density_;
    Box row_box_;
    SphereList row_;
    std::vector<std::uint64_t> within_;  // of row_, a bit for each atom
    std::vector<double> largest_;
    std::vector<double> least_;
    SphereList atoms_;
};

std::vector<BlockCoord> GaussianDensity::blocks_near_surface(const Lattice& lattice, double margin,
                                                             std::size_t max_blocks) const {
    std::vector<BlockCoord> blocks;
    for (const Vec3& centre : data_->atoms.centres) blocks.push_back(lattice.block_of(centre));
    std::sort(blocks.begin(), blocks.end());
    blocks.erase(std::unique(blocks.begin(), blocks.end()), blocks.end());
    const int steps = static_cast<int>(std::ceil(reach_ / lattice.block_edge()));
    widen(blocks, steps, max_blocks, &BlockCoord::x);
    widen(blocks, steps, max_blocks, &BlockCoord::y);
    widen(blocks, steps, max_blocks, &BlockCoord::z);
    std::vector<Where> where(blocks.size());
    parallel_chunks(blocks.size(), kDensityBlocksPerChunk, [&](std::size_t begin, std::size_t end) {
        AtomsAround around(*this);
        for (std::size_t b = begin; b < end; ++b) {
            // With the cells to the neighbouring blocks: where the sign changes, both sides are kept.
            const Box box = box_of(lattice.corner(blocks[b]), lattice.spacing).grown(lattice.spacing);
            where[b] = around.enter(box, margin);
        }
    });
    std::vector<BlockCoord> near;
    for (std::size_t b = 0; b < blocks.size(); ++b)
        if (where[b] == Where::Near) near.push_back(blocks[b]);
    if (near.size() > max_blocks)
        throw LimitError("the density map would not fit into memory; choose a larger spacing, or allow more memory");
    return near;
}

// Φ0 at every node. Sums are in units of the largest term of the block, so that nothing overflows; where they are past
// the margin there is no need of their logarithm. The Gaussian is a product over the axes: three short tables instead
// of an exponential per node.
void GaussianDensity::evaluate(const BlockNodes& block, double margin, const SphereList& atoms,
                               std::span<float, kBlockNodes> values) const {
    const Box box = box_of(block.corner, block.spacing);
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < atoms.size(); ++i)
        largest = std::max(largest, exponent(atoms, i, box.squared_distance(position_in(atoms, i))));
    const double per_length = 2.0 * -c_ * mean_radius_;
    const double most = elementary::exp(margin * per_length - largest);
    const double least = elementary::exp(-margin * per_length - largest);
    const double negligible = least * elementary::exp(-kSmallestExponent);
    double sums[kBlockNodes] = {};
    AxisProduct terms;
    for (std::size_t i = 0; i < atoms.size(); ++i) {
        const Vec3 from = block.corner - position_in(atoms, i);
        density_kernels().find_terms(c_, atoms.column(3)[i], from, block.spacing, largest, terms);
        block_kernels().add_product(terms, negligible, sums);
    }
    if (least >= std::numeric_limits<double>::min()) {
        density_kernels().find_values({largest, per_length, margin, most, least}, sums, values.data());
        return;
    }
    for (int n = 0; n < kBlockNodes; ++n) {
        const double sum = sums[n];
        const double exponent = sum > 0.0 ? largest + elementary::log(sum) : largest_exponent(block, n, atoms);
        const double value = sum > 0.0 && sum >= most ? -margin : -exponent / per_length;
        values[static_cast<std::size_t>(n)] = static_cast<float>(std::clamp(value, -margin, margin));
    }
}

// Where sums underflow, far from all atoms or with huge ones, the largest term of the node stands for the sum.
double GaussianDensity::largest_exponent(const BlockNodes& block, int node, const SphereList& atoms) const {
    const int x = node % kBlockEdge;
    const int y = node / kBlockEdge % kBlockEdge;
    const int z = node / (kBlockEdge * kBlockEdge);
    const Vec3 p = block.corner + block.spacing * Vec3{1.0 * x, 1.0 * y, 1.0 * z};
    double largest = -std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < atoms.size(); ++i)
        largest = std::max(largest, exponent(atoms, i, squared_norm(p - position_in(atoms, i))));
    return largest;
}

NodeField GaussianDensity::sample(const BlockGrid& grid, double margin) const {
    NodeField values(grid.node_count(), 0.0F);
    parallel_chunks(grid.block_count(), kDensityBlocksPerChunk, [&](std::size_t begin, std::size_t end) {
        AtomsAround around(*this);
        for (std::size_t b = begin; b < end; ++b) {
            const BlockNodes block{grid.corner(static_cast<BlockId>(b)), grid.spacing()};
            const std::span<float, kBlockNodes> out(values.data() + b * kBlockNodes, kBlockNodes);
            const Where where = around.enter(box_of(block.corner, block.spacing), margin);
            if (where == Where::Near)
                evaluate(block, margin, around.atoms(), out);
            else
                std::fill(out.begin(), out.end(), static_cast<float>(where == Where::Inside ? -margin : margin));
        }
    });
    return values;
}

}  // namespace meniscus
