// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Contour build-up: the exposed part of one sphere after its neighbours have buried their caps.
//
// On the sphere of radius rho around atom i, neighbour j buries the cap {n : n·axis > t}. The boundary of what
// stays exposed is kept as arcs of the caps' rims, each traversed with the exposed region on its left, hence
// clockwise around its cap. A boundary passes from the rim of cap j onto the rim of cap k at one point at
// most, so the ordered pair (j, k) names a vertex (docs/design/exact-geometry.md).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/cap_kernels.h"
#include "geometry/contour_types.h"
#include "meniscus/vec3.h"

namespace meniscus {

/// An arc of a cap's rim on the contour. `cap`, `from` and `to` are positions in the list of caps; the arc runs
/// from where the contour leaves cap `from` to where it enters cap `to`, both kWholeCircle for a whole rim.
struct ContourArc {
    std::uint32_t cap = 0;
    std::uint32_t from = kWholeCircle;
    std::uint32_t to = kWholeCircle;
    double start = 0.0;  ///< pseudo-angle along the rim, [0, 4)
    double sweep = 4.0;  ///< pseudo-angle to the end, (0, 4]
};

/// Where the rims of two caps meet.
struct RimCrossing {
    bool crosses = false;
    Vec3 onto;  ///< where the contour passes from the rim of the first cap onto that of the second
    Vec3 back;  ///< and from the second onto the first
};
RimCrossing cross_rims(const Cap& a, const Cap& b);

/// Builds the contours of spheres one after the other, reusing its memory.
class ContourBuilder {
public:
    /// Inserts the largest cap, then always one that buries an end of an arc, the deepest there, and at last those
    /// that only cross arcs or lie between them, whatever their order.
    ///
    /// returns  false if rounding made the arrangement inconsistent: perturb and try again
    /// cost     O(caps · arcs), stops as soon as nothing is exposed
    bool build(std::span<const Cap> caps);

    /// The same in the order of `caps`: for caps known to bury most, and then for the rest behind them.
    bool build_in_order(std::span<const Cap> caps);
    /// Goes on after build_in_order, whose caps `caps` begins with, while something is exposed.
    bool extend(std::span<const Cap> caps);

    /// The contour; empty when nothing or the whole sphere is exposed.
    std::span<const ContourArc> arcs() const { return arcs_; }
    /// Positions of caps whose union is that of all caps, in order of insertion.
    std::span<const std::uint32_t> kept() const { return kept_; }
    bool exposed() const { return kept_.empty() || !arcs_.empty(); }

private:
    struct Crossing {
        double angle;       // pseudo-angle on the inserted rim
        std::uint32_t cap;  // the other rim
        Vec3 point;
    };
    struct Ends {
        Vec3 start;
        Vec3 end;
        bool settled = false;  // no cap to come buries the end
    };
    void start(std::span<const Cap> caps);
    bool insert(std::uint32_t k);
    void wait_from(std::size_t first);
    bool insert_waiting(std::size_t i);
    bool bury_ends();
    bool insert_rest();
    void drop_idle();
    void find_near(const Cap& cap);
    void cross_near(const Cap& cap);
    RimCrossing crossing_of(std::size_t i) const;
    bool cut(std::size_t i, std::uint32_t k);
    bool cut_at(std::size_t i, std::uint32_t k);
    bool close_rim(std::uint32_t k);
    void replace(std::size_t a, std::uint32_t k, const ContourArc& piece, const Ends& ends);
    void append(const ContourArc& arc, const Ends& ends);
    void remove(std::size_t a);
    void note_crossings(std::uint32_t k, const ContourArc& piece, const Ends& ends);
    ArcExtent extent_of(const ContourArc& arc, const Ends& ends) const;
    bool is_exposed(const Vec3& n) const;
    Vec3 point_on_rim(std::uint32_t k) const;
    double pseudo_angle(std::uint32_t cap, const Vec3& n) const;

    const CapKernels* kernels_ = &cap_kernels();
    std::span<const Cap> caps_;
    std::size_t inserted_ = 0;          // by build_in_order
    std::vector<std::uint32_t> order_;  // of insertion by build and extend
    std::vector<Rim> rims_;             // of caps that reached the contour
    std::vector<ContourArc> arcs_;
    std::vector<Ends> ends_;           // of arcs_
    std::vector<ArcExtent> extents_;   // of arcs_
    std::vector<std::uint32_t> near_;  // arcs that the inserted cap may reach
    std::size_t near_count_ = 0;
    std::vector<std::uint32_t> near_rims_;  // of those arcs
    MeetingColumns meetings_;               // with those rims
    std::vector<Crossing> entries_;
    std::vector<Crossing> exits_;
    std::vector<std::uint32_t> kept_;
    std::vector<Cap> kept_caps_;
    CapColumns waiting_;  // those of order_
    std::vector<double> idle_;
};

/// A unit vector perpendicular to the unit vector `axis`.
Vec3 perpendicular(const Vec3& axis);

/// RimCrossing::onto. Precondition: the rims cross.
Vec3 rim_crossing(const Cap& a, const Cap& b);

}  // namespace meniscus
