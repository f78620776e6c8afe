// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/winding.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>

#include "core/fresh_memory.h"
#include "core/parallel.h"
#include "geometry/box_tree.h"

namespace meniscus {
namespace {

constexpr std::size_t kChunk = 1 << 16;  // triangles or vertices per task

// Whether an edge, seen from above, passes a point at larger y. Of its ends exactly one lies right of the point. Both
// triangles of the edge compute the same bits.
bool passes_behind(const Vec3& p, const Vec3& a, const Vec3& b, bool b_is_right) {
    return ((b.x - a.x) * (p.y - a.y) < (b.y - a.y) * (p.x - a.x)) == b_is_right;
}

// How often the triangle, seen from above, runs counter-clockwise round a point.
int turns_round(const Mesh& mesh, const Triangle& t, const Vec3& p) {
    int turns = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto [first, second] = std::minmax(t[i], t[(i + 1) % 3]);
        const Vec3& a = mesh.vertices[first];
        const Vec3& b = mesh.vertices[second];
        const bool a_is_right = a.x > p.x;
        const bool b_is_right = b.x > p.x;
        if (a_is_right == b_is_right || !passes_behind(p, a, b, b_is_right)) continue;
        turns += b_is_right == (second == t[i]) ? 1 : -1;
    }
    return turns;
}

// Whether the plane of a triangle, which is not upright, passes above a point.
bool is_above(const Mesh& mesh, const Triangle& t, const Vec3& p) {
    const Vec3& a = mesh.vertices[t[0]];
    const Vec3 normal = cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a);
    return (dot(normal, a - p) > 0.0) == (normal.z > 0.0);
}

// Column and row of a cell.
struct Cell {
    std::uint16_t column = 0;
    std::uint16_t row = 0;
};
Cell lower(Cell a, Cell b) { return {std::min(a.column, b.column), std::min(a.row, b.row)}; }
Cell higher(Cell a, Cell b) { return {std::max(a.column, b.column), std::max(a.row, b.row)}; }

// Points as seen from above, sorted into cells: so many that most are empty.
class PointCells {
public:
    explicit PointCells(std::span<const Vec3> points)
        : edge_(std::clamp<std::size_t>(static_cast<std::size_t>(8.0 * std::sqrt(static_cast<double>(points.size()))),
                                        1, kMostPerEdge)),
          begins_(edge_ * edge_ + 1, 0),
          near_(edge_ * edge_, 0),
          points_(points.size()) {
        Box box;
        for (const Vec3& p : points) box.include(p);
        low_ = box.low;
        const Vec3 size = box.high - box.low;
        per_angstrom_ = {cells_per_angstrom(size.x), cells_per_angstrom(size.y), 0.0};
        for (const Vec3& p : points) ++begins_[place_of(cell_of(p)) + 1];
        for (const Vec3& p : points) mark_near(cell_of(p));
        std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
        std::vector<std::uint32_t> next = begins_;
        for (std::uint32_t i = 0; i < points.size(); ++i) points_[next[place_of(cell_of(points[i]))]++] = i;
    }

    // The cell that a place lies in, or the one nearest to it: a place between two others is in a cell between theirs.
    Cell cell_of(const Vec3& p) const {
        return {number((p.x - low_.x) * per_angstrom_.x), number((p.y - low_.y) * per_angstrom_.y)};
    }

    // Calls visit(number of a point) for the points in the cells between two corners. Quick where these are next to
    // each other and no point is near.
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

struct Numbers {
    std::vector<int> of_point;

    Numbers& operator+=(const Numbers& b) {
        of_point.resize(b.of_point.size());
        for (std::size_t i = 0; i < of_point.size(); ++i) of_point[i] += b.of_point[i];
        return *this;
    }
};

}  // namespace

std::vector<int> winding_numbers(const Mesh& mesh, std::span<const Vec3> points) {
    const PointCells cells(points);
    std::vector<Cell> cell_of_vertex;
    resize_touched(cell_of_vertex, mesh.vertices.size());
    parallel_for(mesh.vertices.size(), kChunk,
                 [&](std::size_t v) { cell_of_vertex[v] = cells.cell_of(mesh.vertices[v]); });
    const auto count = [&](std::size_t begin, std::size_t end) {
        Numbers numbers{std::vector<int>(points.size(), 0)};
        for (const Triangle& t : std::span(mesh.triangles).subspan(begin, end - begin)) {
            const Cell a = cell_of_vertex[t[0]];
            const Cell b = cell_of_vertex[t[1]];
            const Cell c = cell_of_vertex[t[2]];
            const Cell low = lower(lower(a, b), c);
            const Cell high = higher(higher(a, b), c);
            cells.for_each_within(low, high, [&](std::uint32_t i) {
                const int turns = turns_round(mesh, t, points[i]);
                if (turns != 0 && is_above(mesh, t, points[i])) numbers.of_point[i] += turns;
            });
        }
        return numbers;
    };
    Numbers sum = parallel_sum<Numbers>(mesh.triangles.size(), kChunk, count);
    sum.of_point.resize(points.size());
    return std::move(sum.of_point);
}

}  // namespace meniscus
