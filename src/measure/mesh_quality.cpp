// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/mesh_quality.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <span>
#include <tuple>
#include <vector>

#include "core/bits.h"
#include "core/elementary.h"
#include "core/parallel.h"
#include "measure/triangle_lanes.h"

namespace meniscus {
namespace {

constexpr std::size_t kShapesPerTask = 128 * kLanes;  // triangles per task
constexpr std::size_t kSampled = 64;                  // of so many triangles one tells where percentiles are looked for

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr std::array<double, 3> kParts{0.05, 0.5, 0.95};
// Brackets of the values that these parts of all are below.
using Brackets = std::array<Bracket, kParts.size()>;
constexpr Bracket kAll{-kInfinity, kInfinity};
constexpr Brackets kNoBrackets{kAll, kAll, kAll};

// What Percentiles tells of many values: of most it is only seen on which side of a bracket they are.
class Distribution {
public:
    // Adds the marked ones of some lanes, which all hold values.
    void add(const Lanes& values, std::uint64_t which, const Brackets& brackets) {
        const TriangleKernels& kernels = triangle_kernels();
        count_ += static_cast<std::size_t>(std::popcount(which));
        least_ = std::min(least_, kernels.find_least(values));
        largest_ = std::max(largest_, kernels.find_largest(values));
        for (std::size_t k = 0; k < kParts.size(); ++k) {
            const auto [below, within] = kernels.bracket(values, brackets[k]);
            below_[k] += static_cast<std::size_t>(std::popcount(below & which));
            for_each_bit(within & which, [&](std::size_t i) { within_[k].push_back(values[i]); });
        }
    }
    Distribution& operator+=(const Distribution& other) {
        count_ += other.count_;
        least_ = std::min(least_, other.least_);
        largest_ = std::max(largest_, other.largest_);
        for (std::size_t k = 0; k < kParts.size(); ++k) {
            below_[k] += other.below_[k];
            within_[k].insert(within_[k].end(), other.within_[k].begin(), other.within_[k].end());
        }
        return *this;
    }

    // Whether the brackets held what they were for.
    bool is_complete() const {
        for (std::size_t k = 0; k < kParts.size(); ++k)
            if (rank(k) < below_[k] || rank(k) - below_[k] >= within_[k].size()) return false;
        return true;
    }
    // Precondition: is_complete.
    Percentiles percentiles() {
        const auto value = [this](std::size_t k) { return *nth_within(k, 0, rank(k) - below_[k]); };
        return {least_, value(0), value(1), value(2), largest_};
    }
    // For many more, of which these are a sample: six standard deviations of a rank among values that do not depend on
    // each other, which the sides of a triangle do. Precondition: there were no brackets.
    Brackets brackets() {
        constexpr double kDeviations = 6.0;
        Brackets brackets = kNoBrackets;
        for (std::size_t k = 0; k < kParts.size(); ++k) {
            const double variance = kParts[k] * (1.0 - kParts[k]) * static_cast<double>(count_);
            const std::size_t off = 1 + static_cast<std::size_t>(kDeviations * std::sqrt(variance));
            const std::size_t low = rank(k) - std::min(rank(k), off);
            const std::size_t high = rank(k) + off;
            if (low > 0) brackets[k].low = *nth_within(k, 0, low);
            if (high < count_) brackets[k].high = *nth_within(k, low, high);
        }
        return brackets;
    }

private:
    // The place, if all were sorted, of the value that a part of them is below.
    std::size_t rank(std::size_t k) const {
        return static_cast<std::size_t>(std::lround(kParts[k] * static_cast<double>(count_ - 1)));
    }
    // The values before `from` are known to be no larger than the others.
    std::vector<double>::const_iterator nth_within(std::size_t k, std::size_t from, std::size_t place) {
        const auto begin = within_[k].begin();
        const auto at = begin + static_cast<std::ptrdiff_t>(place);
        std::nth_element(begin + static_cast<std::ptrdiff_t>(from), at, within_[k].end());
        return at;
    }

    std::size_t count_ = 0;
    double least_ = kInfinity;
    double largest_ = -kInfinity;
    std::array<std::size_t, kParts.size()> below_{};  // per bracket
    std::array<std::vector<double>, kParts.size()> within_;
};

double degrees(double cosine) { return elementary::acos(cosine) * (180.0 / std::numbers::pi); }

// Angles grow with 1 - cosine.
Percentiles angles_of(const Percentiles& p) {
    const auto angle = [](double one_less_cosine) { return degrees(1.0 - one_less_cosine); };
    return {angle(p.min), angle(p.p5), angle(p.p50), angle(p.p95), angle(p.max)};
}

// Corners by their angles, see MeshQuality.
struct AngleCounts {
    decltype(MeshQuality::angles) of{};
    AngleCounts& operator+=(const AngleCounts& other) {
        for (std::size_t i = 0; i < of.size(); ++i) of[i] += other.of[i];
        return *this;
    }
};

// Finds which of these counts an angle belongs to without the angle itself.
class AngleBins {
public:
    AngleBins() {
        const double width = std::numbers::pi / static_cast<double>(kCount);
        for (std::size_t i = 0; i < kCount; ++i) ends_[i] = elementary::cos(static_cast<double>(i + 1) * width);
        ends_.back() = -2.0;  // the last one ends with 180 degrees, which belong to it
        for (std::size_t cell = 0; cell < kCells; ++cell) {
            const double highest = (static_cast<double>(cell) + 1.0) / kPerUnit - 1.0;
            while (highest <= ends_[first_[cell]]) ++first_[cell];
        }
    }
    // An angle that a bin ends with belongs to the next one.
    std::size_t of(double cosine) const {
        const std::size_t bin = first_[static_cast<std::size_t>((cosine + 1.0) * kPerUnit)];
        return bin + (cosine <= ends_[bin] ? 1 : 0);
    }

private:
    static constexpr std::size_t kCount = std::tuple_size_v<decltype(MeshQuality::angles)>;
    static constexpr double kPerUnit = 128.0;  // so that no more than one bin ends within a cell of cosines
    static constexpr std::size_t kCells = 257;

    std::array<double, kCount> ends_{};
    std::array<std::uint8_t, kCells> first_{};  // per cell: the bin of its highest cosine
};

// What is said about triangles.
struct Shapes {
    Distribution edges;     // of a closed mesh every one is there twice
    Distribution smallest;  // angles, as 1 - cosine
    Distribution ratios;
    AngleCounts angles;

    struct Where {
        Brackets edges = kNoBrackets;
        Brackets smallest = kNoBrackets;
        Brackets ratios = kNoBrackets;
    };

    Shapes& operator+=(const Shapes& other) {
        edges += other.edges;
        smallest += other.smallest;
        ratios += other.ratios;
        angles += other.angles;
        return *this;
    }
    bool is_complete() const { return edges.is_complete() && smallest.is_complete() && ratios.is_complete(); }
    Where brackets() { return {edges.brackets(), smallest.brackets(), ratios.brackets()}; }
};

Shapes shapes_of(const Mesh& mesh, std::span<const Triangle> triangles, const Shapes::Where& brackets) {
    const AngleBins bins;
    const TriangleKernels& kernels = triangle_kernels();
    return parallel_sum<Shapes>(triangles.size(), kShapesPerTask, [&](std::size_t begin, std::size_t end) {
        Shapes seen;
        TriangleLanes lanes;
        TriangleShapes shapes;
        for (std::size_t first = begin; first < end; first += kLanes) {
            std::array<Triangle, kLanes> some;  // the last one again and again where there are fewer
            const std::size_t count = std::min(kLanes, end - first);
            std::copy_n(&triangles[first], count, some.begin());
            std::fill(some.begin() + static_cast<std::ptrdiff_t>(count), some.end(), triangles[first + count - 1]);
            kernels.gather(mesh.vertices.data(), nullptr, some, {}, lanes);
            kernels.measure_shapes(lanes, shapes);
            const std::uint64_t which = first_bits(count);
            for (const Lanes& sides : shapes.sides) seen.edges.add(sides, which, brackets.edges);
            seen.smallest.add(shapes.one_less_cosine, which, brackets.smallest);
            seen.ratios.add(shapes.aspect_ratio, which, brackets.ratios);
            for (const Lanes& cosines : shapes.cosines)
                for (std::size_t i = 0; i < count; ++i) ++seen.angles.of[bins.of(cosines[i])];
        }
        return seen;
    });
}

// Where the percentiles of a large mesh are: between those of a sample.
Shapes::Where brackets_of(const Mesh& mesh) {
    constexpr std::size_t kFewest = 1000;  // triangles of a sample
    if (mesh.triangles.size() < kFewest * kSampled) return {};
    std::vector<Triangle> sample;
    sample.reserve(mesh.triangles.size() / kSampled + 1);
    for (std::size_t t = 0; t < mesh.triangles.size(); t += kSampled) sample.push_back(mesh.triangles[t]);
    return shapes_of(mesh, sample, {}).brackets();
}

}  // namespace

MeshQuality measure_quality(const Mesh& mesh) {
    if (mesh.triangles.empty()) return {};
    Shapes shapes = shapes_of(mesh, mesh.triangles, brackets_of(mesh));
    if (!shapes.is_complete()) shapes = shapes_of(mesh, mesh.triangles, {});
    return {shapes.angles.of, angles_of(shapes.smallest.percentiles()), shapes.edges.percentiles(),
            shapes.ratios.percentiles()};
}

}  // namespace meniscus
