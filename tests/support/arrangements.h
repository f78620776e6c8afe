// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Arrangements of spheres made in code, regular ones and random ones, and points around them.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <random>
#include <string>
#include <vector>

#include "meniscus/atoms.h"

namespace meniscus::testing {

inline Atoms equal_spheres(std::vector<Vec3> centres, double radius) {
    const std::size_t n = centres.size();
    return {std::move(centres), std::vector<double>(n, radius)};
}

/// Two spheres on the x axis.
inline Atoms two_spheres(double distance, double radius0 = 1.7, double radius1 = 1.7) {
    return {{{0, 0, 0}, {distance, 0, 0}}, {radius0, radius1}};
}

/// Closed forms of the SES of two spheres, from the reference notes: Å, Å² and Å³.
struct TwoSpheresReference {
    double r1, r2, d, probe, area, volume;
};
inline constexpr TwoSpheresReference kTwoSpheresReferences[] = {{1.7, 1.52, 1.23, 1.4, 45.237411, 27.522504},
                                                                {1.7, 1.7, 5.9, 1.4, 72.794368, 41.220155},
                                                                {2.0, 1.4, 4.5, 1.4, 77.520970, 47.694192},
                                                                {1.7, 1.7, 5.45, 1.5, 75.387196, 42.038952}};

/// An equilateral triangle in the plane z = 0.
inline Atoms triangle(double side, double radius) {
    return equal_spheres({{0, 0, 0}, {side, 0, 0}, {0.5 * side, std::sqrt(0.75) * side, 0}}, radius);
}

/// A regular tetrahedron around the origin.
inline Atoms tetrahedral_spheres(double edge, double radius) {
    const double a = edge / std::sqrt(8.0);
    return equal_spheres({{a, a, a}, {a, -a, -a}, {-a, a, -a}, {-a, -a, a}}, radius);
}

/// Six spheres on the axes at distance `from_centre` of the origin.
inline Atoms octahedron(double from_centre, double radius) {
    const double d = from_centre;
    return equal_spheres({{d, 0, 0}, {-d, 0, 0}, {0, d, 0}, {0, -d, 0}, {0, 0, d}, {0, 0, -d}}, radius);
}

/// Three spheres in a triangle: with a probe of 1.4 Å necks of 0.8 Å join them, and a web of 0.2 Å in the middle.
inline Atoms spheres_with_narrow_necks() { return equal_spheres({{0, -1.9, 0}, {0, 1.9, 0}, {3.1, 0, 0}}, 1.2); }

/// Three spheres around which probes of 1.4 Å meet: patches of every kind, ridges outside and inside.
inline Atoms ridged_spheres() { return {{{0, 0, 0}, {5.0, 0.3, 0.1}, {2.4, 4.2, 0.2}}, {1.7, 1.6, 1.8}}; }

inline Atoms line(int count, double step, double radius) {
    std::vector<Vec3> centres;
    centres.reserve(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) centres.push_back({step * i, 0, 0});
    return equal_spheres(std::move(centres), radius);
}

/// In the plane z = 0, around the origin.
inline Atoms ring(int count, double ring_radius, double radius) {
    std::vector<Vec3> centres;
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / count;
        centres.push_back({ring_radius * std::cos(angle), ring_radius * std::sin(angle), 0});
    }
    return equal_spheres(std::move(centres), radius);
}

/// n³ spheres.
inline Atoms cubic_lattice(int n, double step, double radius) {
    std::vector<Vec3> centres;
    for (int z = 0; z < n; ++z)
        for (int y = 0; y < n; ++y)
            for (int x = 0; x < n; ++x) centres.push_back(step * Vec3{1.0 * x, 1.0 * y, 1.0 * z});
    return equal_spheres(std::move(centres), radius);
}

/// Spheres spread evenly over a sphere around the origin: a wall around a void.
inline Atoms hollow_shell(int count, double shell_radius, double radius) {
    std::vector<Vec3> centres;
    for (int i = 0; i < count; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / count;
        const double angle = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
        const double r = std::sqrt(1.0 - z * z);
        centres.push_back(shell_radius * Vec3{r * std::cos(angle), r * std::sin(angle), z});
    }
    return equal_spheres(std::move(centres), radius);
}

/// Centres in a cube, radii between 0.8 and 2.2 Å.
inline Atoms random_cluster(std::uint64_t seed, int count, double edge) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> within(0.0, edge);
    std::uniform_real_distribution<double> size(0.8, 2.2);
    Atoms atoms;
    for (int i = 0; i < count; ++i) {
        atoms.centres.push_back({within(random), within(random), within(random)});
        atoms.radii.push_back(size(random));
    }
    return atoms;
}

/// The same atoms in another order; position i of the result holds atom order[i].
struct Shuffled {
    Atoms atoms;
    std::vector<std::size_t> order;
};
inline Shuffled shuffled(const Atoms& atoms, std::uint64_t seed) {
    Shuffled result;
    result.order.resize(atoms.size());
    std::iota(result.order.begin(), result.order.end(), std::size_t{0});
    std::shuffle(result.order.begin(), result.order.end(), std::mt19937_64(seed));
    for (const std::size_t i : result.order) {
        result.atoms.centres.push_back(atoms.centres[i]);
        result.atoms.radii.push_back(atoms.radii[i]);
    }
    return result;
}

/// Uniform in the bounding box of the centres, enlarged by `margin` on every side.
inline std::vector<Vec3> random_points_around(const Atoms& atoms, std::size_t count, double margin,
                                              std::uint64_t seed = 7) {
    Vec3 low = atoms.centres[0];
    Vec3 high = low;
    for (const Vec3& c : atoms.centres) {
        low = {std::min(low.x, c.x), std::min(low.y, c.y), std::min(low.z, c.z)};
        high = {std::max(high.x, c.x), std::max(high.y, c.y), std::max(high.z, c.z)};
    }
    std::mt19937_64 random(seed);
    const auto within = [&](double a, double b) {
        return std::uniform_real_distribution<double>(a - margin, b + margin)(random);
    };
    std::vector<Vec3> points(count);
    for (Vec3& p : points) p = {within(low.x, high.x), within(low.y, high.y), within(low.z, high.z)};
    return points;
}

struct Arrangement {
    std::string name;
    Atoms atoms;
    double probe = 1.4;
};

/// What has broken such programs before: ties, tangencies, duplicates, spindles, voids, no probe.
inline std::vector<Arrangement> awkward_arrangements() {
    return {
        {"one", {{{0.1, -0.2, 0.3}}, {1.7}}},
        {"duplicates", {{{0, 0, 0}, {0, 0, 0}, {2, 0, 0}}, {1.7, 1.7, 1.5}}},
        {"concentric", {{{0, 0, 0}, {0, 0, 0}, {2.5, 0, 0}}, {1.7, 1.2, 1.7}}},
        {"one inside another", {{{0, 0, 0}, {0.3, 0, 0}, {2.5, 0, 0}}, {2.0, 1.0, 1.7}}},
        {"touching inside", {{{0, 0, 0}, {1, 0, 0}}, {2.0, 1.0}}},
        {"two overlapping", two_spheres(1.23, 1.7, 1.52)},
        {"two with a probe-wide gap", two_spheres(5.45)},
        {"two spindle", two_spheres(5.9)},
        {"two tangent when enlarged", two_spheres(6.2)},
        {"two far", two_spheres(9.0)},
        {"two unequal", two_spheres(4.5, 2.0, 1.4)},
        {"three", triangle(3.0, 1.7)},
        {"three wide", triangle(4.6, 1.7)},
        {"four in a square", equal_spheres({{0, 0, 0}, {2.4, 0, 0}, {2.4, 2.4, 0}, {0, 2.4, 0}}, 1.5)},
        {"four isolated in a square", equal_spheres({{0, 0, 0}, {3.8, 0, 0}, {3.8, 3.8, 0}, {0, 3.8, 0}}, 1.5)},
        {"tetrahedron", tetrahedral_spheres(2.4, 1.5)},
        {"wide tetrahedron", tetrahedral_spheres(4.9, 1.7)},
        {"collinear", line(5, 1.5, 1.6)},
        {"ring", ring(12, 5.0, 1.7)},
        {"ring through a point", ring(8, 3.1, 1.7)},
        {"octahedron", octahedron(2.6, 1.7)},
        {"lattice", cubic_lattice(3, 3.2, 1.7)},
        {"tight lattice", cubic_lattice(3, 2.0, 1.5)},
        {"shell", hollow_shell(60, 5.0, 1.6)},
        {"no probe", random_cluster(5, 20, 7.0), 0.0},
        {"no probe, lattice", cubic_lattice(3, 2.0, 1.5), 0.0},
        {"small probe", random_cluster(6, 20, 7.0), 0.4},
        {"large probe", random_cluster(7, 20, 9.0), 4.0},
    };
}

}  // namespace meniscus::testing
