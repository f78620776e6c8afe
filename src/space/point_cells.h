// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Points found by where they are along x and y.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

#include "meniscus/vec3.h"
#include "space/box_tree.h"

namespace meniscus {

/// Points as seen from above, sorted into cells.
class PointCells {
public:
    /// Column and row of a cell.
    struct Cell {
        std::uint16_t column = 0;
        std::uint16_t row = 0;
    };

    /// cost   O(n)
    PointCells(std::span<const Vec3> points, double cells_per_point)
        : edge_(std::clamp<std::size_t>(
              static_cast<std::size_t>(std::sqrt(cells_per_point * static_cast<double>(points.size()))), 1,
              kMostPerEdge)),
          begins_(edge_ * edge_ + 1, 0),
          near_(edge_ * edge_, 0),
          points_(points.size()) {
        const Box box = box_of(points);
        low_ = box.low;
        const Vec3 size = box.high - box.low;
        per_angstrom_ = {cells_per_angstrom(size.x), cells_per_angstrom(size.y), 0.0};
        for (const Vec3& p : points) ++begins_[place_of(cell_of(p)) + 1];
        for (const Vec3& p : points) mark_near(cell_of(p));
        std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
        std::vector<std::uint32_t> next = begins_;
        for (std::uint32_t i = 0; i < points.size(); ++i) points_[next[place_of(cell_of(points[i]))]++] = i;
    }

    /// The cell that a place lies in, or the one nearest to it: a place between two others is in a cell between theirs.
    Cell cell_of(const Vec3& p) const {
        return {number((p.x - low_.x) * per_angstrom_.x), number((p.y - low_.y) * per_angstrom_.y)};
    }

    /// Calls visit(number of a point) for the points in the cells between two corners. Quick where these are next to
    /// each other and no point is near.
    template <class Visit>
    void for_each_within(Cell low, Cell high, const Visit& visit) const {
        const bool small = (high.column <= low.column + 1) & (high.row <= low.row + 1);
        if (small && near_[place_of(low)] == 0) return;
        for (std::size_t row = low.row; row <= high.row; ++row) {
            const std::uint32_t end = begins_[row * edge_ + high.column + 1];
            for (std::uint32_t i = begins_[row * edge_ + low.column]; i < end; ++i) visit(points_[i]);
        }
    }

private:
    static constexpr std::size_t kMostPerEdge = 1024;

    double cells_per_angstrom(double size) const { return size > 0.0 ? static_cast<double>(edge_) / size : 0.0; }
    // 0 where there is no number: no points, no cells.
    std::uint16_t number(double cells) const {
        return static_cast<std::uint16_t>(std::min(std::max(0.0, cells), static_cast<double>(edge_ - 1)));
    }
    std::size_t place_of(Cell cell) const { return cell.row * edge_ + cell.column; }
    void mark_near(Cell cell) {
        for (int row = std::max(0, cell.row - 1); row <= cell.row; ++row)
            for (int column = std::max(0, cell.column - 1); column <= cell.column; ++column)
                near_[place_of({static_cast<std::uint16_t>(column), static_cast<std::uint16_t>(row)})] = 1;
    }

    std::size_t edge_;
    Vec3 low_;
    Vec3 per_angstrom_;
    std::vector<std::uint32_t> begins_;  // of each cell among the points, and the end
    std::vector<std::uint8_t> near_;     // per cell: whether it, or the next in column or row or both, holds points
    std::vector<std::uint32_t> points_;
};

inline PointCells::Cell lower(PointCells::Cell a, PointCells::Cell b) {
    return {std::min(a.column, b.column), std::min(a.row, b.row)};
}
inline PointCells::Cell higher(PointCells::Cell a, PointCells::Cell b) {
    return {std::max(a.column, b.column), std::max(a.row, b.row)};
}

}  // namespace meniscus
