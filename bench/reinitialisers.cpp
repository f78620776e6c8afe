// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How far each reinitialiser moves the zero set: starts from the converged flow of the spheres of an xyzr file, at
// 0.25 Å, and calls it once and ten times.
//
// usage: reinitialisers FILE.xyzr
#include <fmt/core.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>
#include <vector>

#include "band/surface_blocks.h"
#include "flow/closest_points.h"
#include "flow/evolution.h"
#include "flow/gaussian_density.h"
#include "flow/paper/reinitialise.h"
#include "meniscus/level_set.h"
#include "mesh/extract.h"

using namespace meniscus;

namespace {

constexpr double kSpacing = 0.25;
constexpr double kWidth = 5.0 * kSpacing;

Atoms read_spheres(const char* path) {
    std::ifstream file(path);
    Atoms atoms;
    for (std::string line; std::getline(file, line);) {
        std::istringstream fields(line);
        Vec3 p;
        double radius = 0.0;
        if (!(fields >> p.x >> p.y >> p.z >> radius)) continue;
        atoms.centres.push_back(p);
        atoms.radii.push_back(radius);
    }
    return atoms;
}

struct Band {
    AccessibleSurface surface;
    std::shared_ptr<const BlockGrid> grid;
    DistanceBand distance;

    explicit Band(const Atoms& atoms) : surface(atoms, 1.4) {
        const Lattice lattice{kSpacing, kSpacing * Vec3{0.38, 0.24, 0.15}};
        grid = std::make_shared<const BlockGrid>(kSpacing, lattice.origin,
                                                 blocks_near_surface(surface, lattice, kWidth, 1U << 20U));
        distance = sample_distance(surface, *grid, kWidth);
    }
    LevelSet spline_through(const NodeField& values) const {
        return {grid, interpolating_coefficients(*grid, values, 4.0)};
    }
};

using Call = std::function<void(const Band&, NodeField&)>;

void by_closest_points(const Band& band, NodeField& values) {
    values =
        distance_by_closest_points(*band.grid, values, interpolating_coefficients(*band.grid, values, 4.0), kWidth);
}

Call upwind(const UpwindScheme& scheme) {
    return [scheme](const Band& band, NodeField& values) { reinitialise_upwind(*band.grid, kWidth, scheme, values); };
}

struct Drift {
    double mean = 0.0;
    double max = 0.0;
};

// Distance of points of the first zero set from the second one.
Drift drift(const std::vector<Vec3>& points, const LevelSet& after) {
    Drift found;
    for (const Vec3& p : points) {
        const double moved = norm(after.closest_point(p) - p);
        const double distance = std::isnan(moved) ? kWidth : moved;
        found.mean += distance / static_cast<double>(points.size());
        found.max = std::max(found.max, distance);
    }
    return found;
}

double slope_error(const LevelSet& level_set, const std::vector<Vec3>& points) {
    double sum = 0.0;
    for (const Vec3& p : points) sum += std::abs(norm(level_set.sample(p).gradient) - 1.0);
    return sum / static_cast<double>(points.size());
}

void report(const char* name, const Band& band, const NodeField& start, const Call& call) {
    const Mesh before = extract_zero_set(*band.grid, start);
    const LevelSet spline = band.spline_through(start);
    std::vector<Vec3> points;
    for (const Vec3& v : before.vertices) points.push_back(spline.project(v));
    NodeField values = start;
    std::string row = fmt::format("{:<16}", name);
    for (int done = 0; const int calls : {1, 10}) {
        for (; done < calls; ++done) call(band, values);
        const LevelSet after = band.spline_through(values);
        const Drift moved = drift(points, after);
        const Mesh mesh = extract_zero_set(*band.grid, values);
        row += fmt::format("  {:7.4f} {:7.4f} {:+7.2f} % {:7.4f} {:6}", moved.mean, moved.max,
                           100.0 * (measure_mesh(mesh).area / measure_mesh(before).area - 1.0),
                           slope_error(after, points), measure_mesh(mesh).components.size());
    }
    fmt::print("{}\n", row);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) return 2;
    const Band band(read_spheres(argv[1]));
    const NodeField gaussian = GaussianDensity(band.surface, -0.5).sample(*band.grid, kWidth);
    const NodeField start = evolve(*band.grid, {band.distance, gaussian}, {}, {}).state.values;
    fmt::print("{:<16}  {:^42}  {:^42}\n", "", "after one call", "after ten calls");
    fmt::print("{:<16}", "reinitialiser");
    for (int i = 0; i < 2; ++i)
        fmt::print("  {:>7} {:>7} {:>9} {:>7} {:>6}", "mean/Å", "max/Å", "area", "slope-1", "pieces");
    fmt::print("\n");
    report("closest-point", band, start, by_closest_points);
    report("paper", band, start, upwind({}));
    report("paper-literal", band, start, upwind({.repaired = false}));
    report("godunov", band, start, upwind({.stride = 1}));
}
