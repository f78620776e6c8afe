// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/depth_layers.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/perpendicular.h"

namespace meniscus {
namespace {

constexpr float kFar = std::numeric_limits<float>::infinity();
constexpr double kMostPixels = 1 << 24U;

/// The first and the last middle of a pixel between two coordinates, which are not negative; the last is before the
/// first for none. Conversion to a whole number takes a fraction of the time of std::ceil and std::floor.
struct Middles {
    // NOLINTNEXTLINE(bugprone-incorrect-roundings): std::lround is slow, too
    Middles(float low, float high) : first(static_cast<int>(low + 0.5F)), last(static_cast<int>(high + 0.5F) - 1) {}
    bool empty() const { return last < first; }

    int first;
    int last;
};

}  // namespace

DepthLayers::DepthLayers(const Mesh& mesh, const Vec3& axis, double pixel)
    : right_(perpendicular(axis)), up_(meniscus::cross(axis, right_)), axis_(axis) {
    fit(mesh, pixel);
    std::vector<Place> places;
    places.reserve(mesh.vertices.size());
    for (const Vec3& vertex : mesh.vertices) places.push_back(place(vertex));
    std::vector<Crossing> crossings;
    for (const auto& [a, b, c] : mesh.triangles) cross(places[a], places[b], places[c], crossings);
    sort(crossings);
}

/// The grid covers all vertices.
void DepthLayers::fit(const Mesh& mesh, double pixel) {
    double right = left_ = dot(mesh.vertices.front(), right_);
    double top = bottom_ = dot(mesh.vertices.front(), up_);
    for (const Vec3& vertex : mesh.vertices) {
        const double x = dot(vertex, right_);
        const double y = dot(vertex, up_);
        left_ = std::min(left_, x);
        right = std::max(right, x);
        bottom_ = std::min(bottom_, y);
        top = std::max(top, y);
    }
    const double width = right - left_;
    const double height = top - bottom_;
    per_angstrom_ = 1.0 / std::max({pixel, std::sqrt(width * height / kMostPixels), (width + height) / kMostPixels});
    columns_ = static_cast<int>(width * per_angstrom_) + 1;
    rows_ = static_cast<int>(height * per_angstrom_) + 1;
}

DepthLayers::Place DepthLayers::place(const Vec3& point) const {
    return {static_cast<float>((dot(point, right_) - left_) * per_angstrom_),
            static_cast<float>((dot(point, up_) - bottom_) * per_angstrom_), static_cast<float>(dot(point, axis_))};
}

/// The middles of pixels on which a triangle lies. On the edge between two triangles a middle counts once or twice,
/// which makes no difference.
void DepthLayers::cross(const Place& a, const Place& b, const Place& c, std::vector<Crossing>& crossings) const {
    const Middles x(std::min({a.x, b.x, c.x}), std::max({a.x, b.x, c.x}));
    if (x.empty()) return;
    const Middles y(std::min({a.y, b.y, c.y}), std::max({a.y, b.y, c.y}));
    const float twice = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
    if (y.empty() || twice == 0.0F) return;
    const float share = 1.0F / twice;
    for (int row = y.first; row <= y.last; ++row)
        for (int column = x.first; column <= x.last; ++column) {
            const float dx = static_cast<float>(column) + 0.5F - a.x;
            const float dy = static_cast<float>(row) + 0.5F - a.y;
            const float v = share * (dx * (c.y - a.y) - dy * (c.x - a.x));  // of b
            const float w = share * ((b.x - a.x) * dy - (b.y - a.y) * dx);  // of c
            if (v < 0.0F || w < 0.0F || v + w > 1.0F) continue;
            crossings.push_back(
                {static_cast<std::uint32_t>(row * columns_ + column), a.z + v * (b.z - a.z) + w * (c.z - a.z)});
        }
}

/// Heights by pixel, those of one pixel in any order: there are few.
void DepthLayers::sort(const std::vector<Crossing>& crossings) {
    begins_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
    for (const Crossing& crossing : crossings) ++begins_[crossing.pixel];
    std::partial_sum(begins_.begin(), begins_.end(), begins_.begin());
    heights_.resize(crossings.size());
    for (const Crossing& crossing : crossings) heights_[--begins_[crossing.pixel]] = crossing.height;
}

DepthLayers::Gaps DepthLayers::gaps(const Vec3& point) const {
    const Place p = place(point);
    Gaps gaps{kFar, kFar};
    if (!(p.x >= 0.0F && p.y >= 0.0F && p.x < static_cast<float>(columns_) && p.y < static_cast<float>(rows_)))
        return gaps;
    const std::size_t pixel =
        static_cast<std::size_t>(p.y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(p.x);
    for (std::uint32_t i = begins_[pixel]; i < begins_[pixel + 1]; ++i) {
        const float gap = heights_[i] - p.z;
        if (gap >= 0.0F)
            gaps.above = std::min(gaps.above, gap);
        else
            gaps.below = std::min(gaps.below, -gap);
    }
    return gaps;
}

}  // namespace meniscus
