// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What an AccessibleSurface holds: features of the SAS in canonical order, and the trees to find them.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "geometry/accessible_surface.h"
#include "geometry/contour.h"
#include "space/box_tree.h"
#include "space/canonical_atoms.h"

namespace meniscus {

inline constexpr std::uint32_t kNoVertex = 0xffffffffU;
inline constexpr std::uint32_t kNoArc = 0xffffffffU;

/// A probe position that touches three atoms, in this order: the contour of atoms[0] passes from atoms[1] to [2].
struct SasVertex {
    std::array<std::uint32_t, 3> atoms{};
    /// That end here, each opposite to the atom that it does not belong to.
    std::array<std::uint32_t, 3> arcs{kNoArc, kNoArc, kNoArc};
    Vec3 position;
};

/// An exposed arc of the circle where the enlarged spheres of two atoms meet.
struct SasArc {
    std::array<std::uint32_t, 2> atoms{};  ///< ascending
    std::uint32_t start = kNoVertex;       ///< vertices, in the direction of the contour of atoms[0];
    std::uint32_t end = kNoVertex;         ///< kNoVertex for a whole circle
    Vec3 centre;                           ///< of the circle, Å
    Vec3 axis;                             ///< unit vector from atoms[0] to atoms[1]
    double radius = 0.0;                   ///< of the circle, Å
    double height0 = 0.0;                  ///< of the circle's plane above atoms[0], along axis, signed
    double height1 = 0.0;                  ///< of atoms[1] above the circle's plane, signed
    Vec3 middle;                           ///< unit vector from the centre to the arc's midpoint
    double angle = 0.0;                    ///< swept, radian
    /// Cosine of half the angle; of a whole circle so far below every cosine that the border of a cell (CellBorder)
    /// makes no difference.
    double cos_half = -4.0;

    bool whole_circle() const { return start == kNoVertex; }
    /// Of half an angle below 4e-7: where four spheres meet in a point, an arc that only the perturbation made. Its
    /// ends answer for it, or else points on a plane of symmetry would get the curvature of a torus without width.
    bool is_a_point() const { return cos_half > 1.0 - 1e-13; }
};

struct AccessibleSurface::Data {
    double probe = 0.0;
    CanonicalAtoms atoms;
    std::vector<double> rho;  ///< enlarged radii, perturbed, Å
    double rho_max = 0.0;
    double perturbation = 0.0;  ///< amplitude applied to rho, Å

    std::vector<std::uint8_t> exposed;         ///< per atom
    std::vector<std::uint64_t> cover_begin;    ///< per atom, and the end: its part of `cover`
    std::vector<std::uint32_t> cover;          ///< neighbours whose caps bury what all neighbours bury
    std::vector<std::uint64_t> cap_begin;      ///< per exposed atom, and the end: its caps in `caps`
    std::vector<CapPlane> caps;                ///< of its cover, one after the other
    std::vector<std::uint32_t> cap_arc;        ///< of each: an arc on its rim, or kNoArc
    std::vector<std::uint64_t> contour_begin;  ///< per atom, and the end: its part of `contour`
    std::vector<ContourArc> contour;           ///< caps are numbered as in caps_of(atom)
    std::vector<std::uint32_t> contour_arc;    ///< of each: its position in `arcs`
    std::vector<SasArc> arcs;
    std::vector<SasVertex> vertices;

    BoxTree atom_tree;      ///< centres
    BoxTree arc_tree;       ///< points of the arcs
    BoxTree arc_cell_tree;  ///< the arcs' cells, the hulls of an arc and both atoms; none for a point
    BoxTree vertex_tree;    ///< positions

    std::span<const CapPlane> caps_of(std::uint32_t atom) const {
        return std::span(caps).subspan(cap_begin[atom], cap_begin[atom + 1] - cap_begin[atom]);
    }
    std::span<const std::uint32_t> cover_of(std::uint32_t atom) const {
        return std::span(cover).subspan(cover_begin[atom], cover_begin[atom + 1] - cover_begin[atom]);
    }
    std::span<const ContourArc> contour_of(std::uint32_t atom) const {
        return std::span(contour).subspan(contour_begin[atom], contour_begin[atom + 1] - contour_begin[atom]);
    }
    /// Whether the point of the enlarged sphere of `atom` in direction q (any length l = |q|) is exposed.
    bool direction_exposed(std::uint32_t atom, const Vec3& q, double l) const {
        for (const CapPlane& cap : caps_of(atom))
            if (dot(cap.axis, q) > cap.t * l) return false;
        return true;
    }
};

/// Distance² of p from the nearest point of an arc, if that point is not one of its ends and the arc is none itself.
struct ArcFoot {
    bool within = false;
    double squared_distance = 0.0;
    double height = 0.0;     ///< of p above the circle's plane, Å
    double from_axis = 0.0;  ///< distance of p from the circle's axis, Å
    Vec3 radial;             ///< from the axis to p, length from_axis
};
inline ArcFoot foot_on_arc(const SasArc& arc, const Vec3& p) {
    ArcFoot foot;
    const Vec3 q = p - arc.centre;
    foot.height = dot(arc.axis, q);
    foot.radial = q - foot.height * arc.axis;
    foot.from_axis = norm(foot.radial);
    foot.within = dot(foot.radial, arc.middle) >= arc.cos_half * foot.from_axis && !arc.is_a_point();
    const double off = arc.radius - foot.from_axis;
    foot.squared_distance = foot.height * foot.height + off * off;
    return foot;
}

/// Whether p lies in the arc's cell, where its own arc is the nearest feature: the wedge between the arc and
/// both atoms. `foot` must be within the arc.
inline bool in_arc_cell(const SasArc& arc, const ArcFoot& foot) {
    const double off = arc.radius - foot.from_axis;
    return arc.radius * foot.height + arc.height0 * off >= 0.0 && arc.height1 * off - arc.radius * foot.height >= 0.0;
}

}  // namespace meniscus
