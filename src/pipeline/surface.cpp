// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/surface.h"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "band/distance_band.h"
#include "band/surface_blocks.h"
#include "core/parallel.h"
#include "flow/evolution.h"
#include "flow/gaussian_density.h"
#include "measure/surface_measures.h"
#include "meniscus/accessible_surface.h"
#include "meniscus/errors.h"
#include "mesh/extract.h"
#include "pipeline/band_size.h"
#include "pipeline/choose_pieces.h"
#include "pipeline/flow_stage.h"
#include "pipeline/self_checks.h"
#include "pipeline/surface_mesh.h"
#include "pipeline/surface_projector.h"
#include "pipeline/yardstick.h"
#include "remesh/narrow_handles.h"
#include "remesh/self_intersections.h"

namespace meniscus {
namespace {

// The grid starts here, in spacings: fractions without meaning, so that atoms at round coordinates with round
// radii do not put the surface, or planes of symmetry, exactly onto nodes.
constexpr Vec3 kGridShift{0.3819660, 0.2360680, 0.1458980};

constexpr double kWidestBand = 16.0;  // spacings

// Marching cubes needs the signs, and of distances where on its edge a vertex starts on its way to the surface: never
// nearer to a node than kSpreadFraction. Distances up to 0.65 spacings would tell that exactly; these tell it within
// 0.12.
constexpr double kDistancesThatMatter = 0.4;  // spacings

constexpr int kSimplifyingRounds = 3;  // none has needed more than two

constexpr double kLongestPart = 0.3;  // Å: of the triangles that large ones are divided into to be measured

constexpr std::size_t kTrianglesPerChunk = 4096;

double longest_edge_of(const Mesh& mesh) {
    double squared = 0.0;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            squared = std::max(squared, squared_norm(mesh.vertices[t[(k + 1) % 3]] - mesh.vertices[t[k]]));
    return std::sqrt(squared);
}

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

void require(bool holds, std::string_view option, double value, std::string_view wanted) {
    if (!holds) throw UsageError(fmt::format("{} {:g}: must be {}", option, value, wanted));
}

bool positive(double v) { return std::isfinite(v) && v > 0.0; }

void check_flow(const FlowOptions& flow) {
    require(std::isfinite(flow.anchor) && flow.anchor >= 0.0, "anchor", flow.anchor, "finite and not negative");
    require(flow.time_step > 0.0, "time step", flow.time_step, "positive");
    require(std::isfinite(flow.time_step) || flow.anchor > 0.0, "time step", flow.time_step,
            "finite where there is no anchor");
    require(flow.half_width >= 2.0 && flow.half_width <= kWidestBand, "half width", flow.half_width,
            fmt::format("from 2 to {:g}", kWidestBand));
    require(positive(flow.tolerance), "tolerance", flow.tolerance, "finite and positive");
    require(flow.max_steps >= 1, "max steps", flow.max_steps, "at least 1");
}

void check_options(const SurfaceOptions& options) {
    require(std::isfinite(options.probe) && options.probe >= 0.0, "probe", options.probe, "finite and not negative");
    if (options.method == Method::Gaussian && options.surface != SurfaceKind::Ses)
        throw UsageError("method gaussian is one envelope of the atoms; surface sas and vdw need flow or direct");
    require(positive(options.spacing), "spacing", options.spacing, "finite and positive");
    require(positive(-options.density), "density", options.density, "finite and negative");
    if (options.method == Method::Flow) check_flow(options.flow);
    const RemeshOptions& remesh = options.remesh;
    require(remesh.edge == 0.0 || positive(remesh.edge), "edge", remesh.edge, "finite and positive");
    require(!remesh.is_on() || options.spacing <= kCoarsestForRemeshing, "spacing", options.spacing,
            fmt::format("at most {:g} where triangles are made even", kCoarsestForRemeshing));
    require(!remesh.simplify_topology || remesh.is_on(), "edge", remesh.edge,
            "positive where the topology is simplified");
    require(std::isfinite(options.min_cavity) && options.min_cavity >= 0.0, "min cavity", options.min_cavity,
            "finite and not negative");
    require(std::isfinite(options.fill_cavities) && options.fill_cavities >= 0.0, "fill cavities",
            options.fill_cavities, "finite and not negative");
    require(options.threads >= 0, "threads", options.threads, "0 (all cores) or more");
}

double area_of(const Mesh& mesh) {
    return parallel_sum<double>(mesh.triangles.size(), kTrianglesPerChunk, [&](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t t = begin; t < end; ++t) {
            const auto [a, b, c] = mesh.triangles[t];
            sum += 0.5 * norm(cross(mesh.vertices[b] - mesh.vertices[a], mesh.vertices[c] - mesh.vertices[a]));
        }
        return sum;
    });
}

// What the methods hand on to meshing.
struct Field {
    std::shared_ptr<const BlockGrid> grid;
    NodeField values;                           // at the nodes, negative inside
    std::shared_ptr<const LevelSet> level_set;  // absent for the exact distance
};

// One computation in progress: the stages, in the order in which they run.
class Pipeline {
public:
    Pipeline(const Atoms& atoms, const SurfaceOptions& options, const Progress& progress, const FlowObserver& observer,
             const ExactSurface* exact)
        : options_(options), progress_(progress), observer_(observer), margin_(band_margin(options)) {
        surface_.options = options;
        if (exact != nullptr) surface_.seconds = exact->seconds;
        report("geometry", 0.0);
        const SesProblem problem = ses_problem(atoms, options);
        if (exact == nullptr) own_ = std::make_unique<AccessibleSurface>(problem.atoms, problem.probe);
        accessible_ = exact != nullptr ? &exact->accessible : own_.get();
        surface_.seconds.geometry += clock_.lap();
        report("geometry", 1.0);
        if (options_.method == Method::Gaussian) return;  // nothing exact says what the envelope should be
        yardstick_ = exact != nullptr ? yardstick_of(exact->measures, problem.atoms, options_)
                                      : make_yardstick(*accessible_, problem.atoms, options_);
        surface_.seconds.exact += clock_.lap();
    }

    Surface run() {
        make_mesh(make_field());
        surface_.seconds.mesh = clock_.lap();
        report("mesh", 1.0);
        measure();
        surface_.seconds.mesh += clock_.lap();
        return std::move(surface_);
    }

private:
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
            sample_exact(field);
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
        surface_.flow.initial_area = area_of(extract_zero_set(*grid, density.sample(*grid, margin)));
        surface_.seconds.flow += clock_.lap();
    }

    void sample_exact(Field& field) {
        field.values =
            sample_distance(*accessible_, *field.grid, kDistancesThatMatter * options_.spacing, BandFields::Distance)
                .distance;
        surface_.seconds.band = clock_.lap();
        report("band", 1.0);
    }

    void make_envelope(const GaussianDensity& density, Field& field) {
        field.values = density.sample(*field.grid, margin_);
        field.level_set = std::make_shared<const LevelSet>(
            field.grid, interpolating_coefficients(*field.grid, field.values, FlowOptions{}.half_width));
        surface_.seconds.band = clock_.lap();
        report("band", 1.0);
    }

    void evolve_start(const GaussianDensity* density, Field& field) {
        DistanceBand band = sample_distance(*accessible_, *field.grid, margin_);
        report("band", 0.8);
        NodeField start;
        if (density != nullptr) start = density->sample(*field.grid, margin_);
        surface_.seconds.band = clock_.lap();
        report("band", 1.0);

        FlowOutcome outcome =
            run_flow(*accessible_, field.grid, std::move(band), start, options_, progress_, observer_);
        surface_.flow = std::move(outcome.summary);
        surface_.history = std::move(outcome.history);
        field.values = std::move(outcome.state.values);
        field.level_set = std::make_shared<const LevelSet>(field.grid, std::move(outcome.state.coefficients));
        surface_.seconds.flow = clock_.lap();
        report("flow", 1.0);
    }

    void make_mesh(Field field) {
        Mesh zero_set = extract_zero_set(*field.grid, field.values, kSpreadFraction);
        hold_against_exact_sides(zero_set, field.level_set.get());
        NodeField().swap(field.values);  // the mesh grows into their memory
        const Curvatures curvatures = options_.remesh.adaptive ? Curvatures::FilledIn : Curvatures::LeftOut;
        const SurfaceProjector project =
            surface_projector(*accessible_, field.level_set.get(), options_.spacing, curvatures);
        if (options_.fill_cavities > 0.0) fill_cavities(zero_set, project);
        if (options_.min_cavity > 0.0) surface_.dropped = drop_small_cavities(zero_set, options_.min_cavity, project);
        if (options_.remesh.is_on()) zero_set = make_even(std::move(zero_set), project);
        SurfaceMesh meshed =
            mesh_surface(*accessible_, std::move(zero_set), field.level_set.get(),
                         {.spacing = options_.spacing, .edge = options_.remesh.edge, .pieces = options_.pieces});
        surface_.level_set = std::move(field.level_set);
        surface_.mesh = std::move(meshed.mesh);
        surface_.distance = meshed.distance;
        if (options_.method != Method::Flow) return;
        surface_.flow.mean_distance = surface_.distance.mean;
        surface_.flow.max_distance = surface_.distance.max;
    }

    // Of everything that was computed, before pieces are left out.
    void hold_against_exact_sides(const Mesh& zero_set, const LevelSet* level_set) {
        const auto wrong = [&](std::span<const DeepPoint> points) {
            return level_set != nullptr ? count_wrong(points, *level_set) : count_wrong(points, zero_set);
        };
        if (options_.method == Method::Gaussian) return;
        sides_.push_back(pieces_check(wrong(yardstick_.points)));
        if (options_.verify) sides_.push_back(sides_check(wrong(scattered_points(*accessible_, options_))));
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

    // Handles are too narrow for the triangles only where these are even; their ends are made even afterwards.
    Mesh make_even(Mesh zero_set, const SurfaceProjector& project) {
        const RemeshOptions& wanted = options_.remesh;
        if (wanted.simplify_topology) surface_.simplified.pieces = drop_tiny_pieces(zero_set, wanted.edge);
        Mesh even = remesh(zero_set, wanted, project);
        for (int round = 0; wanted.simplify_topology && round < kSimplifyingRounds; ++round) {
            const CutMesh cut = cut_narrow_handles(even, wanted.edge, project);
            if (cut.handles == 0) break;
            surface_.simplified.handles += cut.handles;
            even = remesh(cut.mesh, wanted, project);
        }
        return even;
    }

    void measure() {
        // A level set has rounded them.
        const Creases creases = surface_.level_set ? Creases::Rounded : Creases::Sharp;
        SurfaceMeasures measures = measure_surface(surface_.mesh, creases);
        surface_.measures = std::move(measures.mesh);
        surface_.mesh.areas = std::move(measures.areas);
        const CorrectedMeasures corrected = options_.remesh.is_on() ? corrected_on_surface() : measures.corrected;
        surface_.corrected_area = corrected.area;
        surface_.corrected_volume = corrected.volume;
        if (options_.quality) surface_.quality = measure_quality(surface_.mesh);
        if (options_.two_sided_distance) surface_.two_sided = measure_distance(surface_.mesh, *accessible_);
        surface_.checks = mesh_checks(surface_);
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
    CorrectedMeasures corrected_on_surface() const {
        const SurfaceProjector project =
            surface_projector(*accessible_, surface_.level_set.get(), options_.spacing, Curvatures::LeftOut);
        const auto move = [&project](std::span<Vec3> places, std::span<Vec3> normals) {
            std::vector<SurfacePoint> points(places.size());
            for (std::size_t i = 0; i < points.size(); ++i) points[i].position = places[i];
            project(points);
            for (std::size_t i = 0; i < points.size(); ++i) {
                places[i] = points[i].position;
                normals[i] = points[i].normal;
            }
        };
        // Edges are as long as they are asked for only as far as the molecule has room for them.
        const double edge = std::min(options_.remesh.edge, longest_edge_of(surface_.mesh));
        int divisions = 1;
        while (std::ldexp(edge, -divisions) > kLongestPart) ++divisions;
        return corrected_measures(surface_.mesh, move, divisions);
    }

    const SurfaceOptions& options_;
    const Progress& progress_;
    const FlowObserver& observer_;
    double margin_;
    StageClock clock_;
    std::unique_ptr<const AccessibleSurface> own_;
    const AccessibleSurface* accessible_ = nullptr;
    Yardstick yardstick_;
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
    Surface surface = Pipeline(atoms, options, progress, observer, exact).run();
    surface.expected = expected;
    surface.seconds.estimate += estimate_seconds;
    return surface;
}

}  // namespace meniscus
