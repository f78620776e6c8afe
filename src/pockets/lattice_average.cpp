// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pockets/lattice_average.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "core/elementary.h"
#include "core/parallel.h"
#include "core/workspaces.h"

namespace meniscus {
namespace {

constexpr std::size_t kEdge = kBlockEdge;
constexpr std::size_t kLines = kEdge * kEdge;  // of a block along an axis
constexpr std::size_t kAverageBlocks = 32;

// Blocks with values; those that are missing are full of zeros.
struct BlockValues {
    std::vector<BlockCoord> blocks;  // ascending
    std::vector<double> values;

    const double* find(const BlockCoord& at) const {
        const auto place = std::lower_bound(blocks.begin(), blocks.end(), at);
        if (place == blocks.end() || *place != at) return nullptr;
        return values.data() + static_cast<std::size_t>(place - blocks.begin()) * kBlockNodes;
    }
};

std::vector<double> weights_of(double sigma, double spacing) {
    const double s = sigma / spacing;
    const int reach = static_cast<int>(std::lround(3.0 * s));
    std::vector<double> weights;
    double sum = 0.0;
    for (int k = -reach; k <= reach; ++k) {
        weights.push_back(elementary::exp(-k * k / (2.0 * s * s)));
        sum += weights.back();
    }
    for (double& weight : weights) weight /= sum;
    return weights;
}

// An axis: which coordinate of a block, and how far apart its nodes are within a block; those of a line start at nodes
// that are the sums of two other steps.
struct Axis {
    std::int32_t BlockCoord::*member;
    std::size_t step;
    std::size_t first_other;
    std::size_t second_other;

    std::size_t start_of_line(std::size_t line) const {
        return line % kEdge * first_other + line / kEdge * second_other;
    }
};
constexpr std::array<Axis, 3> kAxes{
    {{&BlockCoord::x, 1, kEdge, kLines}, {&BlockCoord::y, kEdge, 1, kLines}, {&BlockCoord::z, kLines, 1, kEdge}}};

// All lines of a block and what is beside them within reach, side by side.
class Lines {
public:
    Lines(const BlockValues& from, const Axis& axis, std::span<const double> weights)
        : from_(from),
          axis_(axis),
          weights_(weights),
          reach_(weights.size() / 2),
          padded_((kEdge + 2 * reach_) * kLines) {}

    /// false: nothing but zeros
    bool average(const BlockCoord& block, double* result) {
        if (!gather(block)) return false;
        for (std::size_t place = 0; place < kEdge; ++place) {
            std::array<double, kLines> sums{};
            for (std::size_t k = 0; k < weights_.size(); ++k) {
                const double* values = padded_.data() + (place + k) * kLines;
                for (std::size_t line = 0; line < kLines; ++line) sums[line] += weights_[k] * values[line];
            }
            for (std::size_t line = 0; line < kLines; ++line)
                result[axis_.start_of_line(line) + place * axis_.step] = sums[line];
        }
        return true;
    }

private:
    bool gather(const BlockCoord& block) {
        const auto blocks = static_cast<std::int32_t>((reach_ + kEdge - 1) / kEdge);
        bool any = false;
        std::fill(padded_.begin(), padded_.end(), 0.0);
        for (std::int32_t d = -blocks; d <= blocks; ++d) {
            BlockCoord at = block;
            at.*axis_.member += d;
            const double* values = from_.find(at);
            if (values == nullptr) continue;
            any = true;
            for (std::size_t place = 0; place < kEdge; ++place) {
                const auto to = static_cast<std::ptrdiff_t>(reach_ + place) + static_cast<std::ptrdiff_t>(kEdge) * d;
                if (to < 0 || to >= static_cast<std::ptrdiff_t>(kEdge + 2 * reach_)) continue;
                double* line_values = padded_.data() + static_cast<std::size_t>(to) * kLines;
                for (std::size_t line = 0; line < kLines; ++line)
                    line_values[line] = values[axis_.start_of_line(line) + place * axis_.step];
            }
        }
        return any;
    }

    const BlockValues& from_;
    const Axis& axis_;
    std::span<const double> weights_;
    std::size_t reach_;
    std::vector<double> padded_;
};

std::vector<BlockCoord> spread_along(const BlockValues& from, const Axis& axis, std::size_t reach) {
    const auto blocks = static_cast<std::int32_t>((reach + kEdge - 1) / kEdge);
    std::vector<BlockCoord> result;
    for (const BlockCoord& block : from.blocks)
        for (std::int32_t d = -blocks; d <= blocks; ++d) {
            result.push_back(block);
            result.back().*axis.member += d;
        }
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
}

BlockValues averaged(const BlockValues& from, const Axis& axis, std::span<const double> weights,
                     std::vector<BlockCoord> blocks) {
    BlockValues result{std::move(blocks), {}};
    result.values.resize(result.blocks.size() * kBlockNodes);
    parallel_chunks_with(
        result.blocks.size(), kAverageBlocks, [&] { return std::make_unique<Lines>(from, axis, weights); },
        [&](std::size_t begin, std::size_t end, Lines& lines) {
            for (std::size_t b = begin; b < end; ++b)
                lines.average(result.blocks[b], result.values.data() + b * kBlockNodes);
        });
    return result;
}

}  // namespace

std::vector<double> gaussian_average(const PocketSpace& space, std::span<const double> values, double sigma) {
    const std::vector<double> weights = weights_of(sigma, space.grid.spacing());
    const std::size_t reach = weights.size() / 2;
    BlockValues now;
    for (VoxelId i = 0; i < space.size(); ++i) {
        const BlockCoord& at = space.grid.coord(space.nodes[i] / kBlockNodes);
        if (now.blocks.empty() || now.blocks.back() != at) {
            now.blocks.push_back(at);
            now.values.resize(now.blocks.size() * kBlockNodes);
        }
        now.values[(now.blocks.size() - 1) * kBlockNodes + space.nodes[i] % kBlockNodes] = values[i];
    }
    const std::vector<BlockCoord> wanted = now.blocks;
    now = averaged(now, kAxes[0], weights, spread_along(now, kAxes[0], reach));
    now = averaged(now, kAxes[1], weights, spread_along(now, kAxes[1], reach));
    now = averaged(now, kAxes[2], weights, wanted);
    std::vector<double> result(space.size());
    std::size_t block = 0;
    for (VoxelId i = 0; i < space.size(); ++i) {
        const BlockCoord& at = space.grid.coord(space.nodes[i] / kBlockNodes);
        while (now.blocks[block] != at) ++block;
        result[i] = now.values[block * kBlockNodes + space.nodes[i] % kBlockNodes];
    }
    return result;
}

}  // namespace meniscus
