// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Every option of a surface, described once. A visitor is called for each option in turn as
//
//   visit(option, member)          a number, a flag, or an amount of memory (std::size_t, units of 2^20 bytes)
//   visit(option, member, words)   a choice
//   visit(option, flow, words)     a choice that sets all of FlowOptions; the options after it change single members
//   visit(option, member, of)      a number that of() converts into a member which also has an option of its own
//
// A new option needs a member of an options struct and a description here, from which the command line, Python,
// reports, .npz files and the manual take it.
#pragma once

#include <concepts>
#include <string>
#include <type_traits>

#include "meniscus/errors.h"
#include "meniscus/option.h"
#include "meniscus/surface.h"
#include "meniscus/words.h"

namespace meniscus {

/// T or const T, so that visitors can also read options that they cannot change.
template <class Given, class T>
concept MaybeConst = std::same_as<std::remove_const_t<Given>, T>;

inline constexpr Option kProbeOption{.name = "probe",
                                     .brief = "Probe radius, Å",
                                     .meaning = "Probe radius, Å; 0 gives the van der Waals surface",
                                     .example = "--probe 1.5",
                                     .symbol = "R",
                                     .range = NumberRange::NotNegative};
inline constexpr Option kThreadsOption{.name = "threads",
                                       .brief = "Number of threads",
                                       .meaning = "Number of threads; results do not depend on it",
                                       .example = "--threads 1",
                                       .symbol = "N",
                                       .range = NumberRange::NotNegative,
                                       .standard = "all cores"};

/// The options that say which surface, and how its mesh is made.
template <MaybeConst<SurfaceOptions> Options, class Visitor>
void describe_shape(Options& o, Visitor&& visit) {
    visit(kProbeOption, o.probe);
    visit(
        Option{.name = "method",
               .brief = "flow: smooth; direct: sharp ridges",
               .meaning = "`flow`: a smooth surface, the steady state of the anchored flow, found in one solve; twice "
                          "differentiable, with ridges rounded at the scale of the grid. `direct`: the exact "
                          "distance, with sharp ridges. `gaussian`: only the envelope of the Gaussian map, which is "
                          "not the solvent-excluded surface",
               .example = "--method direct"},
        o.method, kMethodWords);
    visit(Option{.name = "surface",
                 .meaning = "Which surface: solvent-excluded, solvent-accessible (traced by the centre of the probe), "
                            "or van der Waals (the same as `--probe 0`). With `--method flow` or `direct`",
                 .example = "--surface sas"},
          o.surface, kSurfaceWords);
    visit(Option{.name = "spacing",
                 .brief = "Grid spacing, Å",
                 .meaning = "Grid spacing, Å; time and memory grow as 1/H². With `--edge` and without `--spacing`, "
                            "small surfaces whose corrected area would be more than 0.5 % off are computed at 0.25 or "
                            "0.125 Å, unless their flow does not converge; summary and report say so",
                 .example = "--spacing 0.4",
                 .symbol = "H",
                 .range = NumberRange::Positive},
          o.spacing);
    visit(Option{.name = "components",
                 .brief = "Closed pieces that the mesh keeps",
                 .meaning = "Which closed pieces the mesh keeps "
                            "([pieces](../conventions.md#which-pieces-a-mesh-keeps))",
                 .example = "--components outer"},
          o.pieces, kPiecesWords);
    visit(Option{.name = "min_cavity",
                 .brief = "Drop cavities smaller than V Å³",
                 .meaning = "Drop cavities that enclose less than V Å³ and what lies in them; outer pieces stay",
                 .example = "--min-cavity 30",
                 .symbol = "V",
                 .range = NumberRange::NotNegative},
          o.min_cavity);
    visit(Option{.name = "fill_cavities",
                 .meaning = "Drop cavities that enclose less than V Å³, and count their space as inside in volumes "
                            "([filled](../conventions.md#which-pieces-a-mesh-keeps))",
                 .example = "--fill-cavities 30",
                 .symbol = "V",
                 .range = NumberRange::NotNegative},
          o.fill_cavities);
    visit(Option{.name = "density",
                 .meaning = "Constant of the Gaussian map, Å⁻², negative; for `--method gaussian`, and for flows that "
                            "start from the map (`--flow paper`, `--flow parallel` or a finite `--time-step`)",
                 .example = "--density -0.6",
                 .symbol = "C",
                 .range = NumberRange::Negative,
                 .effect = Effect::WithGaussianMap},
          o.density);
}

/// A piece of the flow, whose default is that of the flow chosen by name.
constexpr Option of_flow(Option option) {
    option.effect = Effect::WithFlow;
    option.standard = "of the flow";
    return option;
}

/// The options of the flow.
template <MaybeConst<FlowOptions> Options, class Visitor>
void describe(Options& o, Visitor&& visit) {
    visit(Option{.name = "flow",
                 .meaning = "Which flow; the options below modify it. Only `anchored` ends at the solvent-excluded "
                            "surface; `paper` is the flow of Pan and Tai",
                 .example = "--flow parallel",
                 .effect = Effect::WithFlow},
          o, kFlowWords);
    visit(of_flow({.name = "curvature",
                   .meaning = "The curvature field: `parallel`, or `paper` for `--flow paper`",
                   .example = "--curvature sharp"}),
          o.curvature, kCurvatureWords);
    visit(of_flow({.name = "anchor",
                   .meaning = "Strength of the anchor in units of 1/H²: 16 for `anchored`, else 0 (none)",
                   .example = "--anchor 8",
                   .symbol = "L",
                   .range = NumberRange::NotNegative}),
          o.anchor);
    visit(
        of_flow({.name = "reinitialise",
                 .meaning = "What makes the level set a signed distance again before each step: `none` for `anchored`, "
                            "`closest-point` for `parallel`, `paper` for `paper`",
                 .example = "--reinitialise godunov"}),
        o.reinitialiser, kReinitialiserWords);
    visit(of_flow({.name = "solver",
                   .meaning = "Solver of the linear systems: `richardson`, or `gmres` for `--flow paper`",
                   .example = "--solver cg"}),
          o.solver, kSolverWords);
    visit(of_flow({.name = "slope",
                   .meaning = "The factor \\|∇Φ\\| of the curvature: `unit`, or `computed` for `--flow paper`",
                   .example = "--slope computed"}),
          o.slope, kSlopeWords);
    visit(of_flow({.name = "time_step",
                   .meaning = "Time step in units of H²: `inf` (one solve) for `anchored`, else 1",
                   .example = "--time-step 1",
                   .symbol = "T",
                   .range = NumberRange::PositiveOrInfinite}),
          o.time_step);
    visit(
        of_flow({.name = "half_width",
                 .meaning = "Half-width of the band: unknowns are the nodes within K spacings of the surface; 3, or 4 "
                            "for `--flow paper`",
                 .example = "--half-width 4",
                 .symbol = "K",
                 .range = NumberRange::Positive}),
        o.half_width);
    visit(of_flow({.name = "max_steps",
                   .meaning = "Maximum number of steps: 30 for `anchored`, else 100",
                   .example = "--max-steps 50",
                   .symbol = "N",
                   .range = NumberRange::Positive}),
          o.max_steps);
    visit(of_flow({.name = "tolerance",
                   .meaning = "Stop when E spacings are left to go (`anchored`, 10⁻⁴), or when the speed is down to E "
                              "(else, 10⁻² Å⁻¹)",
                   .example = "--tolerance 0.001",
                   .symbol = "E",
                   .range = NumberRange::Positive}),
          o.tolerance);
}

/// The options of even triangles.
template <MaybeConst<RemeshOptions> Options, class Visitor>
void describe(Options& o, Visitor&& visit) {
    visit(Option{.name = "edge",
                 .brief = "Even triangles with edges of about L Å",
                 .meaning = "Even triangles with edges near L Å, instead of those of the grid, whose spacing is at "
                            "most 0.5 Å then; at least 97 % of the "
                            "edges are between 0.6 and 1.5 L. The topology stays that of the grid's mesh. A surface "
                            "with folds narrower than L all over (van der Waals surfaces with 2 Å, envelopes of "
                            "`gaussian`) is refused: choose a smaller L",
                 .example = "--edge 1",
                 .symbol = "L",
                 .range = NumberRange::Positive,
                 .effect = Effect::WithEdge},
          o.edge);
    visit(Option{.name = "vertex_density",
                 .meaning = "The same as `--edge`, given as vertices per Å²; use only one of the two",
                 .example = "--vertex-density 2",
                 .symbol = "D",
                 .range = NumberRange::Positive},
          o.edge, &edge_of_density);
    visit(Option{.name = "adaptive",
                 .brief = "With --edge: finer where curvature is high",
                 .meaning = "With `--edge`: shorter edges where the surface bends more",
                 .example = "--edge 1 --adaptive",
                 .effect = Effect::WithEdge},
          o.adaptive);
    visit(Option{.name = "keep_ridges",
                 .brief = "With --edge: edges follow the creases",
                 .meaning = "With `--edge`: edges run along the creases of the surface",
                 .example = "--edge 1 --keep-ridges",
                 .effect = Effect::WithEdge},
          o.keep_ridges);
    visit(Option{.name = "corners",
                 .meaning = "With `--edge`: where vertices lie. `near`: as near to the surface as keeps the triangles "
                            "within 0.03 L² Å of it on average (with 1 Å on molecules, vertices are 0.01 Å off on "
                            "average), or `balanced` where nothing else is near enough. `on-surface`: on the surface, "
                            "wherever the triangles then are (0.037 Å off with 1 Å); with `--keep-ridges` or "
                            "`--method gaussian`, `near` means this. `balanced`: so that the triangles lie on both "
                            "sides of the surface (0.019 Å off; vertices 0.03 Å off)",
                 .example = "--edge 1 --corners on-surface",
                 .effect = Effect::WithEdge},
          o.corners, kCornersWords);
    visit(Option{.name = "simplify_topology",
                 .meaning = "With `--edge`: cut handles, close tunnels and drop pieces narrower than an edge",
                 .example = "--edge 1 --simplify-topology",
                 .effect = Effect::WithEdge},
          o.simplify_topology);
}

/// The options that ask for results beside the mesh. The command line sets them as its outputs need them.
template <MaybeConst<SurfaceOptions> Options, class Visitor>
void describe_findings(Options& o, Visitor&& visit) {
    visit(Option{.name = "history",
                 .meaning = "Keep a record of every step of the flow",
                 .example = "",
                 .effect = Effect::WithFlow},
          o.history);
    visit(Option{.name = "initial_area",
                 .meaning = "Measure the area of the Gaussian map, too, where the flow can do without it"},
          o.initial_area);
    visit(Option{.name = "quality", .meaning = "Also find the angles, edges and aspect ratios of the triangles"},
          o.quality);
    visit(Option{.name = "two_sided_distance",
                 .meaning = "Measure how far mesh and exact surface are from each other between vertices, too"},
          o.two_sided_distance);
}

/// The options of self-checks.
template <MaybeConst<SurfaceOptions> Options, class Visitor>
void describe_checks(Options& o, Visitor&& visit) {
    visit(Option{.name = "verify",
                 .brief = "Run the expensive self-checks, too",
                 .meaning = "Also make the expensive self-checks: the mesh nowhere passes through itself, 20,000 "
                            "points are on the correct side, the exact measures are evaluated twice; exit code 6 if "
                            "one fails ([checks](report.md#checks))",
                 .example = "--verify"},
          o.verify);
}

/// The options of what a computation may use.
template <MaybeConst<RunOptions> Options, class Visitor>
void describe(Options& o, Visitor&& visit) {
    visit(kThreadsOption, o.threads);
    visit(Option{.name = "memory",
                 .brief = "Refuse what would need more, as 4G or 500M",
                 .meaning = "Refuse, before it starts, a run that would need more (exit code 5), in M or G; by "
                            "default, the limit is the free memory of the machine",
                 .example = "--memory 4G",
                 .symbol = "LIMIT",
                 .standard = ""},
          o.memory_limit_mb);
}

/// The options of measures without a mesh.
template <MaybeConst<MeasureOptions> Options, class Visitor>
void describe(Options& o, Visitor&& visit) {
    visit(kProbeOption, o.probe);
    visit(Option{.name = "cavities", .meaning = "Also find which component encloses which, and inscribed spheres"},
          o.cavities);
    visit(Option{.name = "depth", .meaning = "Also measure the depth of every atom"}, o.depth);
    visit(kThreadsOption, o.threads);
}

/// All options of a surface.
template <MaybeConst<SurfaceOptions> Options, class Visitor>
void describe(Options& o, Visitor&& visit) {
    describe_shape(o, visit);
    describe(o.flow, visit);
    describe(o.remesh, visit);
    describe_findings(o, visit);
    describe_checks(o, visit);
}

/// Whether an option has an effect together with the given other options.
inline bool has_effect(const Option& option, const SurfaceOptions& others) {
    switch (option.effect) {
        case Effect::WithFlow:
            return others.method == Method::Flow;
        case Effect::WithGaussianMap:
            return others.method != Method::Direct;
        case Effect::WithEdge:
            return others.remesh.is_on();
        case Effect::Always:
            break;
    }
    return true;
}

/// Refuses an option that was given but has no effect together with the others.
///
/// throws   UsageError that says what the option needs, in the spelling of the client
void refuse_without_effect(const Option& option, const SurfaceOptions& others, OptionSpelling spelling);

}  // namespace meniscus
