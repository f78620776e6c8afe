// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/surface.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "band/distance_band.h"
#include "band/sides.h"
#include "band/surface_blocks.h"
#include "cavities/choose_pieces.h"
#include "core/number_text.h"
#include "core/parallel.h"
#include "core/requirements.h"
#include "flow/evolution.h"
#include "flow/gaussian_density.h"
#include "geometry/accessible_surface.h"
#include "measure/surface_measures.h"
#include "meniscus/errors.h"
#include "meniscus/threads.h"
#include "mesh/extract.h"
#include "pipeline/band_size.h"
#include "pipeline/check_options.h"
#include "pipeline/even_mesh.h"
#include "pipeline/flow_stage.h"
#include "pipeline/reference_values.h"
#include "pipeline/self_checks.h"
#include "pipeline/surface_mesh.h"
#include "project/move_corners.h"
#include "project/surface_projector.h"
#include "remesh/self_intersections.h"

namespace meniscus {
namespace {

// The grid starts here, in spacings: fractions without meaning, so that atoms at round coordinates with round
// radii do not put the surface, or planes of symmetry, exactly onto nodes.
constexpr Vec3 kGridShift{0.3819660, 0.2360680, 0.1458980};

// Even meshes: areas farther from the exact one than this part of it ask for a finer grid, as long as the surface
// covers no more of its squares than that.
constexpr double kWantedArea = 0.005;
constexpr double kMostForFiner = 1.5e5;
constexpr int kFinerGrids = 2;

// Tells a caller where the computation is, and how long the stages took.
class StageLog {
public:
    explicit StageLog(const Progress& progress) : progress_(progress) {}

    void report(std::string_view stage, double fraction) const {
        if (progress_) progress_(stage, fraction);
    }

    /// Adds the time since the last call to that of a stage.
    void add_to(double StageTimes::*stage) {
        const auto now = std::chrono::steady_clock::now();
        seconds_.*stage += std::chrono::duration<double>(now - last_).count();
        last_ = now;
    }

    const StageTimes& seconds() const { return seconds_; }

private:
    const Progress& progress_;
    std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
    StageTimes seconds_;
};

// What every stage is told: which surface is meshed, and how.
struct Task {
    ExactSurface exact;
    SurfaceOptions options;
    const RunOptions& run;
    StageLog& log;

    const AccessibleSurface& accessible() const { return exact.accessible(); }
    bool is(Method method) const { return options.method == method; }
};

// On which side of the surface the nodes of a grid lie, and how far from it, as a method has it.
struct SidedField {
    std::shared_ptr<const BlockGrid> grid;
    NodeField values{};                           // at the nodes, negative inside
    std::shared_ptr<const LevelSet> level_set{};  // of the same
    std::vector<InsideBits> inside{};             // of the exact distance, in the place of both
    FlowSummary flow{};
    std::vector<FlowStep> history{};
};

// The blocks near the exact surface, the Gaussian envelope, or both.
std::shared_ptr<const BlockGrid> make_grid(const Task& task, bool exact, const GaussianDensity* density,
                                           double margin) {
    const double spacing = task.options.spacing;
    const Lattice lattice{spacing, spacing * kGridShift};
    const std::size_t limit = block_limit(task.options, task.run.memory_limit_mb);
    std::vector<BlockCoord> blocks;
    if (exact) blocks = blocks_near_surface(task.accessible(), lattice, margin, limit);
    if (density != nullptr) {
        const std::vector<BlockCoord> more = density->blocks_near_surface(lattice, margin, limit);
        std::vector<BlockCoord> all;
        std::set_union(blocks.begin(), blocks.end(), more.begin(), more.end(), std::back_inserter(all));
        blocks = std::move(all);
    }
    return std::make_shared<const BlockGrid>(lattice.spacing, lattice.origin, std::move(blocks));
}

SidedField exact_sides(const Task& task) {
    SidedField field{.grid = make_grid(task, true, nullptr, band_margin(task.options))};
    task.log.report("band", 0.2);
    field.inside = find_sides(task.accessible(), *field.grid);
    task.log.add_to(&StageTimes::band);
    task.log.report("band", 1.0);
    return field;
}

SidedField gaussian_envelope(const Task& task) {
    const GaussianDensity density(task.accessible(), task.options.density);
    const double margin = band_margin(task.options);
    SidedField field{.grid = make_grid(task, false, &density, margin)};
    task.log.report("band", 0.2);
    field.values = density.sample(*field.grid, margin);
    field.level_set = std::make_shared<const LevelSet>(
        field.grid, interpolating_coefficients(*field.grid, field.values, FlowOptions{}.half_width));
    task.log.add_to(&StageTimes::band);
    task.log.report("band", 1.0);
    return field;
}

double area_of_start(const Task& task, const GaussianDensity& density) {
    const double margin = kCutCell * task.options.spacing;
    const auto grid = make_grid(task, false, &density, margin);
    const double area = flat_area(extract_zero_set(*grid, density.sample(*grid, margin)));
    task.log.add_to(&StageTimes::flow);
    return area;
}

SidedField evolved_level_set(const Task& task) {
    const GaussianDensity density(task.accessible(), task.options.density);
    const bool from_density = needs_start(task.options, task.run.observer);
    const double margin = band_margin(task.options);
    SidedField field{.grid = make_grid(task, true, from_density ? &density : nullptr, margin)};
    task.log.report("band", 0.2);
    DistanceBand band = sample_distance(task.accessible(), *field.grid, margin);
    task.log.report("band", 0.8);
    const NodeField start = from_density ? density.sample(*field.grid, margin) : NodeField{};
    task.log.add_to(&StageTimes::band);
    task.log.report("band", 1.0);

    FlowOutcome outcome = run_flow({task.accessible(), field.grid, start, task.options, task.run}, std::move(band));
    field.flow = std::move(outcome.summary);
    field.history = std::move(outcome.history);
    field.values = std::move(outcome.state.values);
    field.level_set = std::make_shared<const LevelSet>(field.grid, std::move(outcome.state.coefficients));
    task.log.add_to(&StageTimes::flow);
    task.log.report("flow", 1.0);
    if (task.options.initial_area) field.flow.initial_area = area_of_start(task, density);
    return field;
}

SidedField sided_field(const Task& task) {
    if (task.is(Method::Flow)) return evolved_level_set(task);
    return task.is(Method::Gaussian) ? gaussian_envelope(task) : exact_sides(task);
}

Mesh extract(SidedField& field) {
    return field.level_set ? extract_zero_set(*field.grid, field.values, kSpreadFraction)
                           : extract_between(*field.grid, std::move(field.inside));
}

// Of everything that was computed, before pieces are left out. Nothing exact says what the Gaussian envelope should be.
std::vector<Check> check_pieces(const Task& task, const SidedField& field, const ReferenceValues& reference) {
    if (task.is(Method::Gaussian)) return {};
    return {pieces_check(field.level_set ? count_wrong(reference.points, *field.level_set)
                                         : count_wrong(reference.points, *field.grid, field.inside))};
}

std::vector<Check> check_scattered_points(const Task& task, const Mesh& zero_set, const LevelSet* level_set) {
    if (task.is(Method::Gaussian) || !task.options.verify) return {};
    const std::vector<DeepPoint> scattered = scattered_points(task.accessible(), task.options);
    return {sides_check(level_set != nullptr ? count_wrong(scattered, *level_set) : count_wrong(scattered, zero_set))};
}

// Vertices are moved onto the level set if there is one, else onto the exact surface.
SurfaceProjector projector(const Task& task, const LevelSet* level_set, Curvatures curvatures = Curvatures::LeftOut) {
    return surface_projector(task.accessible(), level_set, task.options.spacing, curvatures);
}

FilledCavities fill_cavities(Mesh& zero_set, double least_volume, const SurfaceProjector& project) {
    FilledCavities filled;
    const DroppedPieces dropped = drop_small_cavities(zero_set, least_volume, project, &filled.walls);
    filled.cavities = dropped.cavities;
    filled.islands = dropped.islands;
    if (dropped.cavities == 0) return filled;
    filled.volume = -measure_mesh(filled.walls).volume;
    filled.rest = zero_set;
    return filled;
}

// What the options change of a zero set before its vertices are moved onto the surface.
void choose_and_even(const Task& task, Mesh& zero_set, Surface& surface) {
    const SurfaceOptions& options = task.options;
    const LevelSet* level_set = surface.level_set.get();
    const SurfaceProjector project =
        projector(task, level_set, options.remesh.adaptive ? Curvatures::FilledIn : Curvatures::LeftOut);
    // Vertices halfway between nodes tell nothing of lengths and distances.
    if (level_set == nullptr && (options.remesh.is_on() || options.fill_cavities > 0.0))
        put_on_surface(zero_set.vertices, project);
    if (options.fill_cavities > 0.0) surface.filled = fill_cavities(zero_set, options.fill_cavities, project);
    if (options.min_cavity > 0.0) surface.dropped = drop_small_cavities(zero_set, options.min_cavity, project);
    if (!options.remesh.is_on()) return;
    EvenMesh even = make_even(std::move(zero_set), options.remesh, project);
    surface.simplified = even.simplified;
    zero_set = std::move(even.mesh);
}

// Whether the exact surface is asked again once the vertices lie on the surface.
bool asks_again(const SurfaceOptions& options) { return options.remesh.is_on() || options.two_sided_distance; }

// Moves corners off the surface where even triangles are to have them, and measures what there is then.
void measure(const Task& task, TriangleSurvey survey, Surface& surface) {
    const SurfaceOptions& options = task.options;
    const LevelSet* level_set = surface.level_set.get();
    std::optional<CorrectedMeasures> on_zero_set;
    bool moved = false;
    if (options.remesh.is_on()) {
        const SurfaceProjector project = projector(task, level_set);
        // Normals tell the middle of short edges; those of large triangles are looked for.
        on_zero_set = corrected_on_surface(surface.mesh, options.remesh.edge, project);
        moved = move_corners(surface.mesh, options.remesh, task.accessible(), project);
    }
    if (moved) survey = survey_of(surface.mesh, level_set);
    const bool examined = options.verify || options.quality || options.remesh.is_on();
    SurfaceMeasures measures = measure_surface(surface.mesh, survey, examined ? Stars::Examined : Stars::Trusted);
    surface.measures = std::move(measures.mesh);
    surface.mesh.areas = std::move(measures.areas);
    const CorrectedMeasures corrected = on_zero_set.value_or(measures.corrected);
    surface.corrected_area = corrected.area;
    surface.corrected_volume = corrected.volume;
    surface.checks = mesh_checks(surface);  // of distances before vertices were moved off the surface
    if (moved) surface.distance = distance_of_vertices(task.accessible(), surface.mesh);
    if (options.quality) surface.quality = measure_quality(surface.mesh);
    if (options.two_sided_distance) surface.two_sided = measure_distance(surface.mesh, task.exact);
}

Check check_self_intersections(Surface& surface) {
    surface.self_intersections = places_of_self_intersections(surface.mesh).size();
    const auto count = static_cast<double>(*surface.self_intersections);
    return {"no_self_intersections", count == 0.0, count, 0.0};
}

Surface mesh_on_grid(Task& task, const ReferenceValues& reference) {
    Surface surface;
    surface.options = task.options;
    SidedField field = sided_field(task);
    surface.flow = std::move(field.flow);
    surface.history = std::move(field.history);
    surface.level_set = field.level_set;
    std::vector<Check> sides = check_pieces(task, field, reference);
    Mesh zero_set = extract(field);
    field = {};  // the mesh grows into its memory
    const LevelSet* level_set = surface.level_set.get();
    for (Check& check : check_scattered_points(task, zero_set, level_set)) sides.push_back(std::move(check));
    choose_and_even(task, zero_set, surface);
    SurfaceMesh meshed = mesh_surface(
        task.accessible(), std::move(zero_set), level_set,
        {.spacing = task.options.spacing, .edge = task.options.remesh.edge, .pieces = task.options.pieces});
    surface.mesh = std::move(meshed.mesh);
    surface.distance = meshed.distance;
    if (task.is(Method::Flow)) {
        surface.flow.mean_distance = surface.distance.mean;
        surface.flow.max_distance = surface.distance.max;
    }
    if (!task.run.keep_exact && !asks_again(task.options))  // the areas of vertices take its memory
        task.exact = ExactSurface(task.exact.atoms(), task.exact.options());
    task.log.add_to(&StageTimes::mesh);
    task.log.report("mesh", 1.0);
    measure(task, std::move(meshed.survey), surface);
    if (!task.is(Method::Gaussian)) surface.checks.push_back(volume_check(surface, reference));
    surface.checks.insert(surface.checks.end(), sides.begin(), sides.end());
    if (task.options.verify) surface.checks.push_back(check_self_intersections(surface));
    task.log.add_to(&StageTimes::mesh);
    return surface;
}

// What the mesh is held against; of the exact measures where these are asked for.
ReferenceValues reference_values(const Task& task, const Measures* measured) {
    if (task.is(Method::Gaussian)) return {};
    ReferenceValues reference = measured != nullptr
                                    ? reference_values_of(*measured, task.exact.balls(), task.options)
                                    : find_reference_values(task.accessible(), task.exact.balls(), task.options);
    task.log.add_to(&StageTimes::exact);
    return reference;
}

bool wants_finer_grid(const Surface& surface, const ReferenceValues& reference, const FlowObserver& observer) {
    const RemeshOptions& remesh = surface.options.remesh;
    if (!remesh.is_on() || !remesh.finer_grid || remesh.simplify_topology) return false;
    if (surface.options.method == Method::Gaussian || observer) return false;
    // A flow that leads away from the surface does so on any grid, and takes minutes for it on a fine one.
    if (surface.options.method == Method::Flow && !surface.flow.converged) return false;
    return std::abs(surface.corrected_area / reference.kept.ses_area - 1.0) > kWantedArea;
}

// The cost with half the spacing, if there is room for it.
std::optional<Cost> cost_of_finer_grid(const Task& task) {
    SurfaceOptions finer = task.options;
    finer.spacing *= 0.5;
    const Cost expected = estimate_cost(task.exact.atoms(), finer);
    task.log.add_to(&StageTimes::estimate);
    const bool is_small = expected.area / (finer.spacing * finer.spacing) <= kMostForFiner;
    return is_small && fits_into_memory(expected, task.run.memory_limit_mb) ? std::optional(expected) : std::nullopt;
}

std::shared_ptr<const Measures> measure_exactly(const Task& task) {
    if (!task.options.exact) return nullptr;
    task.log.report("exact", 0.0);
    std::shared_ptr<const Measures> measured = task.exact.shared_measures();
    task.log.add_to(&StageTimes::exact);
    task.log.report("exact", 1.0);
    return measured;
}

}  // namespace

bool Surface::passed() const {
    return std::all_of(checks.begin(), checks.end(), [](const Check& check) { return check.passed; });
}

Surface mesh(ExactSurface exact, const SurfaceOptions& given, const RunOptions& run) {
    SurfaceOptions options = given;
    options.surface = exact.options().kind;
    options.probe = exact.options().probe;
    check_options(options);
    check_threads(run.threads);
    options.remesh.corners = corners_of(options);
    const ThreadLimit limit(run.threads);
    StageLog log(run.progress);
    Cost expected = estimate_cost(exact.atoms(), options);
    refuse_what_would_not_fit(exact.atoms(), options, expected, run.memory_limit_mb);
    log.add_to(&StageTimes::estimate);
    log.report("geometry", 0.0);
    exact.accessible();
    log.add_to(&StageTimes::geometry);
    log.report("geometry", 1.0);
    Task task{std::move(exact), options, run, log};
    // Comes before the grid, which then takes the memory that this needs.
    const std::shared_ptr<const Measures> measured = measure_exactly(task);
    ReferenceValues reference = reference_values(task, measured.get());
    Surface surface = mesh_on_grid(task, reference);
    for (int i = 0; i < kFinerGrids && wants_finer_grid(surface, reference, run.observer); ++i) {
        const std::optional<Cost> finer = cost_of_finer_grid(task);
        if (!finer) break;
        expected = *finer;
        task.options.spacing *= 0.5;
        surface = {};
        reference = reference_values(task, measured.get());
        surface = mesh_on_grid(task, reference);
    }
    surface.expected = expected;
    surface.seconds = log.seconds();
    surface.measured = measured;
    surface.exact = run.keep_exact ? std::move(task.exact) : ExactSurface(task.exact.atoms(), task.exact.options());
    return surface;
}

Surface compute_surface(const Atoms& atoms, const SurfaceOptions& options, const RunOptions& run) {
    return mesh(ExactSurface(atoms, {options.surface, options.probe}), options, run);
}

}  // namespace meniscus
