// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/spline_cursor.h"

#include <algorithm>
#include <cmath>

namespace meniscus {
namespace {

// Cells further from the origin than this cannot have a block, whose coordinates are of 32 bits.
constexpr double kFarthestNode = 8e9;

// Values and derivatives of the four cubic B-splines over a cell, at t in [0, 1] (eq. 2.1 of the paper).
struct Weights {
    double value[4];
    double first[4];
    double second[4];

    Weights(double t, double steps_per_length) {
        const double u = 1.0 - t;
        const double s1 = steps_per_length;
        const double s2 = s1 * s1;
        value[0] = u * u * u / 6.0;
        value[1] = (4.0 - 6.0 * t * t + 3.0 * t * t * t) / 6.0;
        value[2] = (4.0 - 6.0 * u * u + 3.0 * u * u * u) / 6.0;
        value[3] = t * t * t / 6.0;
        first[0] = -0.5 * u * u * s1;
        first[1] = (1.5 * t * t - 2.0 * t) * s1;
        first[2] = (2.0 * u - 1.5 * u * u) * s1;
        first[3] = 0.5 * t * t * s1;
        second[0] = u * s2;
        second[1] = (3.0 * t - 2.0) * s2;
        second[2] = (3.0 * u - 2.0) * s2;
        second[3] = t * s2;
    }
};

// Sums over the slowest axis of N lanes of four, each with its weight. Always in the same order, so that value() and
// sample() give the same bits.
template <int N>
void contract(const double* from, const double (&weights)[4], double* to) {
    for (int lane = 0; lane < N; ++lane)
        to[lane] = (weights[0] * from[lane] + weights[1] * from[N + lane]) +
                   (weights[2] * from[2 * N + lane] + weights[3] * from[3 * N + lane]);
}

double contract(const double* from, const double (&weights)[4]) {
    double sum = 0.0;
    contract<1>(from, weights, &sum);
    return sum;
}

}  // namespace

bool SplineCursor::move_to(const Vec3& point) {
    const Vec3 at = steps_per_length_ * (point - grid_->origin());
    const double u[3] = {at.x, at.y, at.z};
    std::array<std::int64_t, 3> node;
    std::array<double, 3> place;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double floor = std::floor(u[axis]);
        if (!(std::abs(floor) < kFarthestNode)) return false;
        node[axis] = static_cast<std::int64_t>(floor);
        place[axis] = u[axis] - floor;
    }
    if (!move_to_cell(node)) return false;
    place_ = place;
    return true;
}

bool SplineCursor::move_to_cell(const std::array<std::int64_t, 3>& node) {
    place_ = {};
    if (node == node_) return true;
    const bool inside = load(node);
    node_ = inside ? node : std::array<std::int64_t, 3>{kNowhere, kNowhere, kNowhere};
    return inside;
}

bool SplineCursor::load(const std::array<std::int64_t, 3>& node) {
    const auto block = [&](std::size_t axis) { return static_cast<std::int32_t>(node[axis] >> 3); };
    const auto within = [&](std::size_t axis) { return static_cast<int>(node[axis] & (kBlockEdge - 1)); };
    const BlockId found = grid_->find({.z = block(2), .y = block(1), .x = block(0)});
    return found != kNoBlock && copy_coefficients(found, {within(0), within(1), within(2)});
}

bool SplineCursor::copy_coefficients(BlockId block, const std::array<int, 3>& node) {
    const auto& around = grid_->neighbours(block);
    constexpr int kMask = kBlockEdge - 1;
    const int first = node[0] - 1;
    // Of a row of four the first few can lie in the block before, the last few in the one after.
    const int split = first < 0 ? 1 : std::min(kSupport, kBlockEdge - first);
    double* to = local_.data();
    for (int z = node[2] - 1; z < node[2] - 1 + kSupport; ++z)
        for (int y = node[1] - 1; y < node[1] - 1 + kSupport; ++y, to += kSupport) {
            const auto copy = [&](int from, int end) {
                const BlockId id =
                    around[static_cast<std::size_t>(neighbour_slot(side_of(first + from), side_of(y), side_of(z)))];
                if (id == kNoBlock) return false;
                const float* row =
                    coefficients_.data() + std::size_t{id} * kBlockNodes +
                    static_cast<std::size_t>(node_in_block((first + from) & kMask, y & kMask, z & kMask));
                for (int i = from; i < end; ++i) to[i] = row[i - from];
                return true;
            };
            if (!copy(0, split) || (split < kSupport && !copy(split, kSupport))) return false;
        }
    return true;
}

double SplineCursor::value() const {
    double slab[kSupport * kSupport];
    double row[kSupport];
    contract<kSupport * kSupport>(local_.data(), Weights(place_[2], steps_per_length_).value, slab);
    contract<kSupport>(slab, Weights(place_[1], steps_per_length_).value, row);
    return contract(row, Weights(place_[0], steps_per_length_).value);
}

LevelSetSample SplineCursor::sample() const {
    const Weights x(place_[0], steps_per_length_);
    const Weights y(place_[1], steps_per_length_);
    const Weights z(place_[2], steps_per_length_);
    double f[kSupport * kSupport];  // of y and x, after summing over z; suffixes name derivatives
    double f_z[kSupport * kSupport];
    double f_zz[kSupport * kSupport];
    contract<kSupport * kSupport>(local_.data(), z.value, f);
    contract<kSupport * kSupport>(local_.data(), z.first, f_z);
    contract<kSupport * kSupport>(local_.data(), z.second, f_zz);
    double row[kSupport];
    double row_y[kSupport];
    double row_z[kSupport];
    double row_yy[kSupport];
    double row_yz[kSupport];
    double row_zz[kSupport];
    contract<kSupport>(f, y.value, row);
    contract<kSupport>(f, y.first, row_y);
    contract<kSupport>(f, y.second, row_yy);
    contract<kSupport>(f_z, y.value, row_z);
    contract<kSupport>(f_z, y.first, row_yz);
    contract<kSupport>(f_zz, y.value, row_zz);
    return {contract(row, x.value),
            {contract(row, x.first), contract(row_y, x.value), contract(row_z, x.value)},
            {contract(row, x.second), contract(row_yy, x.value), contract(row_zz, x.value), contract(row_y, x.first),
             contract(row_z, x.first), contract(row_yz, x.value)}};
}

int SplineCursor::sign() const {
    std::size_t positive = 0;
    std::size_t negative = 0;
    for (const double c : local_) {
        positive += c > 0.0 ? 1 : 0;
        negative += c < 0.0 ? 1 : 0;
    }
    return (positive == kCoefficients ? 1 : 0) - (negative == kCoefficients ? 1 : 0);
}

}  // namespace meniscus
