// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "support/brute_force_ses.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace meniscus::testing {
namespace {

// A candidate this deep (Å) in a ball still counts as exposed: points where four spheres meet are kept.
constexpr double kSlack = 1e-8;

}  // namespace

BruteForceSes::BruteForceSes(const Atoms& atoms, double probe) : probe_(probe) {
    for (std::size_t i = 0; i < atoms.size(); ++i) {
        bool duplicate = false;
        for (std::size_t j = 0; j < centres_.size(); ++j)
            duplicate = duplicate || (centres_[j] == atoms.centres[i] && rho_[j] == atoms.radii[i] + probe);
        if (duplicate) continue;
        centres_.push_back(atoms.centres[i]);
        rho_.push_back(atoms.radii[i] + probe);
    }
    neighbours_.resize(centres_.size());
    for (std::size_t i = 0; i < centres_.size(); ++i)
        for (std::size_t j = 0; j < centres_.size(); ++j)
            if (i != j && norm(centres_[i] - centres_[j]) < rho_[i] + rho_[j]) neighbours_[i].push_back(j);
    find_circles();
    find_points();
}

bool BruteForceSes::in_some_ball(const Vec3& x, const std::vector<std::size_t>& balls) const {
    return std::any_of(balls.begin(), balls.end(),
                       [&](std::size_t j) { return norm(x - centres_[j]) < rho_[j] - kSlack; });
}

void BruteForceSes::find_circles() {
    for (std::size_t i = 0; i < centres_.size(); ++i)
        for (const std::size_t j : neighbours_[i]) {
            const Vec3 between = centres_[j] - centres_[i];
            const double d = norm(between);
            if (j < i || d == 0.0) continue;
            const double h = 0.5 * (d + (rho_[i] - rho_[j]) * (rho_[i] + rho_[j]) / d);
            const double squared_radius = rho_[i] * rho_[i] - h * h;
            if (squared_radius <= 0.0) continue;
            const Vec3 axis = (1.0 / d) * between;
            circles_.push_back({i, j, centres_[i] + h * axis, axis, std::sqrt(squared_radius)});
        }
}

// Points of three spheres: where the circle of two meets the third (a plane equation along the circle).
void BruteForceSes::find_points() {
    for (const Circle& circle : circles_)
        for (const std::size_t k : neighbours_[circle.i]) {
            if (k < circle.j) continue;
            const Vec3 q = centres_[k] - circle.centre;
            const Vec3 in_plane = q - dot(q, circle.axis) * circle.axis;
            const double along = norm(in_plane);
            if (k == circle.j || along < 1e-12) continue;
            const double cosine =
                (squared_norm(q) + circle.radius * circle.radius - rho_[k] * rho_[k]) / (2.0 * circle.radius * along);
            if (std::abs(cosine) > 1.0) continue;
            const Vec3 u = (1.0 / along) * in_plane;
            const Vec3 v = cross(circle.axis, u);
            for (const double sign : {-1.0, 1.0}) {
                const double sine = sign * std::sqrt(1.0 - cosine * cosine);
                const Vec3 x = circle.centre + circle.radius * (cosine * u + sine * v);
                if (!in_some_ball(x, neighbours_[circle.i])) points_.push_back(x);
            }
        }
}

double BruteForceSes::signed_distance(const Vec3& p) const {
    double gap = std::numeric_limits<double>::infinity();  // to the nearest enlarged ball; negative inside
    for (std::size_t i = 0; i < centres_.size(); ++i) gap = std::min(gap, norm(p - centres_[i]) - rho_[i]);
    if (gap >= 0.0) return probe_ + gap;

    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < centres_.size(); ++i) {
        const double l = norm(p - centres_[i]);
        if (std::abs(l - rho_[i]) >= nearest || l == 0.0) continue;
        const Vec3 x = centres_[i] + (rho_[i] / l) * (p - centres_[i]);
        if (!in_some_ball(x, neighbours_[i])) nearest = std::abs(l - rho_[i]);
    }
    for (const Circle& circle : circles_) {
        const Vec3 q = p - circle.centre;
        const double height = dot(q, circle.axis);
        const Vec3 radial = q - height * circle.axis;
        const double r = norm(radial);
        const double distance = std::hypot(height, circle.radius - r);
        if (distance >= nearest || r == 0.0) continue;
        const Vec3 x = circle.centre + (circle.radius / r) * radial;
        if (!in_some_ball(x, neighbours_[circle.i])) nearest = distance;
    }
    for (const Vec3& x : points_) nearest = std::min(nearest, norm(p - x));
    return probe_ - nearest;
}

}  // namespace meniscus::testing
