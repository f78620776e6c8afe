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

constexpr const char* kOfTheFlow = "of the flow";

/// An option whose default is a matter of the flow.
template <class Target, class Parse>
void add_piece(CLI::App& command, const char* name, Target& target, const std::string& type, const std::string& text,
               const Parse& parse) {
    command
        .add_option_function<std::string>(
            name, [&target, parse](const std::string& value) { target = parse(value); }, text)
        ->type_name(type)
        ->default_str(kOfTheFlow);
}

template <class T, std::size_t N>
void add_word(CLI::App& command, const char* name, std::optional<T>& target, const Words<T, N>& words,
              const std::string& text) {
    add_piece(command, name, target, join(words, "|"), text,
              [name, &words](const std::string& value) { return parse_word(name, value, words); });
}

void add_positive(CLI::App& command, const char* name, std::optional<double>& target, Sign sign, const char* symbol,
                  const std::string& text) {
    add_piece(command, name, target, symbol, text,
              [name, sign](const std::string& value) { return parse_number(name, value, sign); });
}

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
    add_choice(command, "--flow", request.name, kFlows,
               rarely("Evolution that the flow follows; the options below modify it"));
    add_word(command, "--curvature", request.curvature, kCurvatureWords, rarely("Curvature field"));
    add_positive(command, "--anchor", request.anchor, Sign::NotNegative, "L",
                 rarely("Strength of the anchor, in units of 1/H²; 0: none"));
    add_word(command, "--reinitialise", request.reinitialiser, kReinitialiserWords,
             rarely("How the level set is kept a signed distance"));
    add_word(command, "--solver", request.solver, kSolverWords, rarely("Solver of the linear systems"));
    add_word(command, "--slope", request.slope, kSlopeWords, rarely("Factor |grad| of the curvature"));
    add_piece(command, "--time-step", request.time_step, "T", rarely("Time step, in units of H²; inf: a single solve"),
              parse_time_step);
    add_positive(command, "--half-width", request.half_width, Sign::Positive, "K",
                 rarely("Half-width of the band: nodes within K*H of the surface are unknowns"));
    add_piece(command, "--max-steps", request.max_steps, "N", rarely("Maximum number of steps"),
              [](const std::string& value) { return parse_count("--max-steps", value); });
    add_positive(
        command, "--tolerance", request.tolerance, Sign::Positive, "E",
        rarely("Stop when the distance left to go is below E*H; without an anchor, when the speed is below E, 1/Å"));
    command.add_option("--history", request.history, rarely("Record of every step, .csv or .json"))->type_name("FILE");
    add_count(command, "--snapshots", request.snapshots, rarely("Write a mesh every N steps"));
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
