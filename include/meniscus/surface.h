// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// From atoms and options to the mesh of a molecular surface, with measures and checks, in one call.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "meniscus/atoms.h"
#include "meniscus/cavities.h"
#include "meniscus/cost.h"
#include "meniscus/exact_surface.h"
#include "meniscus/flow.h"
#include "meniscus/level_set.h"
#include "meniscus/measures.h"
#include "meniscus/mesh.h"
#include "meniscus/mesh_quality.h"
#include "meniscus/progress.h"
#include "meniscus/remesh.h"

namespace meniscus {

/// How the mesh of a surface is computed.
enum class Method {
    Flow,      ///< the level-set flow: a smooth function whose zero set is the surface
    Direct,    ///< marching cubes of the exact surface, all vertices on it: sharp ridges
    Gaussian,  ///< only the envelope of the Gaussian density map; not the SES
};

/// Which closed pieces of the surface the mesh keeps: all, only outer pieces, or only walls of cavities.
enum class Pieces { All, Outer, Cavities };

/// Everything that decides the result. Lengths in Å.
struct SurfaceOptions {
    Method method = Method::Flow;
    SurfaceKind surface = SurfaceKind::Ses;  ///< Method::Gaussian allows no other
    double probe = 1.4;                      ///< probe radius; 0 gives the van der Waals surface
    double spacing = 0.5;                    ///< grid spacing
    double density = -0.5;                   ///< constant C of the initial Gaussian map, Å^-2, negative
    FlowOptions flow{};                      ///< the flow of Method::Flow
    bool history = false;                    ///< keep a record of every step of the flow
    bool initial_area = false;               ///< find FlowSummary::initial_area
    bool quality = false;                    ///< find Surface::quality: the shapes of the triangles
    bool two_sided_distance = false;         ///< find Surface::two_sided: distances between mesh and exact SES
    bool exact = false;                      ///< find Surface::measured: areas, volumes and pieces of the exact surface
    bool verify = false;                     ///< run the expensive self-checks, too: see Surface::checks
    Pieces pieces = Pieces::All;             ///< which pieces the mesh keeps
    double min_cavity = 0.0;     ///< Å³; cavities that enclose less are dropped, with all that lies in them
    double fill_cavities = 0.0;  ///< Å³; smaller cavities are dropped, and count as inside in fields (field.h)
    RemeshOptions remesh{};      ///< even triangles of a chosen size; needs a spacing of at most 0.5 Å
};

/// What a computation may use, and what is called while it runs. The result does not depend on these options.
struct RunOptions {
    int threads = 0;                  ///< 0: all cores
    std::size_t memory_limit_mb = 0;  ///< in units of 2^20 bytes; 0: what the machine has available
    bool keep_exact = true;  ///< false: Surface::exact frees its memory, and computes again what is asked of it
    Progress progress{};
    FlowObserver observer{};  ///< called after every step of a flow, for which each step also makes a mesh
};

/// One self-check. It passes if value <= bound, or, where the value is a count or 1 for yes, if value == bound.
struct Check {
    std::string name;
    bool passed = false;
    double value = 0.0;
    double bound = 0.0;
};

/// What RemeshOptions::simplify_topology has changed.
struct SimplifiedTopology {
    std::size_t handles = 0;  ///< number of handles cut and tunnels closed
    std::size_t pieces = 0;   ///< number of pieces dropped
};

/// Wall-clock seconds per stage.
struct StageTimes {
    double estimate = 0.0;  ///< estimating Surface::expected
    double geometry = 0.0;
    double exact = 0.0;  ///< the exact measures, for the checks or Surface::measured
    double band = 0.0;
    double flow = 0.0;
    double mesh = 0.0;
};

/// A computed surface.
struct Surface {
    ExactSurface exact;  ///< the surface that the mesh approximates
    SurfaceOptions options;
    Mesh mesh;
    MeshMeasures measures;
    double corrected_area = 0.0;                    ///< Å², curvature-corrected quadrature over the mesh
    double corrected_volume = 0.0;                  ///< Å³, corrected likewise
    std::shared_ptr<const Measures> measured;       ///< measures of the exact surface, if SurfaceOptions::exact
    DistanceSummary distance;                       ///< distance of the vertices from the exact SES
    std::optional<MeshQuality> quality;             ///< shapes of triangles, if SurfaceOptions::quality
    std::optional<TwoSidedDistance> two_sided;      ///< if SurfaceOptions::two_sided_distance
    DroppedPieces dropped;                          ///< what SurfaceOptions::min_cavity dropped
    FilledCavities filled;                          ///< what SurfaceOptions::fill_cavities filled
    SimplifiedTopology simplified;                  ///< what RemeshOptions::simplify_topology changed
    std::optional<std::size_t> self_intersections;  ///< pairs of triangles that intersect, if verified
    FlowSummary flow;                               ///< zero for Method::Direct and Method::Gaussian
    std::vector<FlowStep> history;                  ///< steps, if SurfaceOptions::history or without an anchor
    std::shared_ptr<const LevelSet> level_set;      ///< absent for Method::Direct
    /// Self-checks: "not_empty", "closed", "manifold", "converged" (of a flow), "mean_distance" (from the exact SES),
    /// "volume" (compared with the exact volume) and "pieces" (every exact piece with an inscribed radius above 1.5
    /// spacings is on the right side of the mesh); with SurfaceOptions::verify also "sides" (scattered points are on
    /// the right side) and "no_self_intersections". Method::Gaussian is not compared with anything exact.
    std::vector<Check> checks;
    Cost expected;  ///< as estimated before the computation
    StageTimes seconds;

    bool passed() const;  ///< whether every check passed
};

/// Computes a mesh of an exact surface, by SurfaceOptions::method. Surface kind and probe radius are those of the exact
/// surface, whatever the options say; Surface::options has them.
///
/// throws   UsageError for options out of range, and for RemeshOptions::edge if the folds of the surface are narrower
///          than an edge all over; LimitError for a computation that would not fit into memory, or atoms too far from
///          the origin for the spacing; and whatever ExactSurface::accessible() throws
/// cost     linear in the number of atoms; memory proportional to area / spacing²
/// source   Pan & Tai 2009, with the anchored flow of docs/design/flow.md
Surface mesh(ExactSurface exact, const SurfaceOptions& options = {}, const RunOptions& run = {});

/// Computes a mesh of ExactSurface(atoms, {options.surface, options.probe}), as mesh() does.
Surface compute_surface(const Atoms& atoms, const SurfaceOptions& options = {}, const RunOptions& run = {});

/// Exact area and volume of those pieces that a mesh with the given options keeps; cavities count negative in volumes.
///
/// exact   measures of the exact surface
SurfaceTotals exact_counterpart(const Measures& exact, const SurfaceOptions& options);

/// Numbers of closed pieces, by kind.
struct PieceCounts {
    std::size_t outer = 0;
    std::size_t cavities = 0;

    std::size_t all() const { return outer + cavities; }
    bool operator==(const PieceCounts&) const = default;
};

/// Counts all pieces of an exact surface.
PieceCounts count_pieces(const Measures& exact);

/// Counts the pieces of a mesh.
PieceCounts count_pieces(const MeshMeasures& mesh);

/// Counts those pieces of an exact surface that a mesh with the given options keeps. If the mesh has other numbers,
/// features narrower than a grid spacing were joined or cut.
///
/// exact   measures of the exact surface
PieceCounts count_kept_pieces(const Measures& exact, const SurfaceOptions& options);

/// Checks that independent evaluations of the exact measures agree: the value is 1 if so, else 0; the bound is 1.
inline Check agreement_check(const Measures& measured) {
    return {"exact_agreement", measured.agreed, measured.agreed ? 1.0 : 0.0, 1.0};
}

/// Checks that the areas of atoms, and the areas and volumes of components, sum to the totals: the value is the largest
/// relative difference.
Check sums_check(const Measures& measured);

}  // namespace meniscus
