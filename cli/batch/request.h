// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What `meniscus batch surface|measure|pockets` is asked to do, and the options that ask it.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "batch/plan.h"
#include "progress_report.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace meniscus::cli::batch {

struct Request {
    std::string command;               ///< "surface", "measure" or "pockets"
    std::vector<std::string> options;  ///< of the subcommand, as every process gets them
    std::vector<std::string> endings;  ///< of outputs: ".ply"; they follow an input's name
    std::string history;               ///< ending of records of the flow, or empty
    std::vector<std::string> inputs;
    std::string list;
    std::string base;
    std::string out;
    std::optional<Shard> shard;
    int jobs = 0;     ///< processes at once; 0 for as many as cores
    int threads = 0;  ///< of each; 0 for what jobs leave
    double time_limit = 0.0;
    std::size_t memory_limit_mb = 0;
    bool resume = false;
    bool collect = false;
    bool may_mix_radii = false;  ///< because that was asked for, or because one set was chosen
    bool quiet = false;
    ProgressMode progress = ProgressMode::Auto;
};

/// Gives `batch` its two subcommands with their options. Parsing fills `request` and calls `run`, which like `request`
/// must outlive the parser.
///
/// While parsing, UsageError is thrown for values that make no sense, CLI::ParseError for everything that
/// CLI11 itself refuses.
void add_subcommands(CLI::App& batch, Request& request, const std::function<void()>& run);

}  // namespace meniscus::cli::batch
