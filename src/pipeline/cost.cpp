// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/cost.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "core/elementary.h"
#include "core/golden_angle.h"
#include "core/number_text.h"
#include "core/parallel.h"
#include "grid/block_grid.h"
#include "meniscus/errors.h"
#include "meniscus/remesh.h"
#include "meniscus/surface.h"
#include "pipeline/band_size.h"
#include "pipeline/flow_stage.h"
#include "pipeline/memory_limit.h"
#include "space/point_cells.h"

namespace meniscus {
namespace {

// Enough to know the area within some 15 %; small structures can afford more.
constexpr std::size_t kLeastSamples = 100;
constexpr std::size_t kMostSamples = 160;
constexpr std::size_t kPairs = 500'000;
constexpr std::size_t kSamplesPerTask = 4;

constexpr std::size_t kDirections = 16;

// Evenly spread unit vectors: the golden spiral.
std::array<Vec3, kDirections> spiral() {
    std::array<Vec3, kDirections> directions;
    for (std::size_t k = 0; k < kDirections; ++k) {
        const double z = 1.0 - (2.0 * static_cast<double>(k) + 1.0) / static_cast<double>(kDirections);
        const double angle = kGoldenAngle * static_cast<double>(k);
        const double across = std::sqrt(1.0 - z * z);
        directions[k] = {across * elementary::cos(angle), across * elementary::sin(angle), z};
    }
    return directions;
}

// What the other atoms leave of enlarged spheres.
class Exposure {
public:
    Exposure(const Atoms& atoms, const PointCells& cells, double largest, double probe)
        : atoms_(atoms), cells_(cells), largest_(largest), probe_(probe) {}

    /// The part of an atom's enlarged sphere that is accessible, 0 to 1.
    double of(std::size_t atom) {
        static const std::array<Vec3, kDirections> directions = spiral();
        if (!find_neighbours(atom)) return 0.0;
        const double rho = atoms_.radii[atom] + probe_;
        std::size_t free = 0;
        for (const Vec3& direction : directions) free += is_covered(atoms_.centres[atom] + rho * direction) ? 0 : 1;
        return static_cast<double>(free) / static_cast<double>(kDirections);
    }

private:
    struct Neighbour {
        Vec3 centre;
        double squared_rho;
    };

    static double squared(double v) { return v * v; }

    // Without a branch: nobody could predict it. False for an atom that another one holds: of those with one centre the
    // largest counts, of equal ones the first.
    bool find_neighbours(std::size_t atom) {
        const Vec3 centre = atoms_.centres[atom];
        const double rho = atoms_.radii[atom] + 2.0 * probe_;
        const double farthest = rho + largest_;
        const Vec3 aside{farthest, farthest, 0.0};
        std::size_t count = 0;
        cells_.for_each_within(cells_.cell_of(centre - aside), cells_.cell_of(centre + aside), [&](std::uint32_t j) {
            const double reach = rho + atoms_.radii[j];
            if (count == near_.size()) near_.resize(2 * count + 64);
            near_[count] = j;
            count += squared_norm(atoms_.centres[j] - centre) < reach * reach ? 1 : 0;
        });
        neighbours_.clear();
        for (const std::uint32_t j : std::span(near_).first(count)) {
            if (j == atom) continue;
            const bool larger =
                atoms_.radii[j] > atoms_.radii[atom] || (atoms_.radii[j] == atoms_.radii[atom] && j < atom);
            if (larger && atoms_.centres[j] == centre) return false;
            neighbours_.push_back({atoms_.centres[j], squared(atoms_.radii[j] + probe_)});
        }
        return true;
    }

    bool is_covered(const Vec3& point) const {
        return std::any_of(neighbours_.begin(), neighbours_.end(),
                           [&point](const Neighbour& n) { return squared_norm(n.centre - point) < n.squared_rho; });
    }

    const Atoms& atoms_;
    const PointCells& cells_;
    double largest_;  // radius
    double probe_;
    std::vector<std::uint32_t> near_;
    std::vector<Neighbour> neighbours_;
};

// Å. Larger ones leave the area of molecules nearly as it is, while they touch ever fewer atoms, of which samples tell
// nothing.
constexpr double kLargestProbe = 5.0;

// The sum of the contact patches is known from the exposed parts f. What bridges them grows as the atoms lie closer:
// on single spheres, peptides, proteins and assemblies alike the whole is near f^-b times as large, with b rising from
// 0 for the van der Waals surface to 0.38 for water.
double bridged_area(double contact_area, double exposed, double probe) {
    const double b = std::min(probe, 0.3 + 0.057 * probe);
    return contact_area * elementary::exp(-b * elementary::log(exposed));
}

// Of the ball whose atoms were as far from its centre in the mean square, and whose radius is larger by theirs.
double area_of_ball(const Atoms& atoms, double largest) {
    const auto count = static_cast<double>(atoms.size());
    Vec3 centre;
    for (const Vec3& c : atoms.centres) centre = centre + (1.0 / count) * c;
    double mean_square = 0.0;
    for (const Vec3& c : atoms.centres) mean_square += squared_norm(c - centre) / count;
    const double radius = std::sqrt(5.0 / 3.0 * mean_square) + largest;
    return 4.0 * std::numbers::pi * radius * radius;
}

double surface_area(const Atoms& atoms, double probe) {
    if (atoms.empty()) return 0.0;
    const std::size_t samples = std::clamp(kPairs / atoms.size(), kLeastSamples, kMostSamples);
    const std::size_t step = std::max<std::size_t>(1, atoms.size() / samples);
    struct Sums {
        double contact = 0.0;
        double exposed = 0.0;
        Sums& operator+=(const Sums& b) {
            contact += b.contact;
            exposed += b.exposed;
            return *this;
        }
    };
    const std::size_t looked_at = (atoms.size() + step - 1) / step;
    const PointCells cells(atoms.centres, 1.0);
    const double largest = *std::max_element(atoms.radii.begin(), atoms.radii.end());
    const Sums sums = parallel_sum<Sums>(looked_at, kSamplesPerTask, [&](std::size_t begin, std::size_t end) {
        Exposure exposure(atoms, cells, largest, probe);
        Sums of_these;
        for (std::size_t k = begin; k < end; ++k) {
            const double part = exposure.of(k * step);
            const double r = atoms.radii[k * step];
            of_these += {4.0 * std::numbers::pi * r * r * part, part};
        }
        return of_these;
    });
    const auto count = static_cast<double>(looked_at);
    const double exposed = sums.exposed / count;
    const double area =
        exposed > 0.0 ? bridged_area(sums.contact * static_cast<double>(atoms.size()) / count, exposed, probe) : 0.0;
    constexpr double kTelling = 0.01;  // a smaller part of the spheres may have been missed
    return exposed < kTelling ? std::max(area, area_of_ball(atoms, largest)) : area;
}

// Blocks of the grid within a margin of the surface: those with their centre within half a diagonal more. Layers that
// are thick beside the atoms overlap in clefts and inside.
double block_count(double area, double spacing, double margin) {
    constexpr double kOverlap = 12.0;  // Å
    const double edge = kBlockEdge * spacing;
    const double reach = margin + 0.5 * std::numbers::sqrt3 * edge;
    const double outside = 8.0 / 3.0 * std::numbers::pi * reach * reach * reach;
    return (2.0 * area * reach / (1.0 + reach / kOverlap) + outside) / (edge * edge * edge);
}

// What the parts of a computation take.
struct Rates {
    double per_atom;
    double per_block;
    double per_vertex;
};
struct Prices {
    Rates bytes;
    Rates nanoseconds;
};
constexpr double kBytesOfProgram = 12.0 * kMegabyte;

// As measured (docs/design/performance.md). A Gaussian start that is only looked at costs time as well.
constexpr Prices prices_of(const SurfaceOptions& options) {
    if (options.method == Method::Direct) return {{1400.0, 1000.0, 90.0}, {10500.0, 9000.0, 440.0}};
    return {{1800.0, 3800.0, 95.0}, {10500.0, options.initial_area ? 57000.0 : 36000.0, 460.0}};
}

// Even triangles: both meshes go through the remesher, where one or the other decides what memory it takes.
constexpr double kBytesPerReplaced = 300.0;
constexpr double kBytesPerEven = 1000.0;
constexpr double kNanosecondsPerReplaced = 1850.0;
constexpr double kNanosecondsPerEven = 11000.0;

void add_remeshing(Cost& cost, double edge) {
    const double even = kVerticesPerSquareEdge * cost.area / (edge * edge);
    cost.memory_mb += std::max(kBytesPerReplaced * cost.vertices, kBytesPerEven * even) / kMegabyte;
    cost.seconds += 1e-9 * (kNanosecondsPerReplaced * cost.vertices + kNanosecondsPerEven * even);
    cost.vertices = even;
}

// What is looked at for reports, per vertex.
constexpr double kBytesOfQuality = 20.0;
constexpr double kBytesOfStart = 60.0;  // with the mesh of a Gaussian start beside it
constexpr double kNanosecondsOfQuality = 80.0;
constexpr double kNanosecondsOfDistance = 7000.0;

void add_quality(Cost& cost, const SurfaceOptions& options) {
    if (options.quality) {
        cost.memory_mb += kBytesOfQuality * cost.vertices / kMegabyte;
        cost.seconds += 1e-9 * kNanosecondsOfQuality * cost.vertices;
    }
    if (options.method == Method::Flow && options.initial_area)
        cost.memory_mb += kBytesOfStart * cost.vertices / kMegabyte;
    if (options.two_sided_distance) cost.seconds += 1e-9 * kNanosecondsOfDistance * cost.vertices;
}

// Exact measures come before the grid, which takes most of their memory over, but not all; on a coarse grid the peak is
// theirs.
constexpr double kBytesOfMeasuring = 3000.0;
constexpr double kBytesKeptOfMeasuring = 800.0;
constexpr double kNanosecondsOfMeasuring = 8000.0;

void add_exact_measures(Cost& cost, double atoms) {
    const double while_measuring = (kBytesOfProgram + kBytesOfMeasuring * atoms) / kMegabyte;
    cost.memory_mb = std::max(cost.memory_mb + kBytesKeptOfMeasuring * atoms / kMegabyte, while_measuring);
    cost.seconds += 1e-9 * kNanosecondsOfMeasuring * atoms;
}

Cost cost_of(double atoms, double area, const SurfaceOptions& options) {
    const double h = options.spacing;
    const double blocks = block_count(area, h, band_margin(options));
    Cost cost;
    cost.area = area;
    cost.vertices = 1.5 * area / (h * h);  // a plane cuts 1.5 edges per square of the grid, on average
    const auto sum = [&](const Rates& rates) {
        return rates.per_atom * atoms + rates.per_block * blocks + rates.per_vertex * cost.vertices;
    };
    cost.memory_mb = (kBytesOfProgram + sum(prices_of(options).bytes)) / kMegabyte;
    cost.seconds = 1e-9 * sum(prices_of(options).nanoseconds);
    if (options.remesh.is_on()) add_remeshing(cost, options.remesh.edge);
    add_quality(cost, options);
    if (options.exact) add_exact_measures(cost, atoms);
    return cost;
}

std::string amount(double megabytes) {
    return megabytes < 1024.0 ? with_decimals(megabytes, 0) + " MB" : with_decimals(megabytes / 1024.0, 1) + " GB";
}

// Changes of the options with which the computation would fit, in words that every client's users know.
class Advice {
public:
    Advice(double atoms, double area, const SurfaceOptions& options, std::size_t memory_limit_mb)
        : atoms_(atoms), area_(area), options_(options), memory_limit_mb_(memory_limit_mb) {}

    std::string text() const {
        const bool even = options_.remesh.is_on();
        std::string text = least("a spacing", options_.spacing, even ? kCoarsestForRemeshing : kWidest,
                                 [](SurfaceOptions& options, double value) { options.spacing = value; });
        if (even)
            text += least("edges", options_.remesh.edge, kLongest,
                          [](SurfaceOptions& options, double value) { options.remesh.edge = value; });
        SurfaceOptions direct = options_;
        direct.method = Method::Direct;
        if (would_fit(direct)) text += joined("the method direct (", amount(cost(direct).memory_mb), "), ");
        SurfaceOptions inexact = options_;
        inexact.exact = false;
        if (would_fit(inexact)) text += joined("no exact measures (", amount(cost(inexact).memory_mb), "), ");
        if (memory_limit_mb_ > 0) text += "a larger memory limit, ";
        return text + "fewer or smaller atoms";
    }

private:
    static constexpr double kWidest = 5.0;   // Å: wider grids show no surface
    static constexpr double kLongest = 5.0;  // Å: nor do longer edges

    Cost cost(const SurfaceOptions& options) const { return cost_of(atoms_, area_, options); }
    bool would_fit(const SurfaceOptions& options) const { return fits_into_memory(cost(options), memory_limit_mb_); }

    // The least value that fits, in steps of 0.01 Å; nothing where none does.
    template <class Set>
    std::string least(const char* name, double value, double most, const Set& set) const {
        SurfaceOptions other = options_;
        for (value = std::ceil(100.0 * value) / 100.0; value <= most; value += 0.01) {
            set(other, value);
            if (would_fit(other)) return joined(name, " of ", with_decimals(value, 2), " Å or more, ");
        }
        return "";
    }

    double atoms_;
    double area_;
    const SurfaceOptions& options_;
    std::size_t memory_limit_mb_;
};

}  // namespace

Cost estimate_cost(const Atoms& atoms, const SurfaceOptions& options) {
    const ExactSurface exact(atoms, {options.surface, options.probe});
    const double area = surface_area(exact.balls(), std::min(exact.probe_of_balls(), kLargestProbe));
    return cost_of(static_cast<double>(atoms.size()), area, options);
}

bool fits_into_memory(const Cost& cost, std::size_t memory_limit_mb) {
    return !std::isfinite(cost.memory_mb) || cost.memory_mb <= limit_mb(memory_limit_mb);
}

void refuse_what_would_not_fit(const Atoms& atoms, const SurfaceOptions& options, const Cost& cost,
                               std::size_t memory_limit_mb) {
    if (fits_into_memory(cost, memory_limit_mb)) return;
    throw LimitError(joined("the surface needs about ", amount(cost.memory_mb), " of memory (",
                            in_short(1e-6 * cost.vertices, 3), " million vertices), but only ",
                            amount(limit_mb(memory_limit_mb)), memory_limit_mb > 0 ? " are allowed" : " are free",
                            "; choose ",
                            Advice(static_cast<double>(atoms.size()), cost.area, options, memory_limit_mb).text()));
}

double band_margin(const SurfaceOptions& options) {
    if (options.method == Method::Direct) return kCutCell * options.spacing;
    return flow_margin(options.method == Method::Flow ? options.flow : FlowOptions{}, options.spacing);
}

std::size_t block_limit(const SurfaceOptions& options, std::size_t memory_limit_mb) {
    return static_cast<std::size_t>(limit_mb(memory_limit_mb) * kMegabyte / prices_of(options).bytes.per_block);
}

}  // namespace meniscus
