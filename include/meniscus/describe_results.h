// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Every key of every result, described once for the report, Python's dicts, the JSON schema and the manual.
//
// A visitor is called once per key, in the order of the report; `inner` is a visitor of the same type for nested keys:
//   visit(quantity, value)                        a number, text, truth value, Vec3, vector, array or optional of these
//   visit(quantity, value, words)                 a value that has a word
//   visit.block(quantity, inside)                 calls inside(inner)
//   visit.optional_block(quantity, maybe, inside) calls inside(inner, *maybe), unless the optional or pointer is empty
//   visit.list(quantity, elements, inside)        calls inside(inner, element) for each element
//   visit.optional_list(quantity, maybe, inside)  as list, with an optional of, or a pointer to, a vector
// A visitor that needs no values, such as that of a schema, calls `inside` with a default-constructed element.
#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>

#include "meniscus/compare.h"
#include "meniscus/cost.h"
#include "meniscus/flow.h"
#include "meniscus/interfaces.h"
#include "meniscus/measures.h"
#include "meniscus/mesh_quality.h"
#include "meniscus/surface.h"
#include "meniscus/words.h"

namespace meniscus {

/// One key of a result.
struct Quantity {
    const char* name;
    const char* unit;     ///< "Å²"; empty without a unit
    const char* meaning;  ///< a phrase in plain English; names of code in backticks
};

inline constexpr Words<ComponentKind, 2> kComponentKindWords{
    {{"outer", ComponentKind::Outer}, {"cavity", ComponentKind::Cavity}}};

template <class Visitor>
void describe(const SurfaceTotals& t, Visitor& visit) {
    visit({"sas_area", "Å²", "area of the solvent-accessible surface"}, t.sas_area);
    visit({"sas_volume", "Å³", "volume of the solvent-accessible surface"}, t.sas_volume);
    visit({"ses_area", "Å²", "area of the solvent-excluded surface"}, t.ses_area);
    visit({"ses_volume", "Å³", "volume of the solvent-excluded surface"}, t.ses_volume);
    visit({"contact_area", "Å²", "area of the contact patches of the SES"}, t.contact_area);
    visit({"toroidal_area", "Å²", "area of the toroidal patches of the SES"}, t.toroidal_area);
    visit({"reentrant_area", "Å²", "area of the reentrant patches of the SES"}, t.reentrant_area);
}

template <class Visitor>
void describe(const PatchAreas& p, Visitor& visit) {
    visit({"ses_area", "Å²", "area of all its patches"}, p.sum());
    visit({"contact_area", "Å²", "area of its contact patches"}, p.contact);
    visit({"toroidal_area", "Å²", "area of its toroidal patches"}, p.toroidal);
    visit({"reentrant_area", "Å²", "area of its reentrant patches"}, p.reentrant);
}

/// The totals of measures; the components are described one by one.
template <class Visitor>
void describe(const Measures& m, Visitor& visit) {
    describe(m.totals, visit);
    visit.block(
        {"errors", "", "absolute error of each of these seven by its key, estimated from independent evaluations"},
        [&](auto& inner) { describe(m.errors, inner); });
    visit({"sas_components", "", "number of closed pieces of the SAS"}, m.sas_components);
    visit.block({"largest_sas_piece", "",
                 "SES patches of the piece of the SAS with the largest area; programs that roll one probe over the "
                 "molecule call this the outer component"},
                [&](auto& inner) { describe(m.largest_sas_piece, inner); });
    visit({"degenerate", "", "`true` if probe positions coincide, as on lattices: the error is larger"}, m.degenerate);
}

template <class Visitor>
void describe(const SurfaceComponent& c, Visitor& visit) {
    const bool is_cavity = c.kind == ComponentKind::Cavity;
    visit({"kind", "", "`outer` or `cavity`"}, c.kind, kComponentKindWords);
    visit({"ses_area", "Å²", "area of the piece"}, c.ses_area);
    visit({"contact_area", "Å²", "area of its contact patches"}, c.contact_area);
    visit({"toroidal_area", "Å²", "area of its toroidal patches"}, c.toroidal_area);
    visit({"reentrant_area", "Å²", "area of its reentrant patches"}, c.reentrant_area);
    visit({"ses_volume", "Å³", "enclosed volume, positive also for cavities"}, c.ses_volume);
    visit({"sas_area", "Å²", "area of the pieces of the SAS that belong to it"}, c.sas_area);
    visit({"sas_volume", "Å³", "volume that they enclose, positive also for cavities"}, c.sas_volume);
    visit({"sas_components", "", "number of these pieces"}, c.sas_components);
    visit({"centre", "Å", "centroid of its surface, `[x, y, z]`"}, c.centre);
    visit({"inside_of", "", "place in this list of the component next outside; `null` if there is none"},
          c.inside_of == kNone ? std::optional<std::uint32_t>() : c.inside_of);
    visit({"atoms", "", "atoms that touch it, as indices of kept atoms"}, c.atoms);
    visit({"inscribed_centre", "Å",
           "centre of the largest sphere found in a cavity that touches no atom; `null` for outer pieces"},
          is_cavity ? std::optional(c.inscribed_centre) : std::nullopt);
    visit({"inscribed_radius", "Å", "its radius; `null` for outer pieces"},
          is_cavity ? std::optional(c.inscribed_radius) : std::nullopt);
    visit.block({"errors", "",
                 "absolute error of each of its areas and volumes by its key, estimated from independent evaluations"},
                [&](auto& inner) { describe(c.errors, inner); });
}

template <class Visitor>
void describe(const Interface& i, Visitor& visit) {
    visit({"sas_a", "Å²", "SAS area of the first group alone"}, i.sas_a);
    visit({"sas_b", "Å²", "SAS area of the second group alone"}, i.sas_b);
    visit({"sas_ab", "Å²", "SAS area of both together"}, i.sas_ab);
    visit({"buried_sas", "Å²", "`sas_a` + `sas_b` - `sas_ab`: both sides"}, i.buried_sas());
    visit({"interface_area", "Å²", "half of `buried_sas`, as usually quoted"}, i.interface_area());
    visit({"ses_a", "Å²", "SES area of the first group alone"}, i.ses_a);
    visit({"ses_b", "Å²", "SES area of the second group alone"}, i.ses_b);
    visit({"ses_ab", "Å²", "SES area of both together"}, i.ses_ab);
    visit({"buried_ses", "Å²", "`ses_a` + `ses_b` - `ses_ab`; may be negative"}, i.buried_ses());
    visit.block({"errors", "", "absolute errors of the buried areas, estimated from independent evaluations"},
                [&](auto& inner) {
                    inner({"buried_sas", "Å²", "error of `buried_sas`"}, i.sas_error);
                    inner({"interface_area", "Å²", "error of `interface_area`"}, 0.5 * i.sas_error);
                    inner({"buried_ses", "Å²", "error of `buried_ses`"}, i.ses_error);
                });
}

template <class Visitor>
void describe(const Percentiles& p, const char* unit, Visitor& visit) {
    visit({"min", unit, "least"}, p.min);
    visit({"p5", unit, "5th percentile"}, p.p5);
    visit({"p50", unit, "median"}, p.p50);
    visit({"p95", unit, "95th percentile"}, p.p95);
    visit({"max", unit, "largest"}, p.max);
}

template <class Visitor>
void describe(const MeshQuality& q, Visitor& visit) {
    visit({"angle_histogram", "", "number of corners with angles of 0 to 10°, 10 to 20° ... 170 to 180°"}, q.angles);
    visit.block({"smallest_angles_deg", "", "smallest angle of each triangle"},
                [&](auto& inner) { describe(q.smallest_angles, "°", inner); });
    visit.block({"edges", "", "lengths of edges"}, [&](auto& inner) { describe(q.edges, "Å", inner); });
    visit.block({"aspect_ratios", "",
                 "circumradius over twice the inradius of each triangle: 1 for an equilateral one, else more"},
                [&](auto& inner) { describe(q.aspect_ratios, "", inner); });
}

template <class Visitor>
void describe(const DistanceSummary& d, Visitor& visit) {
    visit({"mean", "Å", "mean"}, d.mean);
    visit({"p99", "Å", "99th percentile"}, d.p99);
    visit({"max", "Å", "largest"}, d.max);
}

template <class Visitor>
void describe(const TwoSidedDistance& d, Visitor& visit) {
    visit.block({"to_exact", "", "from the mesh to the exact SES"}, [&](auto& inner) { describe(d.to_exact, inner); });
    visit.block({"from_exact", "", "from the exact SES to the mesh"},
                [&](auto& inner) { describe(d.from_exact, inner); });
}

/// The mesh of a surface.
///
/// exact   measures of the exact surface, for the deviations from it; nullptr: deviations are NaN, written as null
template <class Visitor>
void describe_mesh(const Surface& s, const Measures* exact, Visitor& visit) {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    const MeshMeasures& m = s.measures;
    const SurfaceTotals kept = exact != nullptr ? exact_counterpart(*exact, s.options)
                                                : SurfaceTotals{.ses_area = kUnknown, .ses_volume = kUnknown};
    const auto deviation = [](double value, double of) { return (value - of) / std::abs(of); };
    visit({"vertices", "", "number of vertices"}, s.mesh.vertices.size());
    visit({"triangles", "", "number of triangles"}, s.mesh.triangles.size());
    visit({"area", "Å²", "plain sum over flat triangles"}, m.area);
    visit({"volume", "Å³", "plain sum over flat triangles; cavities count negative"}, m.volume);
    visit({"corrected_area", "Å²", "area, corrected for the curvature within each triangle"}, s.corrected_area);
    visit({"corrected_volume", "Å³", "volume, corrected for the curvature within each triangle"}, s.corrected_volume);
    visit({"area_deviation", "",
           "(`area` - exact) / exact, where exact is that of the pieces that the mesh keeps; `null` without exact "
           "measures"},
          deviation(m.area, kept.ses_area));
    visit({"volume_deviation", "", "the same of `volume`"}, deviation(m.volume, kept.ses_volume));
    visit({"corrected_area_deviation", "", "the same of `corrected_area`"}, deviation(s.corrected_area, kept.ses_area));
    visit({"corrected_volume_deviation", "", "the same of `corrected_volume`"},
          deviation(s.corrected_volume, kept.ses_volume));
    visit({"closed", "", "every edge has two triangles that run along it in opposite directions"}, m.closed);
    visit({"manifold", "", "no edge or vertex where more than one sheet meets"}, m.manifold);
    visit({"components", "", "number of connected pieces, walls of cavities included"}, m.components.size());
    visit({"euler_characteristic", "", "vertices - edges + triangles: 2 per sphere-like piece, 2 less per tunnel"},
          m.euler_characteristic);
    visit.block({"dropped", "", "pieces left out by the least volume of cavities"}, [&](auto& inner) {
        inner({"cavities", "", "number of cavities left out"}, s.dropped.cavities);
        inner({"islands", "", "number of outer pieces within them"}, s.dropped.islands);
    });
    visit.block({"filled", "", "cavities that were filled"}, [&](auto& inner) {
        inner({"cavities", "", "number of cavities filled"}, s.filled.cavities);
        inner({"islands", "", "number of outer pieces within them"}, s.filled.islands);
        inner({"volume", "Å³", "the space that therefore counts as inside in volumes"}, s.filled.volume);
    });
    visit.block({"simplified", "", "what simplifying the topology of even triangles has changed"}, [&](auto& inner) {
        inner({"handles", "", "number of handles cut and tunnels closed"}, s.simplified.handles);
        inner({"pieces", "", "number of pieces dropped"}, s.simplified.pieces);
    });
    visit({"mean_distance", "Å", "mean distance of the vertices from the exact SES"}, s.distance.mean);
    visit({"p99_distance", "Å", "99th percentile of that distance"}, s.distance.p99);
    visit({"max_distance", "Å", "largest such distance"}, s.distance.max);
    visit({"smallest_triangle_angle_deg", "°", "smallest angle of any triangle"}, m.smallest_angle_deg);
    visit.optional_block({"quality", "", "shapes of the triangles"}, s.quality,
                         [&](auto& inner, const MeshQuality& quality) {
                             describe(quality, inner);
                             inner({"self_intersections", "",
                                    "number of places where the mesh passes through itself; `null` if not verified"},
                                   s.self_intersections);
                         });
    visit.optional_block({"two_sided_distance", "",
                          "distances between mesh and exact SES, measured between vertices as well, weighted by area; "
                          "`null` unless asked for, as for even triangles"},
                         s.two_sided, [](auto& inner, const TwoSidedDistance& distance) { describe(distance, inner); });
}

template <class Visitor>
void describe(const FlowStep& s, Visitor& visit) {
    visit({"step", "", "number of the step; 0 is the start"}, s.step);
    visit({"time", "Å²", "time of the flow"}, s.time);
    visit({"area", "Å²", "area of the surface after that step"}, s.area);
    visit({"volume", "Å³", "its volume"}, s.volume);
    visit({"mean_distance", "Å", "mean distance of its vertices from the exact SES"}, s.mean_distance);
    visit({"max_distance", "Å", "largest such distance"}, s.max_distance);
    visit({"residual", "Å⁻¹", "mean change per unit time near the surface"}, s.residual);
    visit({"solver_iterations", "", "iterations of the linear solver"}, s.solver_iterations);
    visit({"components", "", "number of connected pieces"}, s.components);
    visit({"genus", "", "number of handles"}, s.genus);
}

/// How the flow of a surface went; without meaning for methods other than Method::Flow.
template <class Visitor>
void describe_flow(const Surface& s, Visitor& visit) {
    const FlowSummary& f = s.flow;
    visit({"steps", "", "number of steps"}, f.steps);
    visit({"time", "Å²", "their time"}, f.time);
    visit({"converged", "", "whether the flow came to rest"}, f.converged);
    visit({"residual", "Å⁻¹", "mean change per unit time near the surface at the last step"}, f.residual);
    visit({"mean_distance", "Å", "mean distance of the zero set from the exact SES"}, f.mean_distance);
    visit({"max_distance", "Å", "largest such distance"}, f.max_distance);
    visit({"solver_iterations", "", "iterations of the linear solver, over all steps"}, f.solver_iterations);
    visit({"initial_area", "Å²",
           "area of the zero set of the Gaussian map, where flows that run in time start; `null` if not measured"},
          s.options.initial_area ? std::optional(f.initial_area) : std::nullopt);
    visit({"reinitialisations", "", "number of reinitialisations"}, f.reinitialisations);
    visit({"end", "", "`converged`, `steps-used-up`, `stalled`, `vanished` or `left-band`"}, f.end, kFlowEndWords);
    visit(
        {"kept_step", "",
         "the step whose surface is the result: the last one; without an anchor, the one nearest to the exact surface"},
        f.kept_step);
    visit({"explanation", "", "why the flow did not converge and, without an anchor, how near it came"}, f.explanation);
    visit.list(
        {"history", "", "every step, the start first; empty unless a history was asked for or the flow has no anchor"},
        s.history, [](auto& inner, const FlowStep& step) { describe(step, inner); });
}

template <class Visitor>
void describe(const Check& c, Visitor& visit) {
    visit({"name", "", "name of the check"}, c.name);
    visit({"passed", "", "whether the check passed"}, c.passed);
    visit({"value", "", "the value found"}, c.value);
    visit({"bound", "", "the bound allowed"}, c.bound);
}

template <class Visitor>
void describe(const Cost& c, Visitor& visit) {
    visit({"vertices", "", "vertices of the grid's mesh"}, std::round(c.vertices));
    visit({"memory_mb", "MB", "peak memory of the process"}, c.memory_mb);
    visit({"cpu_s", "s", "processor time without reading and writing, on the machine of docs/benchmarks.md"},
          c.seconds);
}

template <class Visitor>
void describe(const ComparedSurface& s, Visitor& visit) {
    visit({"area", "Å²", "exact for a structure, sum over the triangles for a mesh"}, s.area);
    visit({"volume", "Å³", "exact for a structure, sum over the triangles for a mesh"}, s.volume);
    visit({"outer_pieces", "", "number of connected closed pieces whose normals point outwards"}, s.outer_pieces);
    visit({"cavities", "", "number of those whose normals point inwards"}, s.cavities);
    visit({"closed", "", "every edge has two triangles that run along it in opposite directions"}, s.closed);
    visit({"manifold", "", "no edge has more than two triangles, and the triangles around every vertex are connected"},
          s.manifold);
}

template <class Visitor>
void describe(const OneWayDistance& d, Visitor& visit) {
    visit({"mean", "Å", "mean"}, d.mean);
    visit({"p99", "Å", "distance within which 99 % of the area lies"}, d.p99);
    visit({"max", "Å", "maximum, vertices included"}, d.max);
    visit({"signed_mean", "Å", "mean with a sign: positive where the points lie outside the other surface"},
          d.signed_mean);
    visit({"points", "", "number of points, without the vertices"}, d.points);
}

}  // namespace meniscus
