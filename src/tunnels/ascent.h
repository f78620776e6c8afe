// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Ways up: from a point along rising clearance to a local maximum, or out of the molecule.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meniscus/vec3.h"
#include "tunnels/clearance.h"

namespace meniscus {

/// An atom as seen from a point: the unit vector from its centre to the point, and its clearance there.
struct AtomView {
    Vec3 away;
    double clearance = 0.0;
};

/// The step d that maximises min(clearance + away·d) - |d|²/(2 reach): the steepest way up with regard to all atoms.
///
/// An atom's distance is a convex function of the place, so its true clearance after the step is no smaller than
/// clearance + away·d, and on the way there no smaller than the smaller one of both ends.
Vec3 step_up(std::span<const AtomView> atoms, double reach);

/// Climbs, one step after the other. Memory is kept from call to call; one object per thread.
class Ascent {
public:
    explicit Ascent(const Clearance& clearance) : clearance_(clearance) {}

    /// Calls visit(point) for the points of a polyline that begins at `point`, without that one, as long as visit()
    /// returns true and there is a way up. Clearance falls nowhere along the polyline. Returns the last point.
    template <class Visit>
    Vec3 climb(Vec3 point, const Visit& visit) {
        forget();
        for (int i = 0; i < kMostSteps; ++i) {
            Vec3 next;
            if (!find_next(point, next)) break;
            point = next;
            if (!visit(point)) break;
        }
        return point;
    }

    /// Within visit(): the clearance of the point before.
    double clearance_before() const { return here_; }

private:
    static constexpr int kMostSteps = 100000;

    void forget() { list_.clear(); }
    bool find_next(const Vec3& point, Vec3& next);
    void look_round(const Vec3& point);

    const Clearance& clearance_;
    std::vector<std::uint32_t> list_;  // of atoms that may matter near `seen_from_`
    Vec3 seen_from_;
    double most_ = 0.0;  // clearance at `seen_from_` up to which atoms are in the list
    std::vector<AtomView> views_;
    double here_ = 0.0;  // clearance at the point
};

}  // namespace meniscus
