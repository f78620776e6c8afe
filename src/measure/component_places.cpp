// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/component_places.h"

#include <algorithm>
#include <cmath>

#include "geometry/nearest_feature.h"

namespace meniscus {
namespace {

// Å: the way is sampled at least this finely where it crosses the surface.
constexpr double kCrossingStep = 1e-3;

double signed_distance_at(const AccessibleSurface& surface, const Vec3& p) {
    return surface.nearest(p).signed_distance;
}

// How often the straight way from `start` to beyond the box crosses each component.
std::vector<int> count_crossings(const AccessibleSurface& surface, const SesPatches& patches, const Vec3& start,
                                 const Vec3& direction, double length) {
    std::vector<int> crossings(patches.component_count(), 0);
    double at = kCrossingStep;
    double distance = signed_distance_at(surface, start + at * direction);
    while (at < length) {
        const double next_at = at + std::max(std::abs(distance), kCrossingStep);
        const Vec3 point = start + next_at * direction;
        const double next = signed_distance_at(surface, point);
        if ((distance < 0.0) != (next < 0.0)) {
            const std::uint32_t component = patches.component_at(point);
            if (component != kNone) ++crossings[component];
        }
        at = next_at;
        distance = next;
    }
    return crossings;
}

// A point of each component: on the contact circle or sphere of one of its patches, if it has a contact patch.
std::vector<Vec3> points_on_components(const SesPatches& patches) {
    std::vector<Vec3> points(patches.component_count());
    std::vector<double> largest(points.size(), -1.0);
    for (const SesPatch& patch : patches.patches()) {
        if (patch.ses.area <= largest[patch.component]) continue;
        largest[patch.component] = patch.ses.area;
        points[patch.component] = patches.origin() + (1.0 / patch.ses.area) * patch.ses.first_moment;
    }
    return points;
}

// The balls around a cavity, to evaluate the gap to the nearest atom many times.
class Gap {
public:
    Gap(const AccessibleSurface& surface, const Box& around) : data_(surface.data()) {
        data_.atom_tree.for_each_overlapping(around, [&](std::uint32_t i) { atoms_.push_back(i); });
    }
    double operator()(const Vec3& p) const {
        double gap = std::numeric_limits<double>::infinity();
        for (const std::uint32_t i : atoms_)
            gap = std::min(gap, norm(p - data_.atoms.centres[i]) - data_.atoms.radii[i]);
        return gap;
    }

private:
    const AccessibleSurface::Data& data_;
    std::vector<std::uint32_t> atoms_;
};

// Compass search on the cube's 26 directions; steps never leave the empty sphere in hand by more than the probe.
InscribedSphere ascend(const Gap& gap, const Vec3& start, double probe) {
    constexpr double kLastStep = 1e-6;  // Å
    InscribedSphere best{start, gap(start)};
    for (double step = std::max(0.25 * probe, 0.05); step > kLastStep;) {
        InscribedSphere next = best;
        for (int d = 0; d < 27; ++d) {
            if (d == 13) continue;  // stay
            const Vec3 direction{double(d % 3 - 1), double(d / 3 % 3 - 1), double(d / 9 - 1)};
            const Vec3 p = best.centre + (step / norm(direction)) * direction;
            if (const double r = gap(p); r > next.radius) next = {p, r};
        }
        if (next.radius > best.radius)
            best = next;
        else
            step *= 0.5;
    }
    return best;
}

}  // namespace

std::vector<std::uint32_t> nest_components(const AccessibleSurface& surface, const SesPatches& patches,
                                           std::span<const double> volumes) {
    const std::size_t n = volumes.size();
    std::vector<std::uint32_t> inside_of(n, kNone);
    const auto outer =
        static_cast<std::size_t>(std::count_if(volumes.begin(), volumes.end(), [](double v) { return v > 0; }));
    if (outer <= 1) {
        const auto only =
            static_cast<std::uint32_t>(std::max_element(volumes.begin(), volumes.end()) - volumes.begin());
        for (std::uint32_t c = 0; c < n; ++c)
            if (outer == 1 && c != only) inside_of[c] = only;
        return inside_of;
    }
    Box box;
    for (const Vec3& centre : surface.data().atoms.centres) box.include(centre);
    const double length = norm(box.high - box.low) + 4.0 * surface.data().rho_max;
    const Vec3 direction = normalised({0.5377, 0.6181, 0.5737});  // no symmetry axis of anything
    const std::vector<Vec3> points = points_on_components(patches);
    for (std::uint32_t c = 0; c < n; ++c) {
        const std::vector<int> crossings = count_crossings(surface, patches, points[c], direction, length);
        for (std::uint32_t other = 0; other < n; ++other) {
            const bool holds = other != c && crossings[other] % 2 == 1 && (volumes[other] > 0) != (volumes[c] > 0);
            if (holds && (inside_of[c] == kNone || std::abs(volumes[other]) < std::abs(volumes[inside_of[c]])))
                inside_of[c] = other;
        }
    }
    return inside_of;
}

InscribedSphere largest_inscribed_sphere(const AccessibleSurface& surface, std::span<const Vec3> starts) {
    constexpr std::size_t kMostStarts = 32;
    Box box;
    for (const Vec3& start : starts) box.include(start);
    // Every empty sphere of the cavity touches atoms that line it: those within reach of its probe positions.
    const Gap gap(surface, box.grown(2.0 * surface.data().rho_max));
    InscribedSphere best;
    const std::size_t stride = (starts.size() + kMostStarts - 1) / kMostStarts;
    for (std::size_t s = 0; s < starts.size(); s += stride) {
        const InscribedSphere found = ascend(gap, starts[s], surface.probe());
        if (found.radius > best.radius) best = found;
    }
    return best;
}

}  // namespace meniscus
