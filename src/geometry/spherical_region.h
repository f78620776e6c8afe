// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The parts into which a contour cuts the exposed ground of a sphere, and their areas in closed form.
#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "core/disjoint_sets.h"
#include "geometry/contour.h"
#include "geometry/region_kernels.h"
#include "meniscus/vec3.h"

namespace meniscus {

/// A connected part of the unit sphere of directions that no cap covers.
struct SphericalRegion {
    double solid_angle = 0.0;  ///< steradian
    Vec3 vector_area;          ///< integral of the direction over the region
};

/// Measures the exposed ground of one sphere after the other, reusing its memory.
class SphericalRegions {
public:
    /// Arcs, and the caps that were kept, as a ContourBuilder left them; nothing is exposed if there are caps and no
    /// arcs. They must stay where they are as long as anything is asked.
    ///
    /// cost     O(arcs), O(arcs² + caps²) where these are more than one loop
    /// source   Gauss-Bonnet, as for Connolly's contact patches (J. Appl. Cryst. 16, 1983, 548-558)
    void measure(std::span<const CapPlane> caps, std::span<const ContourArc> arcs);

    std::span<const SphericalRegion> regions() const { return regions_; }
    /// In the order of the contour's arcs.
    std::span<const MeasuredArc> arcs() const { return measured_; }
    /// Direction of the middle of an arc.
    Vec3 middle(std::size_t arc) const { return point_on(arc, 0.5); }

    /// The region that holds an exposed direction. Precondition: there is one.
    std::uint32_t region_of(const Vec3& direction) const;

private:
    struct Crossing {
        double at;  // along the walk, radian
        bool into_cap;
        std::uint32_t arc;
    };

    struct Stand {  // on the contour
        Vec3 point;
        std::uint32_t arc;
    };

    // The closed loops that the arcs make up.
    struct Loops {
        std::uint32_t count = 0;
        std::vector<std::uint32_t> next;    // of each arc: the arc after it on its loop
        std::vector<std::uint32_t> of_arc;  // of each arc: its loop
        std::vector<std::uint32_t> region;  // of each loop
        std::vector<std::uint32_t> arc_on;  // of each cap: an arc of its rim
    };

    void link_arcs();
    void number_loops();
    void measure_arcs();
    Vec3 point_on(std::size_t arc, double part) const;
    std::uint32_t count_cap_clusters() const;
    void group_loops();
    std::vector<Crossing> walk(const Vec3& from, const Vec3& to) const;
    std::vector<Stand> stands_on(std::uint32_t loop, bool many) const;
    double steepness(const Stand& from, const Stand& to) const;
    std::pair<Stand, Stand> way_between(std::uint32_t a, std::uint32_t b) const;
    void join_along_walk(std::uint32_t loop, DisjointSets& loops);
    void add_up();

    std::span<const CapPlane> caps_;
    std::span<const ContourArc> contour_;
    std::vector<MeasuredArc> measured_;
    Loops loops_;
    std::vector<SphericalRegion> regions_;
};

}  // namespace meniscus
