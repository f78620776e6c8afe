// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/spread_points.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>

#include "core/mix_bits.h"
#include "core/parallel.h"

namespace meniscus {
namespace {

constexpr std::size_t kPointsPerTask = 1024;

// Uniform in [0, 1): the same for the same seed and number.
double unit_number(std::uint64_t seed, std::uint64_t number) {
    return 0.5 + 0.5 * signed_unit(mix_bits(mix_bits(seed + kMixIncrement) + (number + 1) * kMixIncrement));
}

// Twice the area of a triangle, along its normal.
Vec3 area_vector(const Mesh& mesh, const Triangle& t) {
    const Vec3& a = mesh.vertices[t[0]];
    return cross(mesh.vertices[t[1]] - a, mesh.vertices[t[2]] - a);
}

// Areas of all triangles up to each, that included, Å².
std::vector<double> summed_areas(const Mesh& mesh) {
    std::vector<double> areas(mesh.triangles.size());
    for (std::size_t t = 0; t < areas.size(); ++t) areas[t] = 0.5 * norm(area_vector(mesh, mesh.triangles[t]));
    std::partial_sum(areas.begin(), areas.end(), areas.begin());
    return areas;
}

Vec3 point_on(const Mesh& mesh, const Triangle& t, double u, double v) {
    const double root = std::sqrt(u);  // Turk 1990: uniform over the triangle
    return (1.0 - root) * mesh.vertices[t[0]] + (root * (1.0 - v)) * mesh.vertices[t[1]] +
           (root * v) * mesh.vertices[t[2]];
}

// Cells of a cubic lattice that hold the points, for those near a point.
class PointCells {
public:
    PointCells(std::span<const Vec3> points, double edge) : inverse_edge_(1.0 / edge) {
        order_.resize(points.size());
        std::vector<Cell> cells(points.size());
        for (std::size_t i = 0; i < points.size(); ++i) cells[i] = cell_of(points[i]);
        std::iota(order_.begin(), order_.end(), 0U);
        std::sort(order_.begin(), order_.end(),
                  [&](std::uint32_t a, std::uint32_t b) { return cells[a] != cells[b] ? cells[a] < cells[b] : a < b; });
        cells_.reserve(points.size());
        for (const std::uint32_t i : order_) cells_.push_back(cells[i]);
    }

    /// Calls visit(j) for the points in the cell of `point` and around it.
    template <class Visit>
    void for_each_near(const Vec3& point, const Visit& visit) const {
        const Cell at = cell_of(point);
        for (std::int64_t dz = -1; dz <= 1; ++dz)
            for (std::int64_t dy = -1; dy <= 1; ++dy) {  // along x the three cells follow each other
                const Cell first{at[0] + dz, at[1] + dy, at[2] - 1};
                const Cell last{at[0] + dz, at[1] + dy, at[2] + 1};
                const auto begin = std::lower_bound(cells_.begin(), cells_.end(), first);
                for (auto c = begin; c != cells_.end() && *c <= last; ++c)
                    visit(order_[static_cast<std::size_t>(c - cells_.begin())]);
            }
    }

private:
    using Cell = std::array<std::int64_t, 3>;  // z, y, x

    Cell cell_of(const Vec3& p) const {
        const auto place = [this](double c) { return static_cast<std::int64_t>(std::floor(c * inverse_edge_)); };
        return {place(p.z), place(p.y), place(p.x)};
    }

    double inverse_edge_;
    std::vector<std::uint32_t> order_;  // points, cell by cell
    std::vector<Cell> cells_;           // of each of these
};

// How much a point is in another's way (Yuksel 2015, eqs. 2 and 3): 1 at small distances, 0 from `reach` on.
class Crowding {
public:
    Crowding(double area, std::size_t count) {
        constexpr double kAlmost = 0.65;  // β; distances that are too small are all alike
        const double share = 1.0 / static_cast<double>(kCandidatesPerPoint);
        reach_ = 2.0 * std::sqrt(area / (2.0 * std::numbers::sqrt3 * static_cast<double>(count)));
        least_ = reach_ * (1.0 - share * std::sqrt(share)) * kAlmost;
    }

    double reach() const { return reach_; }
    double operator()(double distance) const {
        const double near = 1.0 - std::min(std::max(distance, least_), reach_) / reach_;
        const double squared = near * near;
        const double fourth = squared * squared;
        return fourth * fourth;
    }

private:
    double reach_;  // 2 r_max: the distance of neighbours that are packed as closely as so many can be
    double least_;
};

struct Neighbour {
    std::uint32_t point;
    float crowding;
};

// The points that are too near to each point.
class Neighbours {
public:
    Neighbours(const Mesh& mesh, const PointsOnMesh& candidates, const Crowding& crowding) {
        const PointCells cells(candidates.points, crowding.reach());
        std::vector<Vec3> normals(candidates.points.size());
        for (std::size_t i = 0; i < normals.size(); ++i)
            normals[i] = area_vector(mesh, mesh.triangles[candidates.triangles[i]]);
        const auto visit_neighbours = [&](std::size_t i, const auto& visit) {
            cells.for_each_near(candidates.points[i], [&](std::uint32_t j) {
                const double distance = norm(candidates.points[j] - candidates.points[i]);
                if (j == i || distance >= crowding.reach() || dot(normals[i], normals[j]) <= 0.0) return;
                visit(Neighbour{j, static_cast<float>(crowding(distance))});
            });
        };
        const std::size_t n = candidates.points.size();
        begins_.assign(n + 1, 0);
        parallel_for(n, kPointsPerTask,
                     [&](std::size_t i) { visit_neighbours(i, [&](const Neighbour&) { ++begins_[i + 1]; }); });
        std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
        all_.resize(begins_.back());
        parallel_for(n, kPointsPerTask, [&](std::size_t i) {
            std::size_t next = begins_[i];
            visit_neighbours(i, [&](const Neighbour& neighbour) { all_[next++] = neighbour; });
        });
    }

    std::span<const Neighbour> of(std::size_t point) const {
        return std::span(all_).subspan(begins_[point], begins_[point + 1] - begins_[point]);
    }

private:
    std::vector<std::size_t> begins_;
    std::vector<Neighbour> all_;
};

// A heap of points with the most crowded one on top; of equally crowded ones that with the smaller number.
class CrowdedHeap {
public:
    explicit CrowdedHeap(std::vector<double> weights)
        : weights_(std::move(weights)), heap_(weights_.size()), places_(weights_.size()) {
        std::iota(heap_.begin(), heap_.end(), 0U);
        std::iota(places_.begin(), places_.end(), 0U);
        for (std::size_t i = heap_.size() / 2; i-- > 0;) sink(i);
    }

    std::size_t size() const { return heap_.size(); }
    bool holds(std::uint32_t point) const { return places_[point] != kGone; }

    std::uint32_t pop() {
        const std::uint32_t top = heap_.front();
        places_[top] = kGone;
        const std::uint32_t last = heap_.back();
        heap_.pop_back();
        if (!heap_.empty() && last != top) {
            put(0, last);
            sink(0);
        }
        return top;
    }

    void relieve(std::uint32_t point, double weight) {
        weights_[point] -= weight;
        sink(places_[point]);
    }

private:
    static constexpr std::uint32_t kGone = 0xffffffffU;

    bool is_before(std::uint32_t a, std::uint32_t b) const {
        return weights_[a] != weights_[b] ? weights_[a] > weights_[b] : a < b;
    }
    void put(std::size_t place, std::uint32_t point) {
        heap_[place] = point;
        places_[point] = static_cast<std::uint32_t>(place);
    }
    void sink(std::size_t place) {
        const std::uint32_t point = heap_[place];
        for (std::size_t child = 2 * place + 1; child < heap_.size(); child = 2 * place + 1) {
            if (child + 1 < heap_.size() && is_before(heap_[child + 1], heap_[child])) ++child;
            if (!is_before(heap_[child], point)) break;
            put(place, heap_[child]);
            place = child;
        }
        put(place, point);
    }

    std::vector<double> weights_;
    std::vector<std::uint32_t> heap_;
    std::vector<std::uint32_t> places_;  // in the heap, of every point
};

}  // namespace

PointsOnMesh scatter_points(const Mesh& mesh, std::size_t count, std::uint64_t seed) {
    const std::vector<double> sums = summed_areas(mesh);
    PointsOnMesh result{std::vector<Vec3>(count), std::vector<std::uint32_t>(count)};
    parallel_for(count, kPointsPerTask, [&](std::size_t i) {
        const double place = static_cast<double>(i) + unit_number(seed, 3 * i);
        const auto at = std::upper_bound(sums.begin(), sums.end(), sums.back() * place / static_cast<double>(count));
        const auto triangle = std::min<std::size_t>(static_cast<std::size_t>(at - sums.begin()), sums.size() - 1);
        result.triangles[i] = static_cast<std::uint32_t>(triangle);
        result.points[i] =
            point_on(mesh, mesh.triangles[triangle], unit_number(seed, 3 * i + 1), unit_number(seed, 3 * i + 2));
    });
    return result;
}

PointsOnMesh spread_points(const Mesh& mesh, std::size_t count, std::uint64_t seed) {
    if (count == 0) return {};
    const PointsOnMesh candidates = scatter_points(mesh, kCandidatesPerPoint * count, seed);
    const Neighbours neighbours(mesh, candidates, Crowding(summed_areas(mesh).back(), count));
    std::vector<double> weights(candidates.points.size(), 0.0);
    for (std::size_t i = 0; i < weights.size(); ++i)
        for (const Neighbour& neighbour : neighbours.of(i)) weights[i] += double{neighbour.crowding};
    CrowdedHeap heap(std::move(weights));
    while (heap.size() > count)
        for (const Neighbour& neighbour : neighbours.of(heap.pop()))
            if (heap.holds(neighbour.point)) heap.relieve(neighbour.point, double{neighbour.crowding});
    PointsOnMesh result;
    for (std::uint32_t i = 0; i < candidates.points.size(); ++i) {
        if (!heap.holds(i)) continue;
        result.points.push_back(candidates.points[i]);
        result.triangles.push_back(candidates.triangles[i]);
    }
    return result;
}

}  // namespace meniscus
