// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/surface.h"

#include <fmt/format.h>
#include <algorithm>
#include <chrono>
#include <cmath>

#include "band/distance_band.h"
#include "band/surface_blocks.h"
#include "core/memory.h"
#include "core/parallel.h"
#include "flow/evolution.h"
#include "flow/gaussian_density.h"
#include "geometry/local_features.h"
#include "measure/corrected.h"
#include "meniscus/accessible_surface.h"
#include "meniscus/errors.h"
#include "mesh/components.h"
#include "mesh/extract.h"

namespace meniscus {
namespace {

// Of the band's fields, the solver's vectors and the mesh: an upper estimate seen on proteins.
constexpr std::size_t kBytesPerBlock = std::size_t{48} * 1024;

// The grid starts here, in spacings: fractions without meaning, so that atoms at round coordinates with round
// radii do not put the surface, or planes of symmetry, exactly onto nodes.
constexpr Vec3 kGridShift{0.3819660, 0.2360680, 0.1458980};

// A flow's mean distance to the exact surface is near 0.01 spacings; ten times that means something broke.
constexpr double kMeanDistanceBound = 0.1;  // in spacings

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

void check_options(const SurfaceOptions& options) {
    const auto positive = [](double v) { return std::isfinite(v) && v > 0.0; };
    require(std::isfinite(options.probe) && options.probe >= 0.0, "probe", options.probe, "finite and not negative");
    require(positive(options.spacing), "spacing", options.spacing, "finite and positive");
    require(positive(-options.density), "density", options.density, "finite and negative");
    require(positive(options.time_step), "time step", options.time_step, "finite and positive");
    require(positive(options.anchor), "anchor", options.anchor, "finite and positive");
    require(options.max_steps >= 1, "max steps", options.max_steps, "at least 1");
    require(options.threads >= 0, "threads", options.threads, "0 (all cores) or more");
}

std::size_t block_limit(const SurfaceOptions& options) {
    const std::size_t bytes = options.memory_limit_mb > 0 ? options.memory_limit_mb << 20U : available_memory();
    return bytes / kBytesPerBlock;
}

// What the methods hand on to meshing.
struct Field {
    std::shared_ptr<const BlockGrid> grid;
    std::vector<float> values;                  // at the nodes, negative inside
    std::shared_ptr<const LevelSet> level_set;  // absent for the exact distance
};

// One computation in progress: the stages, in the order in which they run.
class Pipeline {
public:
    Pipeline(const Atoms& atoms, const SurfaceOptions& options, const Progress& progress)
        : options_(options),
          progress_(progress),
          margin_((EvolutionOptions{}.half_width + kBandRim) * options.spacing) {
        surface_.options = options;
        report("geometry", 0.0);
        accessible_ = std::make_unique<AccessibleSurface>(atoms, options.probe);
        surface_.seconds.geometry = clock_.lap();
        report("geometry", 1.0);
    }

    Surface run() {
        const Field field = make_field();
        make_mesh(field);
        surface_.level_set = field.level_set;
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
        const Lattice lattice{options_.spacing, options_.spacing * kGridShift};
        const GaussianDensity density(*accessible_, options_.density);
        const std::size_t limit = block_limit(options_);
        std::vector<BlockCoord> blocks;
        if (options_.method != Method::Gaussian) blocks = blocks_near_surface(*accessible_, lattice, margin_, limit);
        if (options_.method != Method::Direct) {
            const std::vector<BlockCoord> more = density.blocks_near_surface(lattice, margin_, limit);
            std::vector<BlockCoord> all;
            std::set_union(blocks.begin(), blocks.end(), more.begin(), more.end(), std::back_inserter(all));
            blocks = std::move(all);
        }
        Field field;
        field.grid = std::make_shared<const BlockGrid>(lattice.spacing, lattice.origin, std::move(blocks));
        report("band", 0.2);
        if (options_.method == Method::Gaussian)
            make_envelope(density, field);
        else if (options_.method == Method::Direct)
            sample_exact(field);
        else
            run_flow(density, field);
        return field;
    }

    void sample_exact(Field& field) {
        field.values = sample_distance(*accessible_, *field.grid, margin_).distance;
        surface_.seconds.band = clock_.lap();
        report("band", 1.0);
    }

    void make_envelope(const GaussianDensity& density, Field& field) {
        field.values = density.sample(*field.grid, margin_);
        field.level_set = std::make_shared<const LevelSet>(
            field.grid, interpolating_coefficients(*field.grid, field.values, EvolutionOptions{}.half_width));
        surface_.seconds.band = clock_.lap();
        report("band", 1.0);
    }

    void run_flow(const GaussianDensity& density, Field& field) {
        const DistanceBand band = sample_distance(*accessible_, *field.grid, margin_);
        report("band", 0.8);
        std::vector<float> start = density.sample(*field.grid, margin_);
        surface_.flow.initial_area = measure_mesh(extract_zero_set(*field.grid, start)).area;
        surface_.seconds.band = clock_.lap();
        report("band", 1.0);

        const EvolutionOptions evolution{
            .time_step = options_.time_step, .anchor = options_.anchor, .max_steps = options_.max_steps};
        EvolutionResult result = evolve_anchored(*field.grid, band, std::move(start), evolution,
                                                 [&](double fraction) { report("flow", fraction); });
        surface_.flow.steps = result.steps;
        surface_.flow.time = result.time;
        surface_.flow.converged = result.converged;
        surface_.flow.residual = result.residual;
        surface_.flow.solver_iterations = result.solver_iterations;
        field.values = std::move(result.values);
        field.level_set = std::make_shared<const LevelSet>(field.grid, std::move(result.coefficients));
        surface_.seconds.flow = clock_.lap();
        report("flow", 1.0);
    }

    void make_mesh(const Field& field) {
        surface_.mesh = extract_zero_set(*field.grid, field.values);
        report("mesh", 0.3);
        Mesh& mesh = surface_.mesh;
        if (field.level_set)
            project_onto_level_set(*field.level_set, mesh);
        else
            project_onto_exact_surface(mesh);
        report("mesh", 0.6);
        const std::vector<NearestFeature> features = nearest_features(*accessible_, mesh.vertices);
        attach(features, !field.level_set);
        label_components(mesh);
    }

    static void project_onto_level_set(const LevelSet& level_set, Mesh& mesh) {
        mesh.normals.resize(mesh.vertices.size());
        parallel_for(mesh.vertices.size(), 1024, [&](std::size_t v) {
            mesh.vertices[v] = level_set.project(mesh.vertices[v]);
            const Vec3 gradient = level_set.sample(mesh.vertices[v]).gradient;
            mesh.normals[v] = squared_norm(gradient) > 0.0 ? normalised(gradient) : Vec3{0.0, 0.0, 1.0};
        });
    }

    // Next to ridges the distance is a lower bound, so a step can fall short: a few are taken.
    void project_onto_exact_surface(Mesh& mesh) const {
        constexpr int kSteps = 3;
        for (int step = 0; step < kSteps; ++step) {
            const std::vector<NearestFeature> features = nearest_features(*accessible_, mesh.vertices);
            parallel_for(mesh.vertices.size(), 1024, [&](std::size_t v) {
                mesh.vertices[v] = mesh.vertices[v] - features[v].signed_distance * features[v].normal;
            });
        }
    }

    void attach(const std::vector<NearestFeature>& features, bool with_normals) {
        Mesh& mesh = surface_.mesh;
        mesh.atoms.resize(features.size());
        mesh.patches.resize(features.size());
        if (with_normals) mesh.normals.resize(features.size());
        std::vector<double> distances(features.size());
        for (std::size_t v = 0; v < features.size(); ++v) {
            mesh.atoms[v] = features[v].atom;
            mesh.patches[v] = features[v].patch;
            if (with_normals) mesh.normals[v] = features[v].normal;
            distances[v] = std::abs(features[v].signed_distance);
        }
        surface_.distance = summarise(distances);
        surface_.flow.mean_distance = options_.method == Method::Flow ? surface_.distance.mean : 0.0;
        surface_.flow.max_distance = options_.method == Method::Flow ? surface_.distance.max : 0.0;
    }

    static DistanceSummary summarise(std::vector<double>& distances) {
        if (distances.empty()) return {};
        DistanceSummary summary;
        for (const double d : distances) summary.mean += d;
        summary.mean /= static_cast<double>(distances.size());
        const auto p99 =
            distances.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(distances.size() - 1));
        std::nth_element(distances.begin(), p99, distances.end());
        summary.p99 = *p99;
        summary.max = *std::max_element(p99, distances.end());
        return summary;
    }

    void measure() {
        surface_.measures = measure_mesh(surface_.mesh);
        const CorrectedMeasures corrected = corrected_measures(surface_.mesh);
        surface_.corrected_area = corrected.area;
        surface_.corrected_volume = corrected.volume;
        const auto holds = [](std::string name, bool passed) {
            return Check{std::move(name), passed, passed ? 1.0 : 0.0, 1.0};
        };
        surface_.checks.push_back(holds("not_empty", !surface_.mesh.triangles.empty()));
        surface_.checks.push_back(holds("closed", surface_.measures.closed));
        surface_.checks.push_back(holds("manifold", surface_.measures.manifold));
        if (options_.method == Method::Flow) surface_.checks.push_back(holds("converged", surface_.flow.converged));
        if (options_.method == Method::Gaussian) return;
        const double bound = kMeanDistanceBound * options_.spacing;
        surface_.checks.push_back({"mean_distance", surface_.distance.mean <= bound, surface_.distance.mean, bound});
    }

    const SurfaceOptions& options_;
    const Progress& progress_;
    double margin_;
    StageClock clock_;
    std::unique_ptr<AccessibleSurface> accessible_;
    Surface surface_;
};

}  // namespace

bool Surface::passed() const {
    return std::all_of(checks.begin(), checks.end(), [](const Check& check) { return check.passed; });
}

Surface compute_surface(const Atoms& atoms, const SurfaceOptions& options, const Progress& progress) {
    check_options(options);
    const ThreadLimit limit(options.threads);
    return Pipeline(atoms, options, progress).run();
}

}  // namespace meniscus
