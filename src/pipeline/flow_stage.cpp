// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/flow_stage.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/number_text.h"
#include "flow/paper/printed_curvature.h"
#include "flow/steady_state.h"
#include "measure/surface_measures.h"
#include "mesh/extract.h"
#include "pipeline/surface_mesh.h"

namespace meniscus {
namespace {

constexpr double kNothing = std::numeric_limits<double>::quiet_NaN();
constexpr double kRoom = 3.0;  // Å that a flow without an anchor may move away

NodeField curvature_field(const AccessibleSurface& accessible, const BlockGrid& grid, const FlowOptions& options,
                          DistanceBand& band) {
    switch (options.curvature) {
        case CurvatureField::Parallel:
            break;
        case CurvatureField::Sharp:
            return sharp_curvature(grid, band, options.half_width);
        case CurvatureField::Paper:
            return sample_printed_curvature(accessible, grid, BridgedPair::Torus);
        case CurvatureField::PaperLiteral:
            return sample_printed_curvature(accessible, grid, BridgedPair::Reentrant);
    }
    return std::move(band.curvature);
}

std::int64_t genus_of(const MeshMeasures& measures) {
    return static_cast<std::int64_t>(measures.components.size()) - measures.euler_characteristic / 2;
}

// Meshes states, keeps the record and the best state.
class FlowRecord {
public:
    FlowRecord(const AccessibleSurface& accessible, std::shared_ptr<const BlockGrid> grid, const FlowObserver& observer)
        : accessible_(accessible), grid_(std::move(grid)), observer_(observer) {}

    void add(const FlowState& state, FlowStep step) {
        const LevelSet level_set(grid_, state.coefficients);
        SurfaceMesh surface = mesh_surface(accessible_, extract_zero_set(*grid_, state.values, kSpreadFraction),
                                           &level_set, {.spacing = grid_->spacing()});
        SurfaceMeasures measured = measure_surface(surface.mesh, surface.survey, Stars::Examined);
        surface.mesh.areas = std::move(measured.areas);
        const MeshMeasures& measures = measured.mesh;
        step.area = measures.area;
        step.volume = measures.volume;
        const bool empty = surface.mesh.vertices.empty();
        step.mean_distance = empty ? kNothing : surface.distance.mean;
        step.max_distance = empty ? kNothing : surface.distance.max;
        step.components = measures.components.size();
        step.genus = genus_of(measures);
        if (observer_) observer_(step, surface.mesh);
        if (step.step > 0 && !empty && (best_ == nullptr || step.mean_distance < history_[best_step_].mean_distance)) {
            best_ = std::make_unique<FlowState>(state);
            best_step_ = history_.size();
        }
        history_.push_back(step);
    }

    bool has_best() const { return best_ != nullptr; }
    const FlowStep& best_step() const { return history_[best_step_]; }
    const FlowStep& last_step() const { return history_.back(); }
    FlowState take_best() { return std::move(*best_); }
    std::vector<FlowStep> take_history() { return std::move(history_); }

private:
    const AccessibleSurface& accessible_;
    std::shared_ptr<const BlockGrid> grid_;
    const FlowObserver& observer_;
    std::vector<FlowStep> history_;
    std::unique_ptr<FlowState> best_;
    std::size_t best_step_ = 0;  // in history_
};

FlowSummary summarise(const EvolutionResult& result) {
    FlowSummary summary;
    summary.steps = result.steps;
    summary.time = result.time;
    summary.converged = result.converged();
    summary.end = result.end;
    summary.residual = result.residual;
    summary.solver_iterations = result.solver_iterations;
    summary.reinitialisations = result.reinitialisations;
    summary.kept_step = result.steps;
    return summary;
}

std::string describe_end(const EvolutionResult& result) {
    switch (result.end) {
        case FlowEnd::Converged:
            return "";
        case FlowEnd::StepsUsedUp:
            return joined("not steady after ", result.steps, " steps (speed ", in_short(result.residual, 3), " Å^-1)");
        case FlowEnd::Stalled:
            return joined("the change per step no longer falls (speed ", in_short(result.residual, 3), " Å^-1)");
        case FlowEnd::Vanished:
            return joined("the surface shrank to nothing in step ", result.steps);
        case FlowEnd::LeftBand:
            return joined("the surface left the band around the solvent-excluded surface in step ", result.steps);
    }
    return "";
}

// What became of a flow without an anchor.
std::string describe_course(const EvolutionResult& result, const FlowRecord& record) {
    if (!record.has_best()) return describe_end(result);
    const FlowStep& best = record.best_step();
    const FlowStep& last = record.last_step();
    const std::string end = describe_end(result);
    std::string text = end.empty() ? "" : end + "; ";
    text += joined("nearest to the exact surface after step ", best.step, " (t = ", in_short(best.time, 3),
                   " Å²): mean distance ", with_decimals(best.mean_distance, 3), " Å; this step is kept");
    if (last.step != best.step && !std::isnan(last.mean_distance))
        text += joined("; ", with_decimals(last.mean_distance, 3), " Å after step ", last.step,
                       ": without an anchor the exact surface is not a stable steady state");
    return text;
}

void add_start(FlowRecord& record, const BlockGrid& grid, const NodeField& start, double half_width) {
    record.add({interpolating_coefficients(grid, start, half_width), start}, {});
}

}  // namespace

bool needs_start(const SurfaceOptions& options, const FlowObserver& observer) {
    return std::isfinite(options.flow.time_step) || options.history || observer;
}

double flow_margin(const FlowOptions& options, double spacing) {
    const bool thin = is_one_solve(options) && options.curvature != CurvatureField::Sharp &&
                      options.half_width >= FlowOptions{}.half_width;
    return (options.half_width + (thin ? kThinRim : kBandRim)) * spacing + (options.anchor > 0.0 ? 0.0 : kRoom);
}

FlowOutcome run_flow(const FlowTask& task, DistanceBand band) {
    const AccessibleSurface& accessible = task.accessible;
    const std::shared_ptr<const BlockGrid>& grid = task.grid;
    const SurfaceOptions& options = task.options;
    const FlowOptions& flow = options.flow;
    const bool may_leave = flow.anchor == 0.0;
    const bool recorded = may_leave || options.history || task.run.observer;
    band.curvature = curvature_field(accessible, *grid, flow, band);
    FlowRecord record(accessible, grid, task.run.observer);
    FlowOutcome outcome;
    if (recorded) add_start(record, *grid, task.start, flow.half_width);

    int iterations_before = 0;
    const EvolutionObserver observe = [&](const EvolutionResult& at, double fraction) {
        if (recorded)
            record.add(at.state, {.step = at.steps,
                                  .time = at.time,
                                  .residual = at.residual,
                                  .solver_iterations = at.solver_iterations - iterations_before});
        iterations_before = at.solver_iterations;
        if (task.run.progress) task.run.progress("flow", fraction);
    };
    EvolutionResult result = evolve(*grid, {std::move(band), task.start}, flow, observe);

    outcome.summary = summarise(result);
    outcome.summary.explanation = may_leave ? describe_course(result, record) : describe_end(result);
    if (may_leave && record.has_best()) {
        outcome.summary.kept_step = record.best_step().step;
        outcome.state = record.take_best();
    } else {
        outcome.state = std::move(result.state);
    }
    outcome.history = record.take_history();
    return outcome;
}

}  // namespace meniscus
