// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/spline_cursor.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meniscus {
namespace {

// Cells further from the origin than this cannot have a block, whose coordinates are of 32 bits.
constexpr double kFarthestNode = 8e9;

// The four nodes along one axis whose splines reach a cell, the second of which is the cell's lower node. They can lie
// in the block before the cell's, or in the one after.
struct SupportNodes {
    int first;    // node, counted from the cell's block
    int side;     // of the block that holds it: -1 or 0
    int borders;  // between blocks, among the nodes: 0 or 1
    int split;    // how many come before the border

    explicit SupportNodes(int node)
        : first(node - 1),
          side(side_of(first)),
          borders(side_of(node + 2) - side),
          split(first < 0 ? 1 : kBlockEdge - first) {}
    int beyond(int i) const { return i < split ? 0 : 1; }
    int node(int i) const { return (first + i) & (kBlockEdge - 1); }
};

}  // namespace

bool SplineCursor::move_to(const Vec3& point) {
    const Vec3 at = steps_per_length_ * (point - grid_->origin());
    const double u[3] = {at.x, at.y, at.z};
    std::array<std::int64_t, 3> node;
    std::array<double, 3> place;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        if (!(std::abs(u[axis]) < kFarthestNode)) return false;
        const auto towards_zero = static_cast<std::int64_t>(u[axis]);  // std::floor is a call on old machines
        node[axis] = towards_zero - (static_cast<double>(towards_zero) > u[axis] ? 1 : 0);
        place[axis] = u[axis] - static_cast<double>(node[axis]);
    }
    if (!move_to_cell(node)) return false;
    place_ = place;
    return true;
}

bool SplineCursor::move_to_cell(const std::array<std::int64_t, 3>& node) {
    place_ = {};
    // One by one: memcmp would wait for what has just been written.
    if (node[0] == node_[0] && node[1] == node_[1] && node[2] == node_[2]) return true;
    const bool inside = load(node);
    node_ = inside ? node : std::array<std::int64_t, 3>{kNowhere, kNowhere, kNowhere};
    return inside;
}

bool SplineCursor::load(const std::array<std::int64_t, 3>& node) {
    const BlockCoord at{.z = block_of_node(node[2]), .y = block_of_node(node[1]), .x = block_of_node(node[0])};
    if (block_ == kNoBlock || at != grid_->coord(block_)) block_ = grid_->find(at);
    return block_ != kNoBlock &&
           copy_coefficients(block_, {place_in_block(node[0]), place_in_block(node[1]), place_in_block(node[2])});
}

bool SplineCursor::copy_coefficients(BlockId block, const std::array<int, 3>& node) {
    const SupportNodes x(node[0]);
    const SupportNodes y(node[1]);
    const SupportNodes z(node[2]);
    const auto& around = grid_->neighbours(block);
    const float* corner[2][2][2];  // of the blocks that hold coefficients, by the sides z, y, x
    for (int k = 0; k <= z.borders; ++k)
        for (int j = 0; j <= y.borders; ++j)
            for (int i = 0; i <= x.borders; ++i) {
                const BlockId id = around[static_cast<std::size_t>(neighbour_slot(x.side + i, y.side + j, z.side + k))];
                if (id == kNoBlock) return false;
                corner[k][j][i] = coefficients_.data() + std::size_t{id} * kBlockNodes;
            }
    float* to = local_.data();
    for (int k = 0; k < kSupport; ++k)
        for (int j = 0; j < kSupport; ++j, to += kSupport) {
            const float* const* row = corner[z.beyond(k)][y.beyond(j)];
            const int offset = node_in_block(0, y.node(j), z.node(k));
            if (x.borders == 0)
                for (int i = 0; i < kSupport; ++i) to[i] = row[0][offset + x.first + i];
            else
                for (int i = 0; i < kSupport; ++i) to[i] = row[x.beyond(i)][offset + x.node(i)];
        }
    return true;
}

int SplineCursor::sign() const {
    std::size_t positive = 0;
    std::size_t negative = 0;
    for (const float c : local_) {
        positive += c > 0.0F ? 1 : 0;
        negative += c < 0.0F ? 1 : 0;
    }
    return (positive == kCoefficients ? 1 : 0) - (negative == kCoefficients ? 1 : 0);
}

LevelSetSample nowhere() {
    const double unknown = std::numeric_limits<double>::quiet_NaN();
    return {unknown, {unknown, unknown, unknown}, {unknown, unknown, unknown, unknown, unknown, unknown}};
}

namespace {

LevelSetSample first_order_sample(const SplineCursor& cursor) {
    LevelSetSample sample = nowhere();
    const ValueAndGradient here = cursor.value_and_gradient();
    sample.value = here.value;
    sample.gradient = here.gradient;
    return sample;
}

template <bool kSecondOrder>
SplineProjection project(SplineCursor& cursor, const Vec3& point, double spacing) {
    constexpr int kMaxIterations = 6;
    constexpr int kUsuallyThere = 2;  // from this iteration on second derivatives are not in vain
    const double close_enough = 1e-7 * spacing;
    const auto sample = [&cursor] { return kSecondOrder ? cursor.sample() : first_order_sample(cursor); };
    const auto sample_at = [&](const Vec3& p) { return cursor.move_to(p) ? sample() : nowhere(); };
    Vec3 at = point;
    for (int i = 0; i < kMaxIterations && cursor.move_to(at); ++i) {
        const bool is_last_order = !kSecondOrder || i >= kUsuallyThere;
        const LevelSetSample here = is_last_order ? sample() : first_order_sample(cursor);
        const double slope2 = squared_norm(here.gradient);
        if (!(slope2 > 0.0)) break;
        if (std::abs(here.value) <= close_enough) return {at, is_last_order ? here : sample()};
        at = at - (here.value / slope2) * here.gradient;
        if (!(norm(at - point) < spacing)) break;
        if (i + 1 == kMaxIterations) return {at, sample_at(at)};
    }
    return {point, sample_at(point)};
}

}  // namespace

SplineProjection project_to_zero_set(SplineCursor& cursor, const Vec3& point, double spacing) {
    return project<true>(cursor, point, spacing);
}

SplineProjection project_to_zero_set_first_order(SplineCursor& cursor, const Vec3& point, double spacing) {
    return project<false>(cursor, point, spacing);
}

}  // namespace meniscus
