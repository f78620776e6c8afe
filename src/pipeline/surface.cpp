// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/surface.h"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "band/distance_band.h"
#include "band/sides.h"
#include "band/surface_blocks.h"
#include "cavities/choose_pieces.h"
#include "core/parallel.h"
#include "flow/evolution.h"
#include "flow/gaussian_density.h"
#include "measure/surface_measures.h"
#include "meniscus/accessible_surface.h"
#include "meniscus/errors.h"
#include "meniscus/threads.h"
#include "mesh/extract.h"
#include "pipeline/band_size.h"
#include "pipeline/checks.h"
#include "pipeline/even_mesh.h"
#include "pipeline/flow_stage.h"
#include "pipeline/self_checks.h"
#include "pipeline/surface_mesh.h"
#include "pipeline/yardstick.h"
#include "project/move_corners.h"
#include "project/surface_projector.h"
#include "remesh/self_intersections.h"

namespace meniscus {
namespace {

// The grid starts here, in spacings: fractions without meaning, so that atoms at round coordinates with round
// radii do not put the surface, or planes of symmetry, exactly onto nodes.
constexpr Vec3 kGridShift{0.3819660, 0.2360680, 0.1458980};

constexpr double kFinest = 1e-6;  // Å, of grids: no structure's coordinates are finer

constexpr double kWidestBand = 16.0;  // spacings

// Even meshes: areas farther from the exact one than this part of it ask for a finer grid, as long as the surface
// covers no more of its squares than that.
constexpr double kWantedArea = 0.005;
constexpr double kMostForFiner = 1.5e5;
constexpr int kFinerGrids = 2;

class StageClock {
public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double seconds = std::chrono::duration<double>(now - last_).count();
        last_ = now;
        return seconds;
    }

private:
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

void check_flow(const FlowOptions& flow) {
    require(std::isfinite(flow.anchor) && flow.anchor >= 0.0, "anchor", flow.anchor, "finite and not negative");
    require(flow.time_step > 0.0, "time step", flow.time_step, "positive");
    require(std::isfinite(flow.time_step) || flow.anchor > 0.0, "time step", flow.time_step,
            "finite without an anchor");
    require(flow.half_width >= 2.0 && flow.half_width <= kWidestBand, "half width", flow.half_width,
            fmt::format("from 2 to {:g}", kWidestBand));
    require_positive("tolerance", flow.tolerance);
    require(flow.max_steps >= 1, "max steps", flow.max_steps, "at least 1");
}

void check_options(const SurfaceOptions& options) {
    require(std::isfinite(options.probe) && options.probe >= 0.0, "probe", options.probe, "finite and not negative");
    if (options.method == Method::Gaussian && options.surface != SurfaceKind::Ses)
        throw UsageError(
            "method gaussian gives a single envelope of the atoms; for surface sas or vdw use method flow or direct");
    require_positive("spacing", options.spacing);
    require(options.spacing >= kFinest, "spacing", options.spacing, "at least 1e-6");
    require(is_positive(-options.density), "density", options.density, "finite and negative");
    if (options.method == Method::Flow) check_flow(options.flow);
    const RemeshOptions& remesh = options.remesh;
    require(remesh.edge == 0.0 || is_positive(remesh.edge), "edge", remesh.edge, "finite and positive");
    require(!remesh.is_on() || options.spacing <= kCoarsestForRemeshing, "spacing", options.spacing,
            fmt::format("at most {:g} for a mesh of even triangles", kCoarsestForRemeshing));
    require(remesh.corners == Corners::Near || remesh.is_on(), "edge", remesh.edge,
            "positive with any corners but near");
    require(!remesh.simplify_topology || remesh.is_on(), "edge", remesh.edge, "positive with simplify_topology");
    require(std::isfinite(options.min_cavity) && options.min_cavity >= 0.0, "min cavity", options.min_cavity,
            "finite and not negative");
    require(std::isfinite(options.fill_cavities) && options.fill_cavities >= 0.0, "fill cavities",
            options.fill_cavities, "finite and not negative");
    check_threads(options.threads);
}

// What the methods hand on to meshing.
struct Field {
    std::shared_ptr<const BlockGrid> grid;
    NodeField values;                           // at the nodes, negative inside
    std::shared_ptr<const LevelSet> level_set;  // of the same
    std::vector<InsideBits> inside;             // of the exact distance, in the place of both
};

// One computation in progress: the stages, in the order in which they run.
class Pipeline {
public:
    Pipeline(const Atoms& atoms, const SurfaceOptions& options, const Progress& progress, const FlowObserver& observer,
             const ExactSurface* exact, const Cost& expected)
        : atoms_(atoms), options_(options), progress_(progress), observer_(observer), exact_(exact) {
        options_.remesh.corners = corners_of(options);
        surface_.expected = expected;
        if (exact != nullptr) surface_.seconds = exact->seconds;
        report("geometry", 0.0);
        const SesProblem problem = ses_problem(atoms, options);
        if (exact == nullptr) own_ = std::make_unique<AccessibleSurface>(problem.atoms, problem.probe);
        accessible_ = exact != nullptr ? &exact->accessible : own_.get();
        surface_.seconds.geometry += clock_.lap();
        report("geometry", 1.0);
        if (options_.exact) measure_exactly(problem);
        choose_yardstick(problem);
        if (own_ != nullptr && !may_be_measured_again()) own_->forget_contours();
    }

    Surface run() {
        compute();
        for (int i = 0; i < kFinerGrids && wants_finer_grid() && refine_grid(); ++i) compute();
        surface_.exact = std::move(measured_);
        return std::move(surface_);
    }

private:
    bool may_be_measured_again() const { return options_.remesh.is_on() || options_.two_sided_distance; }

    // Comes before the grid, which then takes the memory that this needs. Patches would keep much of it.
    void measure_exactly(const SesProblem& problem) {
        report("exact", 0.0);
        measured_ = exact_ != nullptr ? exact_->measures : meniscus::measure(*accessible_, problem.atoms);
        std::vector<PatchMeasure>().swap(measured_->patches);
        surface_.seconds.exact += clock_.lap();
        report("exact", 1.0);
    }

    // What is known of all pieces, if anything.
    const Measures* measures() const {
        if (exact_ != nullptr) return &exact_->measures;
        return measured_ ? &*measured_ : nullptr;
    }

    // Nothing exact says what the Gaussian envelope should be.
    void choose_yardstick(const SesProblem& problem) {
        if (options_.method == Method::Gaussian) return;
        yardstick_ = measures() != nullptr ? yardstick_of(*measures(), problem.atoms, options_)
                                           : make_yardstick(*accessible_, problem.atoms, options_);
        surface_.seconds.exact += clock_.lap();
    }

    void compute() {
        surface_.options = options_;
        margin_ = band_margin(options_);
        make_mesh(make_field());
        if (own_ != nullptr && !may_be_measured_again()) {  // the areas of vertices take its memory
            own_.reset();
            accessible_ = nullptr;
        }
        surface_.seconds.mesh += clock_.lap();
        report("mesh", 1.0);
        measure();
        surface_.seconds.mesh += clock_.lap();
    }

    bool wants_finer_grid() const {
        const RemeshOptions& remesh = options_.remesh;
        if (!remesh.is_on() || !remesh.finer_grid || remesh.simplify_topology) return false;
        if (options_.method == Method::Gaussian || observer_) return false;
        // A flow that leads away from the surface does so on any grid, and takes minutes for it on a fine one.
        if (options_.method == Method::Flow && !surface_.flow.converged) return false;
        return std::abs(surface_.corrected_area / yardstick_.kept.ses_area - 1.0) > kWantedArea;
    }

    // Returns whether there is room for half the spacing.
    bool refine_grid() {
        SurfaceOptions finer = options_;
        finer.spacing *= 0.5;
        const Cost expected = estimate_cost(atoms_, finer);
        if (expected.area / (finer.spacing * finer.spacing) > kMostForFiner || !fits_into_memory(finer, expected))
            return false;
        Surface next;
        next.expected = expected;
        next.seconds = surface_.seconds;
        next.seconds.estimate += clock_.lap();
        surface_ = std::move(next);
        options_ = finer;
        sides_.clear();
        choose_yardstick(ses_problem(atoms_, options_));
        return true;
    }

    void report(std::string_view stage, double fraction) const {
        if (progress_) progress_(stage, fraction);
    }

    Field make_field() {
        const GaussianDensity density(*accessible_, options_.density);
        const bool evolves = options_.method == Method::Flow;
        const bool from_density = options_.method == Method::Gaussian || (evolves && needs_start(options_, observer_));
        Field field;
        field.grid = make_grid(options_.method != Method::Gaussian, from_density ? &density : nullptr, margin_);
        report("band", 0.2);
        if (options_.method == Method::Gaussian)
            make_envelope(density, field);
        else if (evolves)
            evolve_start(from_density ? &density : nullptr, field);
        else
            find_exact_sides(field);
        if (evolves && options_.initial_area) measure_start(density);
        return field;
    }

    /// The blocks near the exact surface, the Gaussian envelope, or both.
    std::shared_ptr<const BlockGrid> make_grid(bool exact, const GaussianDensity* density, double margin) const {
        const Lattice lattice{options_.spacing, options_.spacing * kGridShift};
        const std::size_t limit = block_limit(options_);
        std::vector<BlockCoord> blocks;
        if (exact) blocks = blocks_near_surface(*accessible_, lattice, margin, limit);
        if (density != nullptr) {
            const std::vector<BlockCoord> more = density->blocks_near_surface(lattice, margin, limit);
            std::vector<BlockCoord> all;
            std::set_union(blocks.begin(), blocks.end(), more.begin(), more.end(), std::back_inserter(all));
            blocks = std::move(all);
        }
        return std::make_shared<const BlockGrid>(lattice.spacing, lattice.origin, std::move(blocks));
    }

    void measure_start(const GaussianDensity& density) {
        const double margin = kCutCell * options_.spacing;
        const auto grid = make_grid(false, &density, margin);
        surface_.flow.initial_area = flat_area(extract_zero_set(*grid, density.sample(*grid, margin)));
        surface_.seconds.flow += clock_.lap();
    }

    void find_exact_sides(Field& field) {
        field.inside = find_sides(*accessible_, *field.grid);
        surface_.seconds.band += clock_.lap();
        report("band", 1.0);
    }

    void make_envelope(const GaussianDensity& density, Field& field) {
        field.values = density.sample(*field.grid, margin_);
        field.level_set = std::make_shared<const LevelSet>(
            field.grid, interpolating_coefficients(*field.grid, field.values, FlowOptions{}.half_width));
        surface_.seconds.band += clock_.lap();
        report("band", 1.0);
    }

    void evolve_start(const GaussianDensity* density, Field& field) {
        DistanceBand band = sample_distance(*accessible_, *field.grid, margin_);
        report("band", 0.8);
        NodeField start;
        if (density != nullptr) start = density->sample(*field.grid, margin_);
        surface_.seconds.band += clock_.lap();
        report("band", 1.0);

        FlowOutcome outcome =
            run_flow(*accessible_, field.grid, std::move(band), start, options_, progress_, observer_);
        surface_.flow = std::move(outcome.summary);
        surface_.history = std::move(outcome.history);
        field.values = std::move(outcome.state.values);
        field.level_set = std::make_shared<const LevelSet>(field.grid, std::move(outcome.state.coefficients));
        surface_.seconds.flow += clock_.lap();
        report("flow", 1.0);
    }

    void make_mesh(Field field) {
        check_pieces(field);
        Mesh zero_set = field.level_set ? extract_zero_set(*field.grid, field.values, kSpreadFraction)
                                        : extract_between(*field.grid, std::move(field.inside));
        check_scattered_points(zero_set, field);
        NodeField().swap(field.values);  // the mesh grows into their memory
        field.grid.reset();
        const Curvatures curvatures = options_.remesh.adaptive ? Curvatures::FilledIn : Curvatures::LeftOut;
        const SurfaceProjector project =
            surface_projector(*accessible_, field.level_set.get(), options_.spacing, curvatures);
        // Vertices halfway between nodes tell nothing of lengths and distances.
        if (!field.level_set && (options_.remesh.is_on() || options_.fill_cavities > 0.0))
            put_on_surface(zero_set.vertices, project);
        if (options_.fill_cavities > 0.0) fill_cavities(zero_set, project);
        if (options_.min_cavity > 0.0) surface_.dropped = drop_small_cavities(zero_set, options_.min_cavity, project);
        if (options_.remesh.is_on()) {
            EvenMesh even = make_even(std::move(zero_set), options_.remesh, project);
            surface_.simplified = even.simplified;
            zero_set = std::move(even.mesh);
        }
        SurfaceMesh meshed =
            mesh_surface(*accessible_, std::move(zero_set), field.level_set.get(),
                         {.spacing = options_.spacing, .edge = options_.remesh.edge, .pieces = options_.pieces});
        surface_.level_set = std::move(field.level_set);
        surface_.mesh = std::move(meshed.mesh);
        survey_ = std::move(meshed.survey);
        surface_.distance = meshed.distance;
        if (options_.method != Method::Flow) return;
        surface_.flow.mean_distance = surface_.distance.mean;
        surface_.flow.max_distance = surface_.distance.max;
    }

    // Of everything that was computed, before pieces are left out.
    void check_pieces(const Field& field) {
        if (options_.method == Method::Gaussian) return;
        const std::vector<DeepPoint>& points = yardstick_.points;
        sides_.push_back(pieces_check(field.level_set ? count_wrong(points, *field.level_set)
                                                      : count_wrong(points, *field.grid, field.inside)));
    }
    void check_scattered_points(const Mesh& zero_set, const Field& field) {
        if (options_.method == Method::Gaussian || !options_.verify) return;
        const std::vector<DeepPoint> scattered = scattered_points(*accessible_, options_);
        sides_.push_back(
            sides_check(field.level_set ? count_wrong(scattered, *field.level_set) : count_wrong(scattered, zero_set)));
    }

    void fill_cavities(Mesh& zero_set, const SurfaceProjector& project) {
        FilledCavities& filled = surface_.filled;
        const DroppedPieces dropped = drop_small_cavities(zero_set, options_.fill_cavities, project, &filled.walls);
        filled.cavities = dropped.cavities;
        filled.islands = dropped.islands;
        if (dropped.cavities == 0) return;
        filled.volume = -measure_mesh(filled.walls).volume;
        filled.rest = zero_set;
    }

    void measure() {
        const std::optional<CorrectedMeasures> on_zero_set =
            options_.remesh.is_on() ? std::optional(corrected_on_zero_set()) : std::nullopt;
        const bool moved =
            options_.remesh.is_on() && move_corners(surface_.mesh, options_.remesh, *accessible_, projector());
        if (moved) survey_ = survey_of(surface_.mesh, surface_.level_set.get());
        const bool examined = options_.verify || options_.quality || options_.remesh.is_on();
        SurfaceMeasures measures =
            measure_surface(surface_.mesh, *survey_, examined ? Stars::Examined : Stars::Trusted);
        survey_.reset();
        surface_.measures = std::move(measures.mesh);
        surface_.mesh.areas = std::move(measures.areas);
        const CorrectedMeasures corrected = on_zero_set.value_or(measures.corrected);
        surface_.corrected_area = corrected.area;
        surface_.corrected_volume = corrected.volume;
        if (options_.quality) surface_.quality = measure_quality(surface_.mesh);
        if (options_.two_sided_distance) surface_.two_sided = measure_distance(surface_.mesh, *accessible_);
        surface_.checks = mesh_checks(surface_);  // of distances before vertices were moved off the surface
        if (moved) surface_.distance = distance_of_vertices(*accessible_, surface_.mesh);
        if (options_.method != Method::Gaussian) surface_.checks.push_back(volume_check(surface_, yardstick_));
        surface_.checks.insert(surface_.checks.end(), sides_.begin(), sides_.end());
        if (options_.verify) verify();
    }

    void verify() {
        surface_.self_intersections = places_of_self_intersections(surface_.mesh).size();
        const auto count = static_cast<double>(*surface_.self_intersections);
        surface_.checks.push_back({"no_self_intersections", count == 0.0, count, 0.0});
    }

    // Normals tell the middle of short edges; those of large triangles are looked for.
    CorrectedMeasures corrected_on_zero_set() const {
        return corrected_on_surface(surface_.mesh, options_.remesh.edge, projector());
    }

    // Of what was meshed.
    SurfaceProjector projector() const {
        return surface_projector(*accessible_, surface_.level_set.get(), options_.spacing, Curvatures::LeftOut);
    }

    const Atoms& atoms_;
    SurfaceOptions options_;
    const Progress& progress_;
    const FlowObserver& observer_;
    const ExactSurface* exact_;
    std::optional<Measures> measured_;  // with SurfaceOptions::exact
    double margin_ = 0.0;
    StageClock clock_;
    std::unique_ptr<AccessibleSurface> own_;
    const AccessibleSurface* accessible_ = nullptr;
    Yardstick yardstick_;
    std::optional<TriangleSurvey> survey_;  // of the mesh, until it has been measured
    std::vector<Check> sides_;
    Surface surface_;
};

// What the computation will take, unless it is refused.
Cost estimate_what_fits(const Atoms& atoms, const SurfaceOptions& options) {
    const Cost expected = estimate_cost(atoms, options);
    refuse_what_would_not_fit(atoms, options, expected);
    return expected;
}

}  // namespace

bool Surface::passed() const {
    return std::all_of(checks.begin(), checks.end(), [](const Check& check) { return check.passed; });
}

ExactSurface measure_exactly(const Atoms& atoms, const SurfaceOptions& options) {
    check_options(options);
    const ThreadLimit limit(options.threads);
    StageTimes seconds;
    StageClock clock;
    const Cost expected = estimate_what_fits(atoms, options);
    seconds.estimate = clock.lap();
    const SesProblem problem = ses_problem(atoms, options);
    AccessibleSurface accessible(problem.atoms, problem.probe);
    seconds.geometry = clock.lap();
    Measures measures = measure(accessible, problem.atoms);
    seconds.exact = clock.lap();
    return {expected, std::move(accessible), std::move(measures), seconds};
}

Surface compute_surface(const Atoms& atoms, const SurfaceOptions& options, const Progress& progress,
                        const FlowObserver& observer, const ExactSurface* exact) {
    check_options(options);
    const ThreadLimit limit(options.threads);
    StageClock clock;
    const Cost expected = exact != nullptr ? exact->expected : estimate_what_fits(atoms, options);
    const double estimate_seconds = clock.lap();
    Surface surface = Pipeline(atoms, options, progress, observer, exact, expected).run();
    surface.seconds.estimate += estimate_seconds;
    return surface;
}

}  // namespace meniscus
