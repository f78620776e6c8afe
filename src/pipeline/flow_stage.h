// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The flow of one surface with its record: which state is the result, and what each step looked like.
#pragma once

#include <memory>
#include <vector>

#include "band/distance_band.h"
#include "flow/evolution.h"
#include "geometry/accessible_surface.h"
#include "meniscus/progress.h"
#include "meniscus/surface.h"

namespace meniscus {

/// How far the band of a flow reaches on both sides of the SES, Å. Without an anchor surfaces wander off.
double flow_margin(const FlowOptions& options, double spacing);

/// Whether the flow, or what is asked about it, depends on where it starts.
bool needs_start(const SurfaceOptions& options, const FlowObserver& observer);

struct FlowTask {
    const AccessibleSurface& accessible;
    const std::shared_ptr<const BlockGrid>& grid;
    const NodeField& start;
    const SurfaceOptions& options;
    const RunOptions& run;
};

struct FlowOutcome {
    FlowState state;
    FlowSummary summary;
    std::vector<FlowStep> history;
};

/// Runs the flow from the task's node values `start`, which may be missing where it needs none. Steps are meshed for
/// `observer`, for the history where options ask for it, and for a flow without an anchor, of which the state nearest
/// to the SES is the result.
FlowOutcome run_flow(const FlowTask& task, DistanceBand band);

}  // namespace meniscus
