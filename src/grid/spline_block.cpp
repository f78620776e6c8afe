// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/spline_block.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <cstring>
#include <limits>

#include "grid/block_kernels.h"

namespace meniscus {
namespace {

constexpr float kNoValue = std::numeric_limits<float>::quiet_NaN();

// The values of a block that there is not.
constexpr auto kNothing = [] {
    std::array<float, kBlockNodes> values{};
    values.fill(kNoValue);
    return values;
}();

constexpr int kBefore = SplineCoefficients::kBefore;
constexpr int kEdge = SplineCoefficients::kEdge;
constexpr int kAfter = kEdge - kBefore - kBlockEdge;

// The nodes along an axis that come from the block before the one in the middle, from itself, or from the one after.
struct NodesFrom {
    int begin;
    int end;
    int first;  // in that block
};
constexpr std::array<NodesFrom, 3> kNodesFrom{
    {{0, kBefore, kBlockEdge - kBefore}, {kBefore, kBefore + kBlockEdge, 0}, {kBefore + kBlockEdge, kEdge, 0}}};

// Copies the rows of three blocks next to each other in x.
void copy_rows(const float* const* along_x, const NodesFrom& in_y, const NodesFrom& in_z, float* values) {
    const float* const before = along_x[0] + kBlockEdge - kBefore;
    const float* const own = along_x[1];
    const float* const after = along_x[2];
    for (int z = in_z.begin; z < in_z.end; ++z) {
        int row = node_in_block(0, in_y.first, in_z.first + z - in_z.begin);
        float* to = values + std::ptrdiff_t{kEdge} * (in_y.begin + kEdge * z);
        for (int y = in_y.begin; y < in_y.end; ++y, row += kBlockEdge, to += kEdge) {
            std::memcpy(to, before + row, kBefore * sizeof(float));
            std::memcpy(to + kBefore, own + row, kBlockEdge * sizeof(float));
            std::memcpy(to + kBefore + kBlockEdge, after + row, kAfter * sizeof(float));
        }
    }
}

constexpr std::size_t kFewPoints = 8;  // cheaper one by one

// Points may be this far outside a block: Newton's method may move them over its border, and rounding may have done so.
constexpr double kBeyond = 0.5;  // spacings

bool is_near(const BlockGrid& grid, const Vec3& corner, const Vec3& point) {
    const Vec3 at = (1.0 / grid.spacing()) * (point - corner);
    const auto within = [](double v) { return (v > -kBeyond) & (v < kBlockEdge + kBeyond); };
    return within(at.x) & within(at.y) & within(at.z);
}

BlockCoord block_of(const BlockGrid& grid, const Vec3& point) {
    const Vec3 at = (1.0 / (kBlockEdge * grid.spacing())) * (point - grid.origin());
    const auto floor = [](double v) { return static_cast<std::int32_t>(std::floor(v)); };
    return {.z = floor(at.z), .y = floor(at.y), .x = floor(at.x)};
}

}  // namespace

SplineBlock::SplineBlock(const BlockGrid& grid, std::span<const float> coefficients, const SplineKernels& kernels)
    : grid_(grid), coefficients_(coefficients), kernels_(kernels), cursor_(grid, coefficients) {
    around_.origin = grid.origin();
    around_.spacing = grid.spacing();
    around_.values.fill(kNoValue);
}

void SplineBlock::project(std::span<const Vec3> points, std::span<SplineProjection> projections) {
    const auto one_by_one = [&](std::size_t i) {
        projections[i] = project_to_zero_set(cursor_, points[i], grid_.spacing());
    };
    for (std::size_t begin = 0; begin < points.size();) {
        const BlockCoord at = block_of(grid_, points[begin]);
        const Vec3 corner = grid_.corner(at);
        std::size_t end = begin + 1;
        while (end < points.size() && is_near(grid_, corner, points[end])) ++end;
        const BlockId block = end - begin < kFewPoints ? kNoBlock : grid_.find(at);
        if (block != kNoBlock) {
            enter(block);
            kernels_.project(around_, points.subspan(begin, end - begin), &projections[begin]);
        }
        for (std::size_t i = begin; i < end; ++i)
            if (block == kNoBlock || std::isnan(projections[i].sample.value)) one_by_one(i);
        begin = end;
    }
}

void SplineBlock::enter(BlockId block) {
    if (block == block_) return;
    block_ = block;
    const BlockCoord& at = grid_.coord(block);
    const auto first_node = [](std::int32_t coord) { return std::int64_t{kBlockEdge} * coord - kBefore; };
    around_.first = {first_node(at.x), first_node(at.y), first_node(at.z)};
    const BlocksAround blocks = blocks_around(grid_, coefficients_, block, kNothing.data());
    for (std::size_t z = 0; z < 3; ++z)
        for (std::size_t y = 0; y < 3; ++y)
            copy_rows(blocks.data() + 3 * (y + 3 * z), kNodesFrom[y], kNodesFrom[z], around_.values.data());
}

}  // namespace meniscus
