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

#include "core/parallel.h"

namespace meniscus {
namespace {

constexpr std::size_t kChunk = 256;  // triangles per task

// Values that are not negative by their leading bits, which have the order of the values: so that few need sorting.
class LeadingBits {
public:
    static constexpr std::size_t kBins = 4096;  // 16 octaves from the least value; all beyond share the last one

    explicit LeadingBits(double least) : first_(leading(least)) {}
    std::size_t bin_of(double value) const { return std::min<std::uint64_t>(leading(value) - first_, kBins - 1); }

private:
    // Sign, exponent and eight bits of the fraction.
    static std::uint64_t leading(double value) { return std::bit_cast<std::uint64_t>(value) >> 44U; }

    std::uint64_t first_;
};

// The values that would stand at rising places if all were sorted.
std::array<double, 3> values_at(std::array<std::size_t, 3> places, std::span<const double> values, double least) {
    const LeadingBits bits(least);
    std::array<std::size_t, LeadingBits::kBins> counts{};
    for (const double v : values) ++counts[bits.bin_of(v)];
    std::array<bool, LeadingBits::kBins> wanted{};
    std::size_t bin = 0;
    std::size_t below = 0;    // values of bins before
    std::size_t skipped = 0;  // of these, not wanted
    for (std::size_t& place : places) {
        for (; below + counts[bin] <= place; ++bin) {
            below += counts[bin];
            if (!wanted[bin]) skipped += counts[bin];
        }
        wanted[bin] = true;
        place -= skipped;
    }
    std::vector<double> some;
    for (const double v : values)
        if (wanted[bits.bin_of(v)]) some.push_back(v);
    std::sort(some.begin(), some.end());
    return {some[places[0]], some[places[1]], some[places[2]]};
}

// Values that so many parts of all are below; none may be negative.
Percentiles percentiles(std::span<const double> values) {
    if (values.empty()) return {};
    const auto [least, largest] = std::minmax_element(values.begin(), values.end());
    const auto place = [&](double part) {
        return static_cast<std::size_t>(std::lround(part * static_cast<double>(values.size() - 1)));
    };
    const auto [low, middle, high] = values_at({place(0.05), place(0.5), place(0.95)}, values, *least);
    return {*least, low, middle, high, *largest};
}

// Between the sides a and b of a triangle, opposite c; of a side without length the angle is 0.
double cosine_of_angle(double a, double b, double c) {
    const double product = a * b;
    return product > 0.0 ? std::clamp((a * a + b * b - c * c) / (2.0 * product), -1.0, 1.0) : 1.0;
}

double degrees(double cosine) { return std::acos(cosine) * (180.0 / std::numbers::pi); }

// Angles grow with 1 - cosine.
Percentiles angles_of(const Percentiles& p) {
    const auto angle = [](double one_less_cosine) { return degrees(1.0 - one_less_cosine); };
    return {angle(p.min), angle(p.p5), angle(p.p50), angle(p.p95), angle(p.max)};
}

// R / 2 r of sides a, b, c: a b c / ((b + c - a) (c + a - b) (a + b - c)).
double aspect_ratio(double a, double b, double c) {
    const double product = (b + c - a) * (c + a - b) * (a + b - c);
    return product > 0.0 ? a * b * c / product : std::numeric_limits<double>::infinity();
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
        for (std::size_t i = 0; i < kCount; ++i) ends_[i] = std::cos(static_cast<double>(i + 1) * width);
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

}  // namespace

MeshQuality measure_quality(const Mesh& mesh) {
    const std::size_t count = mesh.triangles.size();
    const AngleBins bins;
    std::vector<double> smallest(count);  // angles, as 1 - cosine
    std::vector<double> ratios(count);
    std::vector<double> lengths(3 * count);  // of a closed mesh every edge is there twice
    const auto angles = parallel_sum<AngleCounts>(count, kChunk, [&](std::size_t begin, std::size_t end) {
        AngleCounts counts;
        for (std::size_t t = begin; t < end; ++t) {
            const auto& [i, j, k] = mesh.triangles[t];
            const double a = norm(mesh.vertices[k] - mesh.vertices[j]);
            const double b = norm(mesh.vertices[i] - mesh.vertices[k]);
            const double c = norm(mesh.vertices[j] - mesh.vertices[i]);
            const double cosines[] = {cosine_of_angle(b, c, a), cosine_of_angle(c, a, b), cosine_of_angle(a, b, c)};
            for (const double cosine : cosines) ++counts.of[bins.of(cosine)];
            smallest[t] = 1.0 - std::max({cosines[0], cosines[1], cosines[2]});
            ratios[t] = aspect_ratio(a, b, c);
            lengths[3 * t] = a;
            lengths[3 * t + 1] = b;
            lengths[3 * t + 2] = c;
        }
        return counts;
    });
    MeshQuality quality;
    quality.angles = angles.of;
    parallel_both([&] { quality.edges = percentiles(lengths); },
                  [&] {
                      quality.smallest_angles = angles_of(percentiles(smallest));
                      quality.aspect_ratios = percentiles(ratios);
                  });
    return quality;
}

}  // namespace meniscus
