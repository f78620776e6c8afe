// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "flow_request.h"

#include <limits>

#include "help.h"
#include "option_words.h"

namespace meniscus::cli {

namespace {

constexpr Words<FlowName, 3> kFlows{
    {{"anchored", FlowName::Anchored}, {"parallel", FlowName::Parallel}, {"paper", FlowName::Paper}}};

double parse_time_step(const std::string& text) {
    if (text == "inf") return std::numeric_limits<double>::infinity();
    return parse_number("--time-step", text, Sign::Positive);
}

/// The three named flows.
const FlowOptions& named(FlowName name) {
    switch (name) {
        case FlowName::Parallel:
            return kParallelFlow;
        case FlowName::Paper:
            return kPaperFlow;
        case FlowName::Anchored:
            break;
    }
    return kAnchoredFlow;
}

}  // namespace

void add_flow_options(CLI::App& command, FlowRequest& request) {
    add_choice(command, {"--flow", rarely("Evolution that the flow follows; the options below modify it")},
               request.name, kFlows);
    const auto of_flow = [](const char* name, const char* text, const char* symbol) {
        return OptionHelp{name, rarely(text), symbol, "of the flow"};
    };
    add_choice(command, of_flow("--curvature", "Curvature field", ""), request.curvature, kCurvatureWords);
    add_number(command, of_flow("--anchor", "Strength of the anchor, in units of 1/H²; 0: none", "L"), request.anchor,
               Sign::NotNegative);
    add_choice(command, of_flow("--reinitialise", "How the level set is kept a signed distance", ""),
               request.reinitialiser, kReinitialiserWords);
    add_choice(command, of_flow("--solver", "Solver of the linear systems", ""), request.solver, kSolverWords);
    add_choice(command, of_flow("--slope", "Factor |grad| of the curvature", ""), request.slope, kSlopeWords);
    add_word(command, of_flow("--time-step", "Time step, in units of H²; inf: a single solve", "T"),
             [&request](const std::string& text) { request.time_step = parse_time_step(text); });
    add_number(command,
               of_flow("--half-width", "Half-width of the band: nodes within K*H of the surface are unknowns", "K"),
               request.half_width, Sign::Positive);
    add_count(command, of_flow("--max-steps", "Maximum number of steps", "N"), request.max_steps);
    add_number(command,
               of_flow("--tolerance",
                       "Stop when the distance left to go is below E*H; without an anchor, when the speed is below E, "
                       "1/Å",
                       "E"),
               request.tolerance, Sign::Positive);
    command.add_option("--history", request.history, rarely("Record of every step, .csv or .json"))->type_name("FILE");
    add_count(command, {"--snapshots", rarely("Write a mesh every N steps")}, request.snapshots);
}

FlowOptions resolve(const FlowRequest& request) {
    FlowOptions flow = named(request.name);
    flow.curvature = request.curvature.value_or(flow.curvature);
    flow.anchor = request.anchor.value_or(flow.anchor);
    flow.reinitialiser = request.reinitialiser.value_or(flow.reinitialiser);
    flow.solver = request.solver.value_or(flow.solver);
    flow.slope = request.slope.value_or(flow.slope);
    flow.time_step = request.time_step.value_or(flow.time_step);
    flow.half_width = request.half_width.value_or(flow.half_width);
    flow.max_steps = request.max_steps.value_or(flow.max_steps);
    flow.tolerance = request.tolerance.value_or(flow.tolerance);
    return flow;
}

const char* name_of(FlowName name) { return word_for(kFlows, name); }
const char* name_of(CurvatureField field) { return word_for(kCurvatureWords, field); }
const char* name_of(Reinitialiser reinitialiser) { return word_for(kReinitialiserWords, reinitialiser); }
const char* name_of(Solver solver) { return word_for(kSolverWords, solver); }
const char* name_of(Slope slope) { return word_for(kSlopeWords, slope); }
const char* name_of(FlowEnd end) { return word_for(kFlowEndWords, end); }

}  // namespace meniscus::cli
