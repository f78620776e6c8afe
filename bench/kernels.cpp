// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Time of the stages by themselves, one thread: per atom, node, unknown and triangle. The molecule is a ball of spheres
// packed as densely as the atoms of a protein, so that no file is needed.
#include <benchmark/benchmark.h>

#include <random>

#include "band/sides.h"
#include "band/surface_blocks.h"
#include "core/parallel.h"
#include "flow/evolution.h"
#include "flow/spline_system.h"
#include "measure/corrected.h"
#include "meniscus/level_set.h"
#include "meniscus/measures.h"
#include "meniscus/threads.h"
#include "mesh/extract.h"
#include "nearest/local_features.h"
#include "pipeline/band_size.h"

namespace {

using namespace meniscus;

constexpr int kAtoms = 4000;
constexpr double kProbe = 1.4;
constexpr double kDensity = 0.06;  // atoms per Å³ of a protein's inside
constexpr double kLeastGap = 1.3;  // Å between centres

Atoms make_ball() {
    std::mt19937_64 random(1);
    const double radius = std::cbrt(3.0 * kAtoms / (4.0 * 3.14159265 * kDensity));
    std::uniform_real_distribution<double> within(-radius, radius);
    std::uniform_real_distribution<double> size(1.4, 2.0);
    Atoms atoms;
    while (atoms.centres.size() < kAtoms) {
        const Vec3 p{within(random), within(random), within(random)};
        const bool crowded = std::any_of(atoms.centres.begin(), atoms.centres.end(),
                                         [&](const Vec3& q) { return norm(p - q) < kLeastGap; });
        if (norm(p) > radius || crowded) continue;
        atoms.centres.push_back(p);
        atoms.radii.push_back(size(random));
    }
    return atoms;
}

// Everything that stages start from, made once.
struct Stage {
    Atoms atoms = make_ball();
    AccessibleSurface surface{atoms, kProbe};
    double spacing;
    double margin = 5.0 * spacing;
    BlockGrid grid;
    DistanceBand band;

    explicit Stage(double h)
        : spacing(h),
          grid(h, {}, blocks_near_surface(surface, {h, {}}, 5.0 * h, 1U << 22U)),
          band(sample_distance(surface, grid, margin)) {}
};

const Stage& stage(const benchmark::State& state) {
    static const Stage half(0.5);
    static const Stage quarter(0.25);
    return state.range(0) == 50 ? half : quarter;
}

// Time per item, in the unit that the name says.
void set_items(benchmark::State& state, std::size_t items) {
    state.counters["per_item"] = benchmark::Counter(
        static_cast<double>(items), benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void geometry_per_atom(benchmark::State& state) {
    const Atoms atoms = make_ball();
    for (auto _ : state) benchmark::DoNotOptimize(AccessibleSurface(atoms, kProbe).arc_count());
    set_items(state, atoms.size());
}

void measures_per_atom(benchmark::State& state) {
    const Atoms atoms = make_ball();
    for (auto _ : state) benchmark::DoNotOptimize(measure(atoms, {.threads = 1}).totals.ses_area);
    set_items(state, atoms.size());
}

void band_per_node(benchmark::State& state) {
    const Stage& on = stage(state);
    for (auto _ : state) benchmark::DoNotOptimize(sample_distance(on.surface, on.grid, on.margin).distance.data());
    set_items(state, on.grid.node_count());
}

// On the blocks that direct needs.
void sides_per_node(benchmark::State& state) {
    const Stage& on = stage(state);
    const BlockGrid grid(on.spacing, {},
                         blocks_near_surface(on.surface, {on.spacing, {}}, kCutCell * on.spacing, 1U << 22U));
    for (auto _ : state) benchmark::DoNotOptimize(find_sides(on.surface, grid).data());
    set_items(state, grid.node_count());
}

void solve_per_node_and_iteration(benchmark::State& state) {
    const Stage& on = stage(state);
    const Unknowns unknowns = nodes_near(on.grid, on.band.distance, static_cast<float>(3.0 * on.spacing));
    const BlockFill fill(on.grid.block_count(), 0.0F);
    const SplineSystem system{on.grid, unknowns, spline_value(), fill, {on.band.distance}};
    constexpr int kIterations = 10;
    for (auto _ : state) {
        std::vector<float> x(on.grid.node_count());
        solve(system, x, {.tolerance = 0.0, .max_iterations = kIterations});
        benchmark::DoNotOptimize(x.data());
    }
    set_items(state, kIterations * on.grid.node_count());
}

void flow_per_node(benchmark::State& state) {
    const Stage& on = stage(state);
    for (auto _ : state) benchmark::DoNotOptimize(evolve(on.grid, {on.band}, {}, {}).steps);
    set_items(state, on.grid.node_count());
}

void marching_cubes_per_triangle(benchmark::State& state) {
    const Stage& on = stage(state);
    std::size_t triangles = 0;
    for (auto _ : state) triangles = extract_zero_set(on.grid, on.band.distance).triangles.size();
    set_items(state, triangles);
}

void nearest_feature_per_vertex(benchmark::State& state) {
    const Stage& on = stage(state);
    const Mesh mesh = extract_zero_set(on.grid, on.band.distance);
    for (auto _ : state) benchmark::DoNotOptimize(nearest_features(on.surface, mesh.vertices).data());
    set_items(state, mesh.vertices.size());
}

void measures_per_triangle(benchmark::State& state) {
    const Stage& on = stage(state);
    const Mesh mesh = extract_zero_set(on.grid, on.band.distance);
    for (auto _ : state) benchmark::DoNotOptimize(measure_mesh(mesh).area);
    set_items(state, mesh.triangles.size());
}

BENCHMARK(geometry_per_atom)->Unit(benchmark::kMillisecond);
BENCHMARK(measures_per_atom)->Unit(benchmark::kMillisecond);
BENCHMARK(band_per_node)->Arg(50)->Arg(25)->Unit(benchmark::kMillisecond);
BENCHMARK(sides_per_node)->Arg(50)->Arg(25)->Unit(benchmark::kMillisecond);
BENCHMARK(solve_per_node_and_iteration)->Arg(50)->Arg(25)->Unit(benchmark::kMillisecond);
BENCHMARK(flow_per_node)->Arg(50)->Arg(25)->Unit(benchmark::kMillisecond);
BENCHMARK(marching_cubes_per_triangle)->Arg(50)->Arg(25)->Unit(benchmark::kMillisecond);
BENCHMARK(nearest_feature_per_vertex)->Arg(50)->Arg(25)->Unit(benchmark::kMillisecond);
BENCHMARK(measures_per_triangle)->Arg(50)->Arg(25)->Unit(benchmark::kMillisecond);

}  // namespace

int main(int argc, char** argv) {
    const meniscus::ThreadLimit one(1);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
