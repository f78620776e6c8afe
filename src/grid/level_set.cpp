// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/level_set.h"

#include <cmath>
#include <limits>

#include "grid/block_grid.h"

namespace meniscus {
namespace {

constexpr int kSupport = 4;  // nodes per axis that a cubic B-spline reaches

// Values and derivatives of the four cubic B-splines over a cell, at t in [0, 1] (eq. 2.1 of the paper).
struct Weights {
    double value[kSupport];
    double first[kSupport];
    double second[kSupport];

    Weights(double t, double spacing) {
        const double u = 1.0 - t;
        const double s1 = 1.0 / spacing;
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

// The cell of a point: its lower node, within a block, and where in the cell the point is.
struct Cell {
    BlockId block = kNoBlock;
    int node[3] = {0, 0, 0};
    double t[3] = {0.0, 0.0, 0.0};
};

Cell cell_of(const BlockGrid& grid, const Vec3& point) {
    Cell cell;
    const Vec3 at = (1.0 / grid.spacing()) * (point - grid.origin());
    const double u[3] = {at.x, at.y, at.z};
    std::int32_t block[3];
    for (int axis = 0; axis < 3; ++axis) {
        const double floor = std::floor(u[axis]);
        if (!(std::abs(floor) < 8e9)) return cell;
        const auto node = static_cast<std::int64_t>(floor);
        block[axis] = static_cast<std::int32_t>(node >> 3);
        cell.node[axis] = static_cast<int>(node & (kBlockEdge - 1));
        cell.t[axis] = u[axis] - floor;
    }
    cell.block = grid.find({.z = block[2], .y = block[1], .x = block[0]});
    return cell;
}

// The 4³ coefficients around a cell; false where one of them is outside the band.
bool gather(const BlockGrid& grid, std::span<const float> coefficients, const Cell& cell,
            float (&local)[kSupport * kSupport * kSupport]) {
    const auto& around = grid.neighbours(cell.block);
    int to = 0;
    for (int k = -1; k < kSupport - 1; ++k)
        for (int j = -1; j < kSupport - 1; ++j)
            for (int i = -1; i < kSupport - 1; ++i, ++to) {
                const int x = cell.node[0] + i;
                const int y = cell.node[1] + j;
                const int z = cell.node[2] + k;
                const BlockId block =
                    around[static_cast<std::size_t>(neighbour_slot(side_of(x), side_of(y), side_of(z)))];
                if (block == kNoBlock) return false;
                constexpr int kMask = kBlockEdge - 1;
                local[to] = coefficients[std::size_t{block} * kBlockNodes +
                                         static_cast<std::size_t>(node_in_block(x & kMask, y & kMask, z & kMask))];
            }
    return true;
}

LevelSetSample nowhere() {
    constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
    return {kNan, {kNan, kNan, kNan}, {kNan, kNan, kNan, kNan, kNan, kNan}};
}

}  // namespace

double LevelSetSample::mean_curvature() const {
    const auto& [xx, yy, zz, xy, xz, yz] = hessian;
    const Vec3& g = gradient;
    const double g2 = squared_norm(g);
    const double along =
        g.x * g.x * xx + g.y * g.y * yy + g.z * g.z * zz + 2.0 * (g.x * g.y * xy + g.x * g.z * xz + g.y * g.z * yz);
    return 0.5 * ((xx + yy + zz) - along / g2) / std::sqrt(g2);
}

LevelSet::LevelSet(std::shared_ptr<const BlockGrid> grid, std::vector<float> coefficients)
    : grid_(std::move(grid)), coefficients_(std::move(coefficients)) {}

double LevelSet::spacing() const { return grid_->spacing(); }

double LevelSet::value(const Vec3& point) const { return sample(point).value; }

LevelSetSample LevelSet::sample(const Vec3& point) const {
    const Cell cell = cell_of(*grid_, point);
    float local[kSupport * kSupport * kSupport];
    if (cell.block == kNoBlock || !gather(*grid_, coefficients_, cell, local)) return nowhere();
    const Weights wx(cell.t[0], spacing());
    const Weights wy(cell.t[1], spacing());
    const Weights wz(cell.t[2], spacing());
    LevelSetSample at;
    for (int k = 0; k < kSupport; ++k)
        for (int j = 0; j < kSupport; ++j) {
            const int first = kSupport * (j + kSupport * k);
            const float* row = local + first;
            double f = 0.0;
            double fx = 0.0;
            double fxx = 0.0;
            for (int i = 0; i < kSupport; ++i) {
                f += wx.value[i] * row[i];
                fx += wx.first[i] * row[i];
                fxx += wx.second[i] * row[i];
            }
            const double yz = wy.value[j] * wz.value[k];
            at.value += yz * f;
            at.gradient += Vec3{yz * fx, wy.first[j] * wz.value[k] * f, wy.value[j] * wz.first[k] * f};
            at.hessian[0] += yz * fxx;
            at.hessian[1] += wy.second[j] * wz.value[k] * f;
            at.hessian[2] += wy.value[j] * wz.second[k] * f;
            at.hessian[3] += wy.first[j] * wz.value[k] * fx;
            at.hessian[4] += wy.value[j] * wz.first[k] * fx;
            at.hessian[5] += wy.first[j] * wz.first[k] * f;
        }
    return at;
}

Vec3 LevelSet::project(const Vec3& point) const {
    constexpr int kMaxIterations = 6;
    const double close_enough = 1e-7 * spacing();
    Vec3 at = point;
    for (int i = 0; i < kMaxIterations; ++i) {
        const LevelSetSample here = sample(at);
        const double slope2 = squared_norm(here.gradient);
        if (!(slope2 > 0.0)) return point;
        if (std::abs(here.value) <= close_enough) return at;
        at = at - (here.value / slope2) * here.gradient;
        if (!(norm(at - point) < spacing())) return point;
    }
    return at;
}

}  // namespace meniscus
