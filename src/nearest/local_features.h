// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The few features that can be nearest to the points of a small box: what makes many queries cheap.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/bits.h"
#include "geometry/accessible_surface_data.h"
#include "nearest/nearest_feature.h"

namespace meniscus {

/// A list of features, each a few numbers and its index: one array per number, which vectors can read. Refilled again
/// and again without setting its memory.
template <std::size_t kColumns>
class FeatureList {
public:
    using Row = std::array<double, kColumns>;
    static constexpr std::size_t kStep = 64 / sizeof(double);  // arrays are readable up to the next multiple

    std::size_t size() const { return size_; }
    std::size_t padded_size() const { return (size_ + kStep - 1) / kStep * kStep; }
    bool empty() const { return size_ == 0; }
    std::uint32_t index(std::size_t item) const { return indices_[item]; }
    const double* column(std::size_t number) const { return columns_[number].data(); }

    void clear() { size_ = 0; }
    /// Makes room for so many items, each of which is to be set.
    void resize(std::size_t count) {
        reserve(count);
        size_ = count;
    }
    void set(std::size_t item, const Row& row, std::uint32_t index) {
        for (std::size_t c = 0; c < kColumns; ++c) columns_[c][item] = row[c];
        indices_[item] = index;
    }
    void add(const Row& row, std::uint32_t index) { add_if(true, row, index); }
    /// Without a branch.
    void add_if(bool wanted, const Row& row, std::uint32_t index) {
        reserve(size_ + 1);
        set(size_, row, index);
        size_ += static_cast<std::size_t>(wanted);
    }
    /// Becomes the marked items of a list, in order. marks: a bit for each.
    void select(const FeatureList& from, const std::uint64_t* marks) {
        reserve(from.size());
        size_ = 0;
        for_each_item(marks, from.size(), [&](std::size_t i) {
            for (std::size_t c = 0; c < kColumns; ++c) columns_[c][size_] = from.columns_[c][i];
            indices_[size_++] = from.indices_[i];
        });
    }

private:
    void reserve(std::size_t count) {
        if (count <= indices_.size()) return;
        const std::size_t room = (2 * count + kStep - 1) / kStep * kStep;
        for (std::vector<double>& column : columns_) column.resize(room);
        indices_.resize(room);
    }

    std::array<std::vector<double>, kColumns> columns_;
    std::vector<std::uint32_t> indices_;
    std::size_t size_ = 0;
};

using SphereList = FeatureList<4>;  ///< x, y, z, radius: balls, and vertices with the probe's radius
using BoxList = FeatureList<6>;     ///< boxes: low x, y, z, high x, y, z

inline BoxList::Row row_of(const Box& box) {
    return {box.low.x, box.low.y, box.low.z, box.high.x, box.high.y, box.high.z};
}

template <std::size_t kColumns>
Vec3 position_in(const FeatureList<kColumns>& list, std::size_t item) {
    return {list.column(0)[item], list.column(1)[item], list.column(2)[item]};
}

/// Lists gathered for one box after the other, reusing their memory.
///
/// They answer for points of the box with |signed distance| < margin. The lists are complete in this sense:
/// `balls` holds every ball that reaches into the box (or comes within margin of its van der Waals sphere),
/// `arcs` every arc whose cell meets the box, `vertices` every vertex within probe + margin of the box.
class LocalFeatures {
public:
    LocalFeatures(const AccessibleSurface& surface, double margin) : surface_(&surface), margin_(margin) {}

    void gather(const Box& box);
    /// With another margin from now on.
    void gather(const Box& box, double margin) {
        margin_ = margin;
        gather(box);
    }

    /// Takes the same lists from those of a box around this one, which costs less; their margin must not be smaller.
    void gather_from(const LocalFeatures& wider, const Box& box);

    const AccessibleSurface& surface() const { return *surface_; }
    double margin() const { return margin_; }
    /// How far beyond a ball points are still within the margin, Å: 0 unless the margin exceeds the probe radius.
    double beyond_balls() const;

    /// Whether they answer for all points of a box.
    bool holds(const Box& box) const { return box_.contains(box); }

    const SphereList& balls() const { return balls_; }
    const BoxList& arcs() const { return arcs_; }
    const SphereList& vertices() const { return vertices_; }

    /// Same as AccessibleSurface::nearest for any point; quick for those the lists answer for.
    NearestFeature nearest(const Vec3& point) const;

private:
    const AccessibleSurface* surface_;
    double margin_;
    Box box_;  // that was gathered for
    SphereList balls_;
    BoxList arcs_;
    SphereList vertices_;
    std::vector<std::uint64_t> marks_;
};

/// throws   std::invalid_argument that names the first point which is not finite
void check_finite(std::span<const Vec3> points);

/// A step of each point to the surface.
///
/// cost     that of nearest_features
std::vector<SurfaceStep> steps_to_surface(const AccessibleSurface& surface, std::span<const Vec3> points);

/// The nearest features of points of one box, through the lists gathered for it.
///
/// cost     0.1 µs per point near the surface
void nearest_features(const LocalFeatures& gathered, std::span<const Vec3> points, std::span<NearestFeature> result);

}  // namespace meniscus
