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

/// An arc of a cap's rim on the contour. `cap`, `from` and `to` are positions among the caps that were kept; the arc
/// runs from where the contour leaves cap `from` to where it enters cap `to`, both kWholeCircle for a whole rim.
struct ContourArc {
    std::uint32_t cap = 0;
    std::uint32_t from = kWholeCircle;
    std::uint32_t to = kWholeCircle;
    double sweep = 4.0;  ///< pseudo-angle from the start to the end, in [0, 4]
};

/// Where the rims of two caps meet.
struct RimCrossing {
    bool crosses = false;
    Vec3 onto;  ///< where the contour passes from the rim of the first cap onto that of the second
    Vec3 back;  ///< and from the second onto the first
};
RimCrossing cross_rims(const Cap& a, const Cap& b);

/// The arcs of a contour that is being built; where they lie is kept side by side, for vectors.
class OpenArcs {
public:
    struct Arc {
        std::uint32_t cap;  // these as in ContourArc
        std::uint32_t from;
        std::uint32_t to;
        bool settled = false;  // no cap to come buries the end
    };

    std::size_t size() const { return arcs_.size(); }
    bool empty() const { return arcs_.empty(); }
    Arc& operator[](std::size_t a) { return arcs_[a]; }
    const Arc& operator[](std::size_t a) const { return arcs_[a]; }

    CapPlane rim(std::size_t a) const;
    Vec3 start(std::size_t a) const;
    Vec3 end(std::size_t a) const;
    void move_start(std::size_t a, const Vec3& start);
    void move_end(std::size_t a, const Vec3& end);
    /// Of all arcs, eight by eight; there may be more than `size` needs.
    std::span<const EightArcs> lanes() const { return lanes_; }

    void clear() { arcs_.clear(); }
    void append(const Arc& arc, const CapPlane& rim, const Vec3& start, const Vec3& end);
    /// Puts the last arc into the place of one.
    void remove(std::size_t a);

private:
    const double* lane_of(std::size_t a) const { return &lanes_[a / EightArcs::kCount].numbers[a % EightArcs::kCount]; }
    double* lane_of(std::size_t a) { return &lanes_[a / EightArcs::kCount].numbers[a % EightArcs::kCount]; }

    std::vector<Arc> arcs_;
    std::vector<EightArcs> lanes_;
};

/// Builds the contours of spheres one after the other, reusing its memory.
class ContourBuilder {
public:
    /// Inserts the largest cap, then always one that buries an end of an arc, the deepest there, and at last those
    /// that only cross arcs or lie between them, whatever their order.
    ///
    /// returns  false if rounding made the arrangement inconsistent: perturb and try again
    /// cost     O(caps · arcs), stops as soon as nothing is exposed
    bool build(const CapColumns& caps);

    /// Inserts the caps in their order until nothing is exposed: for caps that are known to bury most of the sphere.
    bool build_in_order(const CapColumns& caps);
    /// Inserts the remaining caps after build_in_order; `caps` must begin with the caps that were given there.
    bool extend(const CapColumns& caps);

    /// The contour as build or extend left it; empty when nothing or the whole sphere is exposed.
    std::span<const ContourArc> arcs() const { return arcs_; }
    /// Caps whose union is that of all caps, in order of insertion, which arcs number them in; and their positions in
    /// the list of all.
    std::span<const CapPlane> kept_caps() const { return kept_.planes; }
    std::span<const std::uint32_t> kept() const { return kept_.numbers; }
    bool exposed() const { return kept_.numbers.empty() || !open_.empty(); }

private:
    struct Crossing {
        std::uint32_t cap;  // the other rim
        Vec3 point;
    };
    // Of the contour with the rim of the cap that is being inserted.
    struct Crossings {
        std::vector<Crossing> entries;
        std::vector<Crossing> exits;
    };
    struct WaitingCaps {
        std::vector<double> t;              // of each cap that waits for insertion, else kNoCap
        std::vector<std::uint64_t> marks;   // of the caps
        std::vector<std::uint32_t> chosen;  // those that may still change the contour
    };
    struct KeptCaps {
        std::vector<std::uint32_t> numbers;
        std::vector<CapPlane> planes;
    };

    void start(const CapColumns& caps);
    void wait_from(std::size_t first);
    bool insert_waiting(std::size_t k);
    bool bury_ends();
    bool insert_rest();
    void find_rest();
    bool insert(std::uint32_t k);
    bool cut_arcs(const CapPlane& cap);
    void cut_once(std::size_t begin, const EightMeetings& meetings);
    void cut_one_by_one(std::size_t begin, const EightMeetings& meetings, const CapPlane& cap);
    void cut_end(std::size_t a, const Vec3& crossing);
    void cut_start(std::size_t a, const Vec3& crossing);
    void cut_twice(std::size_t a, bool starts_inside, const CapPlane& cap);
    bool close_rim(const CapPlane& cap);
    void close_rim_by_angles(const CapPlane& cap);
    void list_arcs();
    bool is_exposed(const Vec3& n) const;
    // The number among the kept caps that the cap which is being inserted will have.
    std::uint32_t place() const { return static_cast<std::uint32_t>(kept_.numbers.size()); }

    const CapColumns* caps_ = nullptr;
    std::size_t inserted_ = 0;  // by build_in_order
    WaitingCaps waiting_;
    OpenArcs open_;
    std::vector<EightMeetings> meetings_;
    Crossings crossings_;
    std::vector<ContourArc> arcs_;
    KeptCaps kept_;
};

/// RimCrossing::onto. Precondition: the rims cross.
Vec3 rim_crossing(const Cap& a, const Cap& b);

}  // namespace meniscus
