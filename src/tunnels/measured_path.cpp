// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "tunnels/measured_path.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "meniscus/measures.h"

namespace meniscus {
namespace {

constexpr double kLongestSegment = 0.25;  // Å

// The caller's indices of the atoms that are nearest to a point, as many as there are.
std::array<std::uint32_t, 3> nearest_atoms(const Clearance& clearance, const Vec3& point) {
    std::vector<std::uint32_t> list;
    const std::size_t wanted = std::min<std::size_t>(3, clearance.atoms().size());
    double most = clearance.at(point);
    for (double band = 1.0; list.size() < wanted; band *= 2.0) clearance.list_atoms(point, most + band, list);
    std::sort(list.begin(), list.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::pair(clearance.of_atom(a, point), a) < std::pair(clearance.of_atom(b, point), b);
    });
    std::array<std::uint32_t, 3> atoms{kNone, kNone, kNone};
    for (std::size_t i = 0; i < wanted; ++i) atoms[i] = clearance.atoms().original[list[i]];
    std::sort(atoms.begin(), atoms.end());
    return atoms;
}

}  // namespace

std::vector<Vec3> moved(std::vector<Vec3> up, double radius) {
    std::size_t first = 0;
    while (first + 1 < up.size() && norm(up[first + 1] - up.front()) <= radius) ++first;
    up.erase(up.begin(), up.begin() + static_cast<std::ptrdiff_t>(first));
    return up;
}

void Way::append(const std::vector<Vec3>& more) {
    for (const Vec3& point : more) points.push_back(point);
}

void Way::append(const std::vector<Vec3>& more, const Saddle& saddle) {
    for (const Vec3& point : more) {
        if (point == saddle.position) {
            saddle_points.push_back(points.size());
            saddles.push_back(saddle);
        }
        points.push_back(point);
    }
}

Way resampled(const Clearance& clearance, const Way& way) {
    Way result;
    std::size_t saddle = 0;
    std::size_t next = 0;
    for (std::size_t i = 0; i < way.points.size(); i = next) {
        const Vec3& from = way.points[i];
        const bool is_saddle = saddle < way.saddle_points.size() && way.saddle_points[saddle] == i;
        if (is_saddle) {
            result.saddle_points.push_back(result.points.size());
            result.saddles.push_back(way.saddles[saddle++]);
        }
        result.points.push_back(from);
        next = i + 1;
        if (next == way.points.size()) break;
        const double here = clearance.at(from);
        const std::size_t last = saddle < way.saddle_points.size() ? way.saddle_points[saddle] : way.points.size() - 1;
        // Also past a maximum to which the way climbs only to come back.
        for (std::size_t j = last; j > next; --j) {
            if (norm(way.points[j] - from) > kLongestSegment) continue;
            if (clearance.along(from, way.points[j]) >=
                std::min(here, clearance.at(way.points[j])) - kClearanceRounding)
                next = j;
        }
        const Vec3 along = way.points[next] - from;
        const double parts = std::ceil(norm(along) / kLongestSegment);
        for (double k = 1.0; k < parts; ++k) result.points.push_back(from + (k / parts) * along);
    }
    return result;
}

Bottleneck bottleneck_of(const Clearance& clearance, const Way& way) {
    const double first = clearance.at(way.points.front());
    const double last = clearance.at(way.points.back());
    const std::size_t end = first <= last ? 0 : way.points.size() - 1;
    Bottleneck narrowest{std::min(first, last), way.points[end], end, {}, true};
    for (std::size_t i = 0; i < way.saddles.size(); ++i) {
        const Saddle& saddle = way.saddles[i];
        if (saddle.radius > narrowest.radius || (!narrowest.at_end && saddle.radius == narrowest.radius)) continue;
        narrowest = {saddle.radius, saddle.position, way.saddle_points[i], {}, false};
        for (std::size_t k = 0; k < 3; ++k) narrowest.atoms[k] = clearance.atoms().original[saddle.atoms[k]];
        std::sort(narrowest.atoms.begin(), narrowest.atoms.end());
    }
    if (narrowest.at_end) narrowest.atoms = nearest_atoms(clearance, narrowest.position);
    return narrowest;
}

TunnelPath measured(const Clearance& clearance, const Way& way) {
    TunnelPath path;
    path.bottleneck = bottleneck_of(clearance, way);
    for (const Vec3& point : way.points) {
        const double radius = clearance.at(point);
        if (path.points.empty()) {
            path.certified_radius = radius;
        } else {
            const PathPoint& before = path.points.back();
            path.length += norm(point - before.position);
            path.certified_radius = std::min(path.certified_radius,
                                             clearance.along(before.position, point, std::min(before.radius, radius)));
        }
        path.points.push_back({point, path.length, radius});
    }
    const double straight = norm(way.points.back() - way.points.front());
    path.curvature = straight > 0.0 ? path.length / straight : 1.0;
    return path;
}

}  // namespace meniscus
