// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The one call: atoms and options in, a solvent-excluded surface that remembers its options out.
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

enum class Method {
    Flow,      ///< the level-set flow: a smooth function whose zero set is the surface
    Direct,    ///< marching cubes of the exact surface, all vertices on it: sharp ridges
    Gaussian,  ///< only the Gaussian density envelope that the flow starts from; not the SES
};

/// Which closed pieces of the surface the mesh keeps.
enum class Pieces { All, Outer, Cavities };

/// Everything that decides the result. Lengths in Å.
struct SurfaceOptions {
    Method method = Method::Flow;
    SurfaceKind surface = SurfaceKind::Ses;  ///< of Method::Gaussian always this one
    double probe = 1.4;                      ///< probe radius; 0 gives the van der Waals surface
    double spacing = 0.5;                    ///< grid spacing
    double density = -0.5;                   ///< constant C of the initial Gaussian map, Å^-2, negative
    FlowOptions flow{};                      ///< which evolution Method::Flow runs
    bool history = false;                    ///< keep a record of every step of the flow
    bool initial_area = false;               ///< measure the Gaussian start, too, where the flow can do without
    bool quality = false;                    ///< look at the shapes of the triangles, too
    bool two_sided_distance = false;  ///< measure how far mesh and exact SES are from each other between vertices, too
    bool exact = false;               ///< measure areas, volumes and pieces exactly, too: Surface::measured
    bool verify = false;              ///< make the expensive self-checks, too: see Surface::checks
    Pieces pieces = Pieces::All;      ///< what the mesh keeps
    double min_cavity = 0.0;          ///< Å³: cavities that enclose less are dropped, with all that lies in them
    double fill_cavities = 0.0;       ///< Å³: the same, and their space counts as inside in fields (field.h)
    RemeshOptions remesh{};           ///< even triangles of a chosen size; needs a spacing of at most 0.5 Å
};

/// What a computation may use, and who watches it. The result does not depend on it.
struct RunOptions {
    int threads = 0;                  ///< 0: all cores
    std::size_t memory_limit_mb = 0;  ///< 0: what the machine has available
    bool keep_exact = true;  ///< false: Surface::exact forgets what has been found, and finds it again if asked
    Progress progress{};
    FlowObserver observer{};  ///< sees every step of a flow; where there is one, steps cost a mesh each
};

/// One self-check: passed means value <= bound, or value == bound for counts.
struct Check {
    std::string name;
    bool passed = false;
    double value = 0.0;
    double bound = 0.0;
};

/// What RemeshOptions::simplify_topology has changed.
struct SimplifiedTopology {
    std::size_t handles = 0;  ///< cut; tunnels closed among them
    std::size_t pieces = 0;   ///< vanished
};

/// Wall-clock seconds per stage.
struct StageTimes {
    double estimate = 0.0;  ///< of what the computation will take
    double geometry = 0.0;
    double exact = 0.0;  ///< of the exact measures that the result is held against, or that were asked for
    double band = 0.0;
    double flow = 0.0;
    double mesh = 0.0;
};

/// A computed surface.
struct Surface {
    ExactSurface exact;  ///< that it is a mesh of
    SurfaceOptions options;
    Mesh mesh;
    MeshMeasures measures;
    double corrected_area = 0.0;                    ///< Å², curvature-corrected quadrature over the mesh
    double corrected_volume = 0.0;                  ///< Å³
    std::shared_ptr<const Measures> measured;       ///< of the exact surface, if asked for (SurfaceOptions::exact)
    DistanceSummary distance;                       ///< of the mesh's vertices to the exact SES
    std::optional<MeshQuality> quality;             ///< if asked for
    std::optional<TwoSidedDistance> two_sided;      ///< if asked for
    DroppedPieces dropped;                          ///< too small for the mesh
    FilledCavities filled;                          ///< by SurfaceOptions::fill_cavities
    SimplifiedTopology simplified;                  ///< by making triangles even
    std::optional<std::size_t> self_intersections;  ///< pairs of triangles that pass through each other, if verified
    FlowSummary flow;                               ///< zero for Method::Direct and Method::Gaussian
    std::vector<FlowStep> history;                  ///< if asked for, and always for a flow without an anchor
    std::shared_ptr<const LevelSet> level_set;      ///< absent for Method::Direct
    /// What the result was held against: "not_empty", "closed", "manifold", "converged" (of a flow), "mean_distance",
    /// "volume" (against the exact one) and "pieces" (the right side of the surface in every exact piece with an
    /// inscribed radius above 1.5 spacings); if verified also "sides" (of scattered points) and
    /// "no_self_intersections". Method::Gaussian has nothing exact to be held against.
    std::vector<Check> checks;
    Cost expected;  ///< before the computation started
    StageTimes seconds;

    bool passed() const;  ///< every check passed
};

/// Computes a mesh of an exact surface, by SurfaceOptions::method. The options' surface and probe do not matter: those
/// of the exact surface hold, and are Surface::options'.
///
/// throws   UsageError for options out of range and for even triangles that the surface has no room for (its folds are
///          narrower than an edge all over), LimitError when it would not fit into memory or lies too far from the
///          origin for the spacing; as ExactSurface::accessible()
/// cost     linear in the number of atoms; memory proportional to area / spacing²
/// source   Pan & Tai 2009, with the anchored flow of docs/design/flow.md
Surface mesh(ExactSurface exact, const SurfaceOptions& options = {}, const RunOptions& run = {});

/// The same of atoms: of ExactSurface(atoms, {options.surface, options.probe}).
Surface compute_surface(const Atoms& atoms, const SurfaceOptions& options = {}, const RunOptions& run = {});

/// Exact area and volume of those pieces that a mesh of these options keeps; in the volume cavities count negative.
///
/// exact   measures of the exact surface
SurfaceTotals exact_counterpart(const Measures& exact, const SurfaceOptions& options);

/// Closed pieces by kind.
struct PieceCounts {
    std::size_t outer = 0;
    std::size_t cavities = 0;

    std::size_t all() const { return outer + cavities; }
    bool operator==(const PieceCounts&) const = default;
};

/// All pieces of the exact surface.
PieceCounts count_pieces(const Measures& exact);

/// The pieces of a mesh.
PieceCounts count_pieces(const MeshMeasures& mesh);

/// Those pieces of the exact surface that a mesh of these options keeps. Where the mesh has other numbers, features
/// smaller than its grid came out joined or separate.
///
/// exact   measures of the exact surface
PieceCounts count_kept_pieces(const Measures& exact, const SurfaceOptions& options);

/// Whether the independent evaluations of exact measures agree: value and bound are 1 where they do.
inline Check agreement_check(const Measures& measured) {
    return {"exact_agreement", measured.agreed, measured.agreed ? 1.0 : 0.0, 1.0};
}

/// Whether the areas of atoms, and areas and volumes of components, sum to the totals: the largest difference,
/// relative.
Check sums_check(const Measures& measured);

}  // namespace meniscus
