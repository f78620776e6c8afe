// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "meniscus/errors.h"
#include "meniscus/volume.h"

namespace meniscus {
namespace {

constexpr std::size_t kChunk = 1024;
constexpr std::size_t kStencilNodes = 4;

// The nodes along one axis that a value is made of, and their shares.
struct Stencil {
    std::size_t first = 0;
    std::size_t count = 0;  // 0: outside
    std::array<double, kStencilNodes> weights{};
};

// The cell that a coordinate lies in and how far in it, 0 to 1. The last node belongs to the last cell.
struct Cell {
    std::size_t index = 0;
    double t = 0.0;
};

bool locate(double x, double origin, double spacing, std::size_t count, Cell& cell) {
    const double u = (x - origin) / spacing;
    const auto last = static_cast<double>(count - 1);
    if (!(u >= 0.0 && u <= last)) return false;
    cell.index = std::min(static_cast<std::size_t>(u), count < 2 ? 0 : count - 2);
    cell.t = u - static_cast<double>(cell.index);
    return true;
}

Stencil linear(const Cell& cell, std::size_t count) {
    if (count == 1) return {0, 1, {1.0}};
    return {cell.index, 2, {1.0 - cell.t, cell.t}};
}

// Keys 1981, a = -1/2; see https://doi.org/10.1109/TASSP.1981.1163711
std::array<double, kStencilNodes> catmull_rom(double t) {
    return {0.5 * t * (-1.0 + t * (2.0 - t)), 1.0 + 0.5 * t * t * (-5.0 + 3.0 * t),
            0.5 * t * (1.0 + t * (4.0 - 3.0 * t)), 0.5 * t * t * (t - 1.0)};
}

// A node that is missing has the value that the parabola (two nodes: the line) through the nearest ones has there.
Stencil cubic(const Cell& cell, std::size_t count) {
    if (count < 3) return linear(cell, count);
    const std::array<double, kStencilNodes> w = catmull_rom(cell.t);
    const bool has_left = cell.index > 0;
    const bool has_right = cell.index + 2 < count;
    if (has_left && has_right) return {cell.index - 1, 4, w};
    if (has_right) return {0, 3, {w[1] + 3.0 * w[0], w[2] - 3.0 * w[0], w[3] + w[0]}};
    return {count - 3, 3, {w[0] + w[3], w[1] - 3.0 * w[3], w[2] + 3.0 * w[3]}};
}

class Interpolator {
public:
    Interpolator(const Volume& volume, Interpolation interpolation)
        : volume_(volume), make_(interpolation == Interpolation::Linear ? linear : cubic) {}

    double operator()(const Vec3& point) const {
        const VolumeGrid& grid = volume_.grid;
        std::array<Cell, 3> cells;
        if (!locate(point.x, grid.origin.x, grid.spacing.x, grid.counts[0], cells[0]) ||
            !locate(point.y, grid.origin.y, grid.spacing.y, grid.counts[1], cells[1]) ||
            !locate(point.z, grid.origin.z, grid.spacing.z, grid.counts[2], cells[2]))
            return std::numeric_limits<double>::quiet_NaN();
        return sum(make_(cells[0], grid.counts[0]), make_(cells[1], grid.counts[1]), make_(cells[2], grid.counts[2]));
    }

private:
    double sum(const Stencil& x, const Stencil& y, const Stencil& z) const {
        double total = 0.0;
        for (std::size_t i = 0; i < x.count; ++i)
            for (std::size_t j = 0; j < y.count; ++j) {
                const float* row = &volume_.values[volume_.grid.index(x.first + i, y.first + j, z.first)];
                double along = 0.0;
                for (std::size_t k = 0; k < z.count; ++k) along += z.weights[k] * static_cast<double>(row[k]);
                total += x.weights[i] * y.weights[j] * along;
            }
        return total;
    }

    const Volume& volume_;
    Stencil (*make_)(const Cell&, std::size_t);
};

}  // namespace

VolumeGrid centred_grid(const std::array<std::size_t, 3>& counts, double spacing, const Vec3& middle) {
    const auto half = [spacing](std::size_t count) { return 0.5 * spacing * static_cast<double>(count - 1); };
    return {counts, middle - Vec3{half(counts[0]), half(counts[1]), half(counts[2])}, {spacing, spacing, spacing}};
}

std::vector<double> interpolate(const Volume& volume, std::span<const Vec3> points, Interpolation interpolation) {
    if (volume.grid.size() != volume.values.size() || volume.values.empty())
        throw UsageError(fmt::format("a volume with {} values has a grid of {} nodes; give one value per node",
                                     volume.values.size(), volume.grid.size()));
    const Interpolator value(volume, interpolation);
    std::vector<double> values(points.size());
    parallel_chunks(points.size(), kChunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) values[i] = value(points[i]);
    });
    return values;
}

}  // namespace meniscus
