// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What `surface` and `measure` are asked in the same words: the input, which atoms of it, where to report.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "meniscus/structure.h"
#include "output_plan.h"
#include "progress_report.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace meniscus::cli {

/// In the place of a model's position: all of them, put together.
inline constexpr int kJoinedModels = 0;

/// "--hetero ligands", "--waters": an option of reading as the command line has it, see OptionSpelling.
std::string spell_as_option(std::string_view option, std::string_view value);

struct CommonRequest {
    std::string input;  ///< path, or "-" for standard input
    ReadOptions read{.spelling = spell_as_option};
    bool all_models = false;           ///< every model as a structure of its own; read.model is then not used
    bool per_chain = false;            ///< every chain as a structure of its own
    std::vector<std::string> outputs;  ///< -o, in order
    std::string format;                ///< of the output that goes to standard output; empty if not given
    std::string report;                ///< path, "-" for standard output, empty for none
    bool quiet = false;
    ProgressMode progress = ProgressMode::Auto;
};

/// What reads a model of the input again, as it was read.
///
/// model   as Job::model
ReadOptions options_of_model(const CommonRequest& request, int model);

/// INPUT and the file of --radii, if there is one.
std::vector<ReadFile> files_of_structure(const std::string& input, const ReadOptions& options);

/// INPUT itself.
void add_input(CLI::App& command, CommonRequest& request);

/// Which atoms of the input are kept, and with which radii. `request` must outlive the parser.
void add_atom_options(CLI::App& command, CommonRequest& request);

/// -o, --format, --report, --quiet.
void add_output_options(CLI::App& command, CommonRequest& request);

void add_progress(CLI::App& command, ProgressMode& progress);

/// Joins an option and a negative number or a list that begins with one ("--density" "-.5") with "=", because CLI11
/// takes some negative numbers for options.
std::vector<std::string> join_negative_values(const std::vector<std::string>& arguments);

}  // namespace meniscus::cli
