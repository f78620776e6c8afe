// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/mesh_quality.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "core/parallel.h"
#include "geometry/box_tree.h"
#include "geometry/canonical_atoms.h"
#include "geometry/local_features.h"
#include "geometry/spatial_order.h"

namespace meniscus {
namespace {

constexpr std::size_t kChunk = 256;  // triangles

// Of a value that so many parts of the others are below. Changes the order.
double at_part(std::vector<double>& values, double part) {
    const auto place =
        values.begin() + static_cast<std::ptrdiff_t>(std::lround(part * static_cast<double>(values.size() - 1)));
    std::nth_element(values.begin(), place, values.end());
    return *place;
}

Percentiles percentiles(std::vector<double> values) {
    if (values.empty()) return {};
    return {at_part(values, 0.0), at_part(values, 0.05), at_part(values, 0.5), at_part(values, 0.95),
            at_part(values, 1.0)};
}

double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(norm(cross(a, b)), dot(a, b)) * (180.0 / std::numbers::pi);
}

// R / 2 r of sides a, b, c: a b c / ((b + c - a) (c + a - b) (a + b - c)).
double aspect_ratio(double a, double b, double c) {
    const double product = (b + c - a) * (c + a - b) * (a + b - c);
    return product > 0.0 ? a * b * c / product : std::numeric_limits<double>::infinity();
}

// The point of a triangle that is nearest to p (Ericson 2005, Real-Time Collision Detection, 5.1.5).
Vec3 nearest_in_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 ab = b - a;
    const Vec3 ac = c - a;
    const double d1 = dot(ab, p - a);
    const double d2 = dot(ac, p - a);
    if (d1 <= 0.0 && d2 <= 0.0) return a;
    const double d3 = dot(ab, p - b);
    const double d4 = dot(ac, p - b);
    if (d3 >= 0.0 && d4 <= d3) return b;
    const double vc = d1 * d4 - d3 * d2;
    if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return a + (d1 / (d1 - d3)) * ab;
    const double d5 = dot(ab, p - c);
    const double d6 = dot(ac, p - c);
    if (d6 >= 0.0 && d5 <= d6) return c;
    const double vb = d5 * d2 - d1 * d6;
    if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return a + (d2 / (d2 - d6)) * ac;
    const double va = d3 * d6 - d5 * d4;
    if (va <= 0.0 && d4 >= d3 && d5 >= d6) return b + ((d4 - d3) / ((d4 - d3) + (d5 - d6))) * (c - b);
    const double scale = 1.0 / (va + vb + vc);
    return a + (vb * scale) * ab + (vc * scale) * ac;
}

// Distances with the area that each stands for.
class WeightedDistances {
public:
    explicit WeightedDistances(std::size_t count) : pairs_(count) {}
    void set(std::size_t i, double distance, double weight) { pairs_[i] = {distance, weight}; }

    DistanceSummary summarise() && {
        if (pairs_.empty()) return {};
        std::sort(pairs_.begin(), pairs_.end());
        double weight = 0.0;
        double sum = 0.0;
        for (const auto& [distance, area] : pairs_) {
            weight += area;
            sum += area * distance;
        }
        DistanceSummary result{sum / weight, 0.0, pairs_.back().first};
        double below = 0.0;
        for (const auto& [distance, area] : pairs_) {
            below += area;
            result.p99 = distance;
            if (below >= 0.99 * weight) break;
        }
        return result;
    }

private:
    std::vector<std::pair<double, double>> pairs_;
};

// Finds the point of a mesh that is nearest to a point.
class MeshTree {
public:
    explicit MeshTree(const Mesh& mesh) : mesh_(mesh), order_(triangles_in_spatial_order(mesh)) {
        std::vector<Box> boxes(order_.size());
        for (std::size_t i = 0; i < order_.size(); ++i)
            for (const VertexId v : mesh.triangles[order_[i]]) boxes[i].include(mesh.vertices[v]);
        tree_ = BoxTree(std::move(boxes));
    }

    double distance(const Vec3& point) const {
        double least = std::numeric_limits<double>::infinity();
        tree_.search_nearest(
            point, [&least] { return least; },
            [&](std::uint32_t i) {
                const auto& [a, b, c] = mesh_.triangles[order_[i]];
                const Vec3 nearest =
                    nearest_in_triangle(point, mesh_.vertices[a], mesh_.vertices[b], mesh_.vertices[c]);
                least = std::min(least, squared_norm(point - nearest));
            });
        return std::sqrt(least);
    }

private:
    const Mesh& mesh_;
    std::vector<std::uint32_t> order_;
    BoxTree tree_;
};

// Barycentric coordinates of points that stand for four equal parts of a triangle.
constexpr std::array<std::array<double, 3>, 4> kSamples{{{1.0 / 3, 1.0 / 3, 1.0 / 3},
                                                         {2.0 / 3, 1.0 / 6, 1.0 / 6},
                                                         {1.0 / 6, 2.0 / 3, 1.0 / 6},
                                                         {1.0 / 6, 1.0 / 6, 2.0 / 3}}};

}  // namespace

MeshQuality measure_quality(const Mesh& mesh) {
    MeshQuality quality;
    std::vector<double> smallest;
    std::vector<double> ratios;
    std::vector<double> lengths;
    smallest.reserve(mesh.triangles.size());
    ratios.reserve(mesh.triangles.size());
    lengths.reserve(mesh.triangles.size() * 3 / 2);
    for (const Triangle& t : mesh.triangles) {
        std::array<Vec3, 3> sides;  // from each corner to the next
        for (std::size_t k = 0; k < 3; ++k) sides[k] = mesh.vertices[t[(k + 1) % 3]] - mesh.vertices[t[k]];
        double least = 180.0;
        for (std::size_t k = 0; k < 3; ++k) {
            const double angle = angle_between(sides[k], -sides[(k + 2) % 3]);
            least = std::min(least, angle);
            ++quality.angles[std::min<std::size_t>(17, static_cast<std::size_t>(angle / 10.0))];
            if (t[k] < t[(k + 1) % 3]) lengths.push_back(norm(sides[k]));
        }
        smallest.push_back(least);
        ratios.push_back(aspect_ratio(norm(sides[0]), norm(sides[1]), norm(sides[2])));
    }
    quality.smallest_angles = percentiles(std::move(smallest));
    quality.edges = percentiles(std::move(lengths));
    quality.aspect_ratios = percentiles(std::move(ratios));
    return quality;
}

TwoSidedDistance measure_distance(const Mesh& mesh, const AccessibleSurface& surface) {
    const MeshTree tree(mesh);
    WeightedDistances to_exact(kSamples.size() * mesh.triangles.size());
    WeightedDistances from_exact(kSamples.size() * mesh.triangles.size());
    parallel_chunks(mesh.triangles.size(), kChunk, [&](std::size_t begin, std::size_t end) {
        std::vector<Vec3> points;
        for (std::size_t t = begin; t < end; ++t) {
            const auto& [a, b, c] = mesh.triangles[t];
            for (const auto& [u, v, w] : kSamples)
                points.push_back(u * mesh.vertices[a] + v * mesh.vertices[b] + w * mesh.vertices[c]);
        }
        const std::vector<NearestFeature> features = nearest_features(surface, points);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const auto& [a, b, c] = mesh.triangles[begin + i / kSamples.size()];
            const double area = norm(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]));
            const std::size_t sample = kSamples.size() * begin + i;
            const double distance = features[i].signed_distance;
            to_exact.set(sample, std::abs(distance), area);
            from_exact.set(sample, tree.distance(points[i] - distance * features[i].normal), area);
        }
    });
    return {std::move(to_exact).summarise(), std::move(from_exact).summarise()};
}

}  // namespace meniscus
