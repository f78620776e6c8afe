// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Points of one neighbourhood after the other: a counting sort by cells.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "space/box_tree.h"

namespace meniscus {

/// Points sorted by the cubes they lie in: what is near to those of a cube is looked for once for all of them.
class CellOrder {
public:
    /// Sorts points, all of them finite, into cubes of an edge, Å.
    ///
    /// returns  false, with nothing done, where that takes more cubes than `most`
    /// cost     O(n + cubes)
    bool sort(std::span<const Vec3> points, double edge, std::size_t most) {
        const Box box = box_of(points);
        const Vec3 extent = (1.0 / edge) * (box.high - box.low);
        const double nx = std::floor(extent.x) + 1.0;
        const double ny = std::floor(extent.y) + 1.0;
        const double nz = std::floor(extent.z) + 1.0;
        if (!(nx * ny * nz <= static_cast<double>(most))) return false;
        begins_.assign(static_cast<std::size_t>(nx * ny * nz) + 1, 0);
        cells_.resize(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Vec3 q = (1.0 / edge) * (points[i] - box.low);
            cells_[i] = static_cast<std::uint32_t>(std::floor(q.x) + nx * (std::floor(q.y) + ny * std::floor(q.z)));
            ++begins_[cells_[i]];
        }
        std::exclusive_scan(begins_.begin(), begins_.end(), begins_.begin(), std::uint32_t{0});
        order_.resize(points.size());
        points_.resize(points.size());
        for (std::uint32_t i = 0; i < points.size(); ++i) {
            const std::uint32_t to = begins_[cells_[i]]++;
            order_[to] = i;
            points_[to] = points[i];
        }
        return true;
    }

    /// Of a cell: its points, and their positions in the list that was sorted.
    struct Cell {
        std::span<const Vec3> points;
        std::span<const std::uint32_t> positions;
    };
    std::size_t size() const { return begins_.empty() ? 0 : begins_.size() - 1; }
    Cell operator[](std::size_t cell) const {
        const std::size_t begin = cell == 0 ? 0 : begins_[cell - 1];
        const std::size_t count = begins_[cell] - begin;
        return {std::span(points_).subspan(begin, count), std::span(order_).subspan(begin, count)};
    }

private:
    std::vector<std::uint32_t> begins_;  // per cell; after sorting where it ends
    std::vector<std::uint32_t> cells_;   // per point
    std::vector<std::uint32_t> order_;
    std::vector<Vec3> points_;
};

}  // namespace meniscus
