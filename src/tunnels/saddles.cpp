// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "tunnels/saddles.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel_list.h"
#include "meniscus/errors.h"
#include "tunnels/ascent.h"

namespace meniscus {
namespace {

constexpr double kTolerance = 1e-9;     // Å: of touching; what is accepted too much is still a place on a path
constexpr std::size_t kFewAtoms = 7;    // 35 triples, less than what eight smaller cubes take
constexpr double kSmallestCube = 0.02;  // Å
constexpr std::size_t kCubesPerTask = 16;
constexpr int kTurns = 6;
constexpr double kMostCubes = 1e9;

struct Cube {
    Vec3 middle;
    double half = 0.0;  // of the edge
    double reach() const { return std::sqrt(3.0) * half; }
};

struct Roots {
    std::array<double, 2> values{};
    std::size_t count = 0;
};

// Of a x² + 2 b x + c = 0, without cancellation.
Roots roots(double a, double b, double c) {
    if (std::abs(a) < 1e-12 * std::max(1.0, std::abs(b))) {
        if (b == 0.0) return {};
        return {{-c / (2.0 * b)}, 1};
    }
    const double discriminant = b * b - a * c;
    if (discriminant < 0.0) return {};
    const double q = -(b + std::copysign(std::sqrt(discriminant), b));
    if (q == 0.0) return {{0.0}, 1};
    return {{q / a, c / q}, 2};
}

// Appends to `found` the saddles of three atoms.
template <class Found>
void solve_triple(const std::array<Vec3, 3>& p, const std::array<double, 3>& r, const Found& found) {
    // With x = p0 + s e1 + t e2, |x - p_i| = R + r_i: the differences to i = 0 are linear in s, t and R.
    const Vec3 e1 = p[1] - p[0];
    const Vec3 e2 = p[2] - p[0];
    const double g11 = dot(e1, e1);
    const double g12 = dot(e1, e2);
    const double g22 = dot(e2, e2);
    const double determinant = g11 * g22 - g12 * g12;
    if (!(determinant > 1e-12 * g11 * g22)) return;  // on a line: no triangle
    // e_i·(x - p0) = h_i - k_i R
    const double h1 = 0.5 * (g11 + r[0] * r[0] - r[1] * r[1]);
    const double h2 = 0.5 * (g22 + r[0] * r[0] - r[2] * r[2]);
    const double k1 = r[1] - r[0];
    const double k2 = r[2] - r[0];
    const auto combine = [&](double a, double b) {
        return (1.0 / determinant) * ((a * g22 - b * g12) * e1 + (b * g11 - a * g12) * e2);
    };
    const Vec3 u = combine(h1, h2);
    const Vec3 v = combine(k1, k2);
    // |u - R v|² = (R + r0)²
    const Roots both = roots(dot(v, v) - 1.0, -(dot(u, v) + r[0]), dot(u, u) - r[0] * r[0]);
    for (std::size_t i = 0; i < both.count; ++i) {
        const double radius = both.values[i];
        if (!(radius + std::min({r[0], r[1], r[2]}) > 0.0)) continue;
        const Vec3 x = u - radius * v;
        const double a = dot(x, e1);
        const double b = dot(x, e2);
        const double s = (a * g22 - b * g12) / determinant;
        const double t = (b * g11 - a * g12) / determinant;
        if (s < -kTolerance || t < -kTolerance || s + t > 1.0 + kTolerance) continue;
        found(p[0] + x, radius);
    }
}

bool is_same_gate(const Saddle& a, const Saddle& b) {
    constexpr double kSamePlace = 1e-7;  // Å
    constexpr double kSameDirection = 1e-6;
    return norm(a.position - b.position) < kSamePlace && norm(cross(a.normal, b.normal)) < kSameDirection;
}

// Looks for saddles in one cube and what it is divided into.
class CubeSearch {
public:
    CubeSearch(const Clearance& clearance, double min_radius, std::vector<Saddle>& found)
        : clearance_(clearance), min_radius_(min_radius), found_(found) {}

    void search(const Cube& cube) {
        const double here = clearance_.at(cube.middle);
        if (here + cube.reach() < min_radius_) return;
        std::vector<std::uint32_t>& atoms = level(0);
        clearance_.list_atoms(cube.middle, here + 2.0 * cube.reach(), atoms);
        divide(cube, 0);
    }

private:
    std::vector<std::uint32_t>& level(std::size_t depth) {
        if (levels_.size() <= depth) levels_.resize(depth + 8);
        return levels_[depth];
    }

    // Whether there is a direction in which all atoms fall back, wherever in the cube one is: then no ball there is
    // held between them. Looked for as a perceptron does, by turning towards the atom that falls back least.
    bool is_slope(const Cube& cube, const std::vector<std::uint32_t>& atoms) {
        views_.clear();
        Vec3 direction;
        for (const std::uint32_t atom : atoms) {
            const Vec3 from = cube.middle - clearance_.atoms().centres[atom];
            const double distance = norm(from);
            if (!(distance > cube.reach())) return false;
            // Of the directions from the centre to points of the cube, the one that turns most has this cosine less.
            views_.push_back({(1.0 / distance) * from, cube.reach() / distance});
            direction += views_.back().away;
        }
        for (int turn = 0; turn < kTurns; ++turn) {
            const double length = norm(direction);
            if (!(length > 0.0)) return false;
            direction = (1.0 / length) * direction;
            double least = std::numeric_limits<double>::infinity();
            const AtomView* blocking = nullptr;
            for (const AtomView& view : views_) {
                const double now = dot(direction, view.away) - view.clearance;
                if (now >= least) continue;
                least = now;
                blocking = &view;
            }
            if (least > 0.0) return true;
            direction += (blocking->clearance - least) * blocking->away;
        }
        return false;
    }

    void divide(const Cube& cube, std::size_t depth) {
        if (levels_[depth].size() < 3 || is_slope(cube, levels_[depth])) return;
        if (levels_[depth].size() <= kFewAtoms || 2.0 * cube.half <= kSmallestCube) {
            try_triples(cube, levels_[depth]);
            return;
        }
        level(depth + 1);
        const double half = 0.5 * cube.half;
        for (int corner = 0; corner < 8; ++corner) {
            const auto side = [&](int bit) { return (corner & bit) != 0 ? half : -half; };
            const Cube part{cube.middle + Vec3{side(1), side(2), side(4)}, half};
            if (keep_atoms(part, levels_[depth], levels_[depth + 1])) divide(part, depth + 1);
        }
    }

    // Puts those atoms that can touch a ball in a cube into a list; false where the balls would be too small.
    bool keep_atoms(const Cube& cube, const std::vector<std::uint32_t>& from, std::vector<std::uint32_t>& kept) {
        values_.clear();
        double here = std::numeric_limits<double>::infinity();
        for (const std::uint32_t atom : from) {
            values_.push_back(clearance_.of_atom(atom, cube.middle));
            here = std::min(here, values_.back());
        }
        if (here + cube.reach() < min_radius_) return false;
        kept.clear();
        for (std::size_t i = 0; i < from.size(); ++i)
            if (values_[i] <= here + 2.0 * cube.reach() + kTolerance) kept.push_back(from[i]);
        return true;
    }

    void try_triples(const Cube& cube, const std::vector<std::uint32_t>& atoms) {
        first_of_cube_ = found_.size();
        for (std::size_t i = 0; i < atoms.size(); ++i)
            for (std::size_t j = i + 1; j < atoms.size(); ++j)
                for (std::size_t k = j + 1; k < atoms.size(); ++k)
                    try_triple(cube, atoms, {atoms[i], atoms[j], atoms[k]});
    }

    void try_triple(const Cube& cube, const std::vector<std::uint32_t>& atoms,
                    const std::array<std::uint32_t, 3>& triple) {
        const std::vector<Vec3>& centres = clearance_.atoms().centres;
        const std::vector<double>& radii = clearance_.atoms().radii;
        const std::array<Vec3, 3> p{centres[triple[0]], centres[triple[1]], centres[triple[2]]};
        solve_triple(p, {radii[triple[0]], radii[triple[1]], radii[triple[2]]}, [&](const Vec3& x, double radius) {
            if (radius < min_radius_) return;
            const Vec3 d = x - cube.middle;
            const double most = cube.half + kTolerance;
            if (std::abs(d.x) > most || std::abs(d.y) > most || std::abs(d.z) > most) return;
            for (const std::uint32_t atom : atoms)
                if (clearance_.of_atom(atom, x) < radius - kTolerance) return;
            const Saddle saddle{triple, x, normalised(cross(p[1] - p[0], p[2] - p[0])), radius};
            // A ring of n atoms has n³/6 triples, of which the first stands for all.
            const auto begin = found_.begin() + static_cast<std::ptrdiff_t>(first_of_cube_);
            if (std::none_of(begin, found_.end(), [&](const Saddle& s) { return is_same_gate(s, saddle); }))
                found_.push_back(saddle);
        });
    }

    const Clearance& clearance_;
    double min_radius_;
    std::vector<Saddle>& found_;
    std::size_t first_of_cube_ = 0;                   // in `found_`
    std::vector<std::vector<std::uint32_t>> levels_;  // the atoms of the cube that is being divided, by depth
    std::vector<double> values_;
    std::vector<AtomView> views_;
};

std::vector<Saddle> saddles_of_cubes(const Clearance& clearance, const SaddleSearch& search) {
    const Vec3 extent = search.box.high - search.box.low;
    const auto number = [&](double length) { return std::floor(std::max(length, 0.0) / search.cube) + 1.0; };
    const double all = number(extent.x) * number(extent.y) * number(extent.z);
    if (!(all <= kMostCubes)) throw LimitError("the molecule is too large for tunnels");
    const auto nx = static_cast<std::size_t>(number(extent.x));
    const auto ny = static_cast<std::size_t>(number(extent.y));
    return parallel_list<Saddle>(static_cast<std::size_t>(all), kCubesPerTask,
                                 [&](std::size_t begin, std::size_t end, std::vector<Saddle>& found) {
                                     CubeSearch cubes(clearance, search.min_radius, found);
                                     for (std::size_t i = begin; i < end; ++i) {
                                         const std::size_t y = i / nx % ny;
                                         const std::size_t z = i / (nx * ny);
                                         const Vec3 place{static_cast<double>(i % nx) + 0.5,
                                                          static_cast<double>(y) + 0.5, static_cast<double>(z) + 0.5};
                                         cubes.search({search.box.low + search.cube * place, 0.5 * search.cube});
                                     }
                                 });
}

}  // namespace

std::vector<Saddle> tangent_balls(const std::array<Vec3, 3>& centres, const std::array<double, 3>& radii) {
    std::vector<Saddle> result;
    solve_triple(centres, radii, [&](const Vec3& x, double radius) {
        result.push_back({{0, 1, 2}, x, normalised(cross(centres[1] - centres[0], centres[2] - centres[0])), radius});
    });
    return result;
}

std::vector<Saddle> find_saddles(const Clearance& clearance, const SaddleSearch& search) {
    std::vector<Saddle> saddles = saddles_of_cubes(clearance, search);
    // Along x, then the first by atoms of those at one place.
    std::sort(saddles.begin(), saddles.end(), [](const Saddle& a, const Saddle& b) {
        return a.position.x != b.position.x ? a.position.x < b.position.x : a.atoms < b.atoms;
    });
    constexpr double kNear = 1e-7;  // Å
    std::vector<Saddle> kept;
    std::vector<bool> is_double(saddles.size());
    for (std::size_t i = 0; i < saddles.size(); ++i) {
        for (std::size_t j = i + 1; j < saddles.size() && saddles[j].position.x < saddles[i].position.x + kNear; ++j)
            if (is_same_gate(saddles[i], saddles[j])) is_double[saddles[i].atoms <= saddles[j].atoms ? j : i] = true;
        if (!is_double[i]) kept.push_back(saddles[i]);
    }
    std::sort(kept.begin(), kept.end(), [](const Saddle& a, const Saddle& b) {
        return a.atoms != b.atoms ? a.atoms < b.atoms : a.radius < b.radius;
    });
    return kept;
}

}  // namespace meniscus
