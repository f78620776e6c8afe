// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Which evolution runs: one of three by name, and its pieces one by one.
#pragma once

#include <optional>
#include <string>

#include "meniscus/flow.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace meniscus::cli {

enum class FlowName { Anchored, Parallel, Paper };

/// What was asked for; pieces that are not given are those of the named flow.
struct FlowRequest {
    FlowName name = FlowName::Anchored;
    std::optional<CurvatureField> curvature;
    std::optional<double> anchor;
    std::optional<Reinitialiser> reinitialiser;
    std::optional<Solver> solver;
    std::optional<Slope> slope;
    std::optional<double> time_step;
    std::optional<double> half_width;
    std::optional<int> max_steps;
    std::optional<double> tolerance;
    std::string history;  ///< path of the record, empty for none
    int snapshots = 0;    ///< a mesh every so many steps, 0 for none
};

/// Gives a subcommand the options of the flow; `request` must outlive the parser.
void add_flow_options(CLI::App& command, FlowRequest& request);

FlowOptions resolve(const FlowRequest& request);

const char* name_of(FlowName name);
const char* name_of(CurvatureField field);
const char* name_of(Reinitialiser reinitialiser);
const char* name_of(Solver solver);
const char* name_of(Slope slope);
const char* name_of(FlowEnd end);

}  // namespace meniscus::cli
