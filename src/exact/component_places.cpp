// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact/component_places.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/elementary.h"
#include "core/golden_angle.h"
#include "core/odd_direction.h"
#include "core/parallel.h"
#include "core/perpendicular.h"
#include "nearest/nearest_feature.h"
#include "space/box_tree.h"

namespace meniscus {
namespace {

// Å: the way is sampled at least this finely where it crosses the surface.
constexpr double kCrossingStep = 1e-3;

double signed_distance_at(const AccessibleSurface& surface, const Vec3& p) {
    return surface.nearest(p).signed_distance;
}

// A straight way from a point in an arbitrary direction, Å.
struct Way {
    Vec3 start;
    double length;

    Vec3 at(double along) const { return start + along * kOddDirection; }
};

// How often a way crosses each of these components, in their order.
std::vector<int> count_crossings(const AccessibleSurface& surface, const SesPatches& patches, const Way& way,
                                 std::span<const std::uint32_t> components) {
    std::vector<int> crossings(components.size(), 0);
    double at = kCrossingStep;
    double distance = signed_distance_at(surface, way.at(at));
    while (at < way.length) {
        const double next_at = at + std::max(std::abs(distance), kCrossingStep);
        const Vec3 point = way.at(next_at);
        const double next = signed_distance_at(surface, point);
        if ((distance < 0.0) != (next < 0.0)) {
            const auto found = std::find(components.begin(), components.end(), patches.component_at(point));
            if (found != components.end()) ++crossings[static_cast<std::size_t>(found - components.begin())];
        }
        at = next_at;
        distance = next;
    }
    return crossings;
}

// Boxes round components: a patch lies within the enlarged spheres of its atoms.
std::vector<Box> boxes_of_components(const SesPatches& patches) {
    const AccessibleSurface::Data& data = patches.data();
    std::vector<Box> boxes(patches.component_count());
    for (const SesPatch& patch : patches.patches())
        for (const std::uint32_t atom : patches.atoms_of(patch))
            if (atom != kNone) boxes[patch.component].include(data.atoms.centres[atom]);
    for (Box& box : boxes) box = box.grown(data.rho_max);
    return boxes;
}

// A point of each component: on the contact circle or sphere of one of its patches, if it has a contact patch.
std::vector<Vec3> points_on_components(const SesPatches& patches) {
    std::vector<Vec3> points(patches.component_count());
    std::vector<double> largest(points.size(), -1.0);
    for (const SesPatch& patch : patches.patches()) {
        if (patch.ses.area <= largest[patch.component]) continue;
        largest[patch.component] = patch.ses.area;
        points[patch.component] = patches.origin_of(patch) + (1.0 / patch.ses.area) * patch.ses.first_moment;
    }
    return points;
}

// The gap to the nearest atom near one place, to be evaluated many times.
class Gap {
public:
    explicit Gap(const AccessibleSurface& surface) : data_(surface.data()) {}

    /// Prepares for points up to `reach` from a centre, whose own gap is its sphere's radius.
    void gather(const InscribedSphere& from, double reach) {
        Box box;
        box.include(from.centre);
        balls_.clear();
        const double farthest = from.radius + 2.0 * reach;
        data_.atom_tree.for_each_overlapping(box.grown(farthest + data_.rho_max - data_.probe), [&](std::uint32_t i) {
            const double least = farthest + data_.atoms.radii[i];
            if (squared_norm(from.centre - data_.atoms.centres[i]) < least * least)
                balls_.push_back({data_.atoms.centres[i], data_.atoms.radii[i]});
        });
    }
    /// The gap at a point if it exceeds `least`; else any value up to `least`.
    double above(const Vec3& p, double least) {
        double gap = std::numeric_limits<double>::infinity();
        for (std::size_t b = 0; b < balls_.size(); ++b) {
            const double reach = balls_[b].radius + gap;
            if (squared_norm(p - balls_[b].centre) >= reach * reach) continue;
            gap = norm(p - balls_[b].centre) - balls_[b].radius;
            if (gap > least) continue;
            std::swap(balls_[b], balls_[b / 2]);  // likely to refuse the next point, too
            return gap;
        }
        return gap;
    }

    /// Whether the straight way from one point to another passes through no atom; touching does not count.
    bool lets_pass(const Vec3& from, const Vec3& to) const {
        const Vec3 way = to - from;
        return std::none_of(balls_.begin(), balls_.end(), [&](const Ball& ball) {
            const double along = std::clamp(dot(ball.centre - from, way) / squared_norm(way), 0.0, 1.0);
            return norm(from + along * way - ball.centre) < ball.radius - kTouching;
        });
    }

private:
    static constexpr double kTouching = 1e-9;  // Å: above the perturbation

    struct Ball {
        Vec3 centre;
        double radius;
    };
    const AccessibleSurface::Data& data_;
    std::vector<Ball> balls_;
};

// A frame that turns from call to call, so that a search along its axes does not stall in a crease.
std::array<Vec3, 3> turning_frame(int turn) {
    const double angle = kGoldenAngle * turn;
    const Vec3 e1 = normalised({elementary::cos(angle), elementary::sin(angle), 0.6 * elementary::cos(1.7 * angle)});
    const Vec3 e2 = perpendicular(e1);
    return {e1, e2, cross(e1, e2)};
}

// Whether two spheres without atoms in them lie in the same void.
bool is_beside(const Gap& gap, const InscribedSphere& a, const InscribedSphere& b) {
    return norm(a.centre - b.centre) < a.radius + b.radius || gap.lets_pass(a.centre, b.centre);
}

// The steps of a compass search, Å.
struct CompassSteps {
    double first;
    double last;
};

// Searches the largest gap in a room from one place on, until the steps are as small as the last one.
InscribedSphere ascend(Gap& gap, const Box& room, const InscribedSphere& start, const CompassSteps& steps) {
    double step = steps.first;
    InscribedSphere best = start;
    double travel = 4.0 * step;  // what the gathered balls are good for
    Vec3 gathered = best.centre;
    gap.gather(best, travel);
    for (int turn = 0; step > steps.last; ++turn) {
        if (norm(best.centre - gathered) + 2.0 * step > travel) {
            travel = 4.0 * step;
            gathered = best.centre;
            gap.gather(best, travel);
        }
        InscribedSphere next = best;
        const auto [e1, e2, e3] = turning_frame(turn);
        for (int d = 0; d < 27; ++d) {  // to the corners, edges and faces of a cube
            const int along[3] = {d % 3 - 1, d / 3 % 3 - 1, d / 9 - 1};
            const Vec3 towards = along[0] * e1 + along[1] * e2 + along[2] * e3;
            const Vec3 p = best.centre + step * towards;
            const double r = gap.above(p, next.radius);
            if (r > next.radius && room.squared_distance(p) == 0.0 && is_beside(gap, best, {p, r})) next = {p, r};
        }
        if (next.radius > best.radius)
            best = next;
        else
            step *= 0.7;
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
    const std::vector<Box> boxes = boxes_of_components(patches);
    const BoxTree tree(boxes);
    const std::vector<Vec3> points = points_on_components(patches);
    parallel_for(n, 1, [&](std::size_t c) {
        std::vector<std::uint32_t> around;  // all that this one may be in
        Box reach;
        tree.for_each_overlapping(Box{points[c], points[c]}, [&](std::uint32_t other) {
            if ((volumes[other] > 0) == (volumes[c] > 0)) return;
            around.push_back(other);
            reach.include(boxes[other]);
        });
        if (around.empty()) return;
        const double length = norm(reach.high - reach.low) / norm(kOddDirection);
        const std::vector<int> crossings = count_crossings(surface, patches, {points[c], length}, around);
        for (std::size_t k = 0; k < around.size(); ++k) {
            const bool smaller =
                inside_of[c] == kNone || std::abs(volumes[around[k]]) < std::abs(volumes[inside_of[c]]);
            if (crossings[k] % 2 == 1 && smaller) inside_of[c] = around[k];
        }
    });
    return inside_of;
}

InscribedSphere largest_inscribed_sphere(const AccessibleSurface& surface, std::span<const Vec3> starts,
                                         const Box& room) {
    constexpr std::size_t kMostStarts = 32;
    constexpr double kCoarse = 0.1;  // Å: enough to tell which start leads highest
    constexpr double kFine = 1e-7;
    Gap gap(surface);
    InscribedSphere best{starts.front(), surface.probe()};
    const double step = std::max(0.25 * surface.probe(), kCoarse);
    const std::size_t stride = (starts.size() + kMostStarts - 1) / kMostStarts;
    for (std::size_t s = 0; s < starts.size(); s += stride) {
        const InscribedSphere found = ascend(gap, room, {starts[s], surface.probe()}, {step, kCoarse});
        if (found.radius > best.radius) best = found;
    }
    return ascend(gap, room, best, {kCoarse, kFine});
}

}  // namespace meniscus
