// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow/gaussian_density.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/parallel.h"
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

// exp(C d²) at the nodes of a row, relative to its largest; offset: of the first node from the atom.
struct AxisTable {
    double term[kBlockEdge];

    AxisTable(double c, double offset, double spacing) {
        const double nearest = std::max({0.0, offset, -(offset + (kBlockEdge - 1) * spacing)});
        for (int n = 0; n < kBlockEdge; ++n) {
            const double d = offset + spacing * n;
            term[n] = std::exp(c * (d * d - nearest * nearest));
        }
    }
};

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

void GaussianDensity::gather(const Box& box, std::vector<std::uint32_t>& atoms) const {
    atoms.clear();
    data_->atom_tree.for_each_overlapping(box.grown(reach_), [&](std::uint32_t i) {
        if (box.squared_distance(data_->atoms.centres[i]) < reach_ * reach_) atoms.push_back(i);
    });
}

// Bounds the sum over the box by its terms at the nearest and farthest points.
GaussianDensity::Where GaussianDensity::classify(const Box& box, double margin,
                                                 std::vector<std::uint32_t>& atoms) const {
    gather(box, atoms);
    double most = 0.0;
    double least = 0.0;
    for (const std::uint32_t i : atoms) {
        const Vec3& centre = data_->atoms.centres[i];
        most += std::exp(exponent(i, box.squared_distance(centre)));
        least += std::exp(exponent(i, squared_farthest(box, centre)));
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
        std::vector<std::uint32_t> atoms;
        for (std::size_t b = begin; b < end; ++b)
            // With the cells to the neighbouring blocks: where the sign changes, both sides are kept.
            where[b] =
                classify(box_of(lattice.corner(blocks[b]), lattice.spacing).grown(lattice.spacing), margin, atoms);
    });
    std::vector<BlockCoord> near;
    for (std::size_t b = 0; b < blocks.size(); ++b)
        if (where[b] == Where::Near) near.push_back(blocks[b]);
    if (near.size() > max_blocks)
        throw LimitError("the density map would not fit into memory; enlarge --spacing or raise --memory");
    return near;
}

// Logarithm of the sum at every node. The Gaussian of an atom is a product over the axes: three short tables
// instead of an exponential per node, all scaled by the largest term of the block so that nothing overflows.
void GaussianDensity::evaluate(const Vec3& corner, double spacing, std::span<const std::uint32_t> atoms,
                               std::span<double, kBlockNodes> log_sums) const {
    const Box box = box_of(corner, spacing);
    double largest = -std::numeric_limits<double>::infinity();
    for (const std::uint32_t i : atoms)
        largest = std::max(largest, exponent(i, box.squared_distance(data_->atoms.centres[i])));
    std::fill(log_sums.begin(), log_sums.end(), 0.0);
    for (const std::uint32_t i : atoms) {
        const double squared_nearest = box.squared_distance(data_->atoms.centres[i]);
        const Vec3 from = corner - data_->atoms.centres[i];
        const AxisTable ex(c_, from.x, spacing);
        const AxisTable ey(c_, from.y, spacing);
        const AxisTable ez(c_, from.z, spacing);
        const double scale = std::exp(exponent(i, squared_nearest) - largest);
        for (int z = 0; z < kBlockEdge; ++z)
            for (int y = 0; y < kBlockEdge; ++y) {
                const double yz = scale * ey.term[y] * ez.term[z];
                double* row = log_sums.data() + node_in_block(0, y, z);
                for (int x = 0; x < kBlockEdge; ++x) row[x] += yz * ex.term[x];
            }
    }
    for (int n = 0; n < kBlockNodes; ++n) {
        double& sum = log_sums[static_cast<std::size_t>(n)];
        if (sum > 0.0) {
            sum = largest + std::log(sum);
            continue;
        }
        // Underflow, far from all atoms or with huge ones: the largest term of this node stands for the sum.
        const int x = n % kBlockEdge;
        const int y = n / kBlockEdge % kBlockEdge;
        const int z = n / (kBlockEdge * kBlockEdge);
        const Vec3 p = corner + spacing * Vec3{1.0 * x, 1.0 * y, 1.0 * z};
        sum = -std::numeric_limits<double>::infinity();
        for (const std::uint32_t i : atoms) sum = std::max(sum, exponent(i, squared_norm(p - data_->atoms.centres[i])));
    }
}

std::vector<float> GaussianDensity::sample(const BlockGrid& grid, double margin) const {
    std::vector<float> values(grid.node_count());
    const double scale = 1.0 / (2.0 * c_ * mean_radius_);
    parallel_chunks(grid.block_count(), kBlocksPerChunk, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> atoms;
        double log_sums[kBlockNodes];
        for (std::size_t b = begin; b < end; ++b) {
            const Vec3 corner = grid.corner(static_cast<BlockId>(b));
            float* out = values.data() + b * kBlockNodes;
            const Where where = classify(box_of(corner, grid.spacing()), margin, atoms);
            if (where != Where::Near) {
                std::fill_n(out, kBlockNodes, static_cast<float>(where == Where::Inside ? -margin : margin));
                continue;
            }
            evaluate(corner, grid.spacing(), atoms, std::span<double, kBlockNodes>(log_sums));
            for (int n = 0; n < kBlockNodes; ++n)
                out[n] = static_cast<float>(std::clamp(log_sums[n] * scale, -margin, margin));
        }
    });
    return values;
}

}  // namespace meniscus
