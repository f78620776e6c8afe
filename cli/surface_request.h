// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What `meniscus surface` is asked to do, and the options that ask it.
#pragma once

#include <string>
#include <vector>

#include "meniscus/structure.h"
#include "meniscus/surface.h"
#include "meniscus/write.h"
#include "progress_report.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace meniscus::cli {

struct SurfaceRequest {
    std::string input;  ///< path, or "-" for standard input
    ReadOptions read;
    bool all_models = false;  ///< every model as a structure of its own; read.model is then not used
    SurfaceOptions surface;
    std::string flow = "anchored";     ///< which evolution Method::Flow runs
    std::vector<std::string> outputs;  ///< -o, in order; empty: NAME.ply in the current folder
    Encoding encoding = Encoding::Binary;
    std::string report;  ///< path, "-" for standard output, empty for none
    bool quiet = false;
    ProgressMode progress = ProgressMode::Auto;
};

/// Gives a subcommand its options; parsing fills `request`, which must outlive the parser.
///
/// While parsing, UsageError is thrown for values that make no sense, CLI::ParseError for everything that
/// CLI11 itself refuses.
void add_surface_options(CLI::App& command, SurfaceRequest& request);

/// The words behind `--method`, `--hydrogens` and `--hetero`.
const char* name_of(Method method);
const char* name_of(HydrogenPolicy policy);
const char* name_of(HeteroPolicy policy);

/// Joins an option and a negative number after it ("--density" "-.5") with "=", because CLI11 takes some negative
/// numbers for options.
std::vector<std::string> join_negative_values(const std::vector<std::string>& arguments);

}  // namespace meniscus::cli
