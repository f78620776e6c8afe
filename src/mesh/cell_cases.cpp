// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/cell_cases.h"

#include <cstddef>
#include <stdexcept>
#include <utility>

namespace meniscus {
namespace {

// A closed walk over cut edges. Every vertex has its own edge, so twelve is the most.
struct Loop {
    int size = 0;
    std::array<int, kCellEdges> edges{};
};

struct Point {
    int x = 0;
    int y = 0;
    int z = 0;
};

constexpr Point operator-(Point a, Point b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr int dot(Point a, Point b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

// Corners of the six faces, counter-clockwise seen from outside the cube.
constexpr std::array<std::array<int, 4>, 6> kFaces{
    {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}};

constexpr bool is_inside(int cell_case, int corner) { return ((cell_case >> corner) & 1) != 0; }

constexpr int edge_between(int a, int b) {
    for (int e = 0; e < kCellEdges; ++e) {
        const int base = edge_base_corner(e);
        if (base == (a & b) && (a ^ b) == (1 << edge_direction(e))) return e;
    }
    throw std::logic_error("corners without a common edge");
}

// Segments on one face, as edge -> next edge. Walking round the face, each run of inside corners is entered at one cut
// edge and left at the next: a segment from the entry to the exit has the inside to its right, seen from outside the
// cube, which makes loops counter-clockwise seen from the outside corners.
constexpr void add_segments(int cell_case, const std::array<int, 4>& face, std::array<int, kCellEdges>& next) {
    for (std::size_t k = 0; k < 4; ++k) {
        if (is_inside(cell_case, face[k]) || !is_inside(cell_case, face[(k + 1) % 4])) continue;
        std::size_t exit = k + 1;
        while (is_inside(cell_case, face[(exit + 1) % 4])) ++exit;
        next[static_cast<std::size_t>(edge_between(face[k], face[(k + 1) % 4]))] =
            edge_between(face[exit % 4], face[(exit + 1) % 4]);
    }
}

constexpr bool on_common_face(int e, int f) {
    const int common = ~(edge_base_corner(e) ^ edge_base_corner(f));
    for (int axis = 0; axis < 3; ++axis)
        if (axis != edge_direction(e) && axis != edge_direction(f) && ((common >> axis) & 1) != 0) return true;
    return false;
}

// Middle of an edge, in units of half an edge.
constexpr Point middle_of(int edge) {
    const int base = edge_base_corner(edge);
    const int d = edge_direction(edge);
    return {2 * (base & 1) + (d == 0 ? 1 : 0), (base & 2) + (d == 1 ? 1 : 0), ((base & 4) >> 1) + (d == 2 ? 1 : 0)};
}

// Shape of the triangle between the middles of three edges: (2 area / sum of squared sides)², 1/12 if equilateral.
constexpr double shape_of(int e, int f, int g) {
    const Point u = middle_of(f) - middle_of(e);
    const Point v = middle_of(g) - middle_of(e);
    const Point w = v - u;
    const double sum = dot(u, u) + dot(v, v) + dot(w, w);
    return static_cast<double>(dot(u, u) * dot(v, v) - dot(u, v) * dot(u, v)) / (sum * sum);
}

// The best triangulation of the part i..j of a loop: its worst shape (-1: none is admissible) and the third corner of
// the triangle on the side i-j.
struct Part {
    double shape = 1.0;
    int middle = 0;
};
using Parts = std::array<std::array<Part, kCellEdges>, kCellEdges>;

constexpr Part best_part(const Loop& loop, const Parts& parts, int i, int j) {
    const auto edge = [&](int n) { return loop.edges[static_cast<std::size_t>(n)]; };
    const auto shape = [&](int a, int b) {
        return parts[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)].shape;
    };
    Part best{.shape = -1.0};
    if (j - i + 1 < loop.size && on_common_face(edge(i), edge(j))) return best;
    for (int k = i + 1; k < j; ++k) {
        double worst = shape_of(edge(i), edge(k), edge(j));
        if (shape(i, k) < worst) worst = shape(i, k);
        if (shape(k, j) < worst) worst = shape(k, j);
        if (worst > best.shape) best = {.shape = worst, .middle = k};
    }
    return best;
}

// Adds the triangles of the part from edge i to edge j.
struct LoopPart {
    int i;
    int j;
};
constexpr void add_triangles(const Loop& loop, const Parts& parts, LoopPart part, CellCase& out) {
    const auto [i, j] = part;
    if (j - i < 2) return;
    const auto edge = [&](int n) { return static_cast<std::uint8_t>(loop.edges[static_cast<std::size_t>(n)]); };
    const int k = parts[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)].middle;
    out.triangles[out.count++] = {edge(i), edge(k), edge(j)};
    add_triangles(loop, parts, {i, k}, out);
    add_triangles(loop, parts, {k, j}, out);
}

// Triangulates a loop without diagonals that lie in a face, the worst triangle as well shaped as can be.
constexpr void triangulate(const Loop& loop, CellCase& out) {
    Parts parts{};
    for (int length = 2; length < loop.size; ++length)
        for (int i = 0, j = length; j < loop.size; ++i, ++j)
            parts[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] = best_part(loop, parts, i, j);
    if (parts[0][static_cast<std::size_t>(loop.size - 1)].shape <= 0.0)
        throw std::logic_error("a loop without admissible triangulation");
    add_triangles(loop, parts, {0, loop.size - 1}, out);
}

constexpr CellCase make_case(int cell_case) {
    std::array<int, kCellEdges> next{};
    next.fill(-1);
    for (const auto& face : kFaces) add_segments(cell_case, face, next);
    CellCase out;
    for (std::size_t start = 0; start < kCellEdges; ++start) {
        Loop loop;
        for (std::size_t e = start; next[e] >= 0;) {
            loop.edges[static_cast<std::size_t>(loop.size++)] = static_cast<int>(e);
            e = static_cast<std::size_t>(std::exchange(next[e], -1));
        }
        if (loop.size > 0) triangulate(loop, out);
    }
    return out;
}

// One constant per case: compilers limit the steps of a single constant expression.
template <int CellCaseNumber>
constexpr CellCase kCaseOf = make_case(CellCaseNumber);

template <int... Numbers>
constexpr std::array<CellCase, 256> all_cases(std::integer_sequence<int, Numbers...>) {
    return {kCaseOf<Numbers>...};
}

}  // namespace

constexpr std::array<CellCase, 256> kCellCases = all_cases(std::make_integer_sequence<int, 256>{});

}  // namespace meniscus
