// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "batch/command.h"

#include <fmt/core.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <memory>
#include <utility>

#include "batch/records.h"
#include "batch/run.h"
#include "messages.h"
#include "reading/text.h"
#include "report.h"

namespace meniscus::cli {

using nlohmann::ordered_json;

namespace {

constexpr const char* kExamples =
    "Examples:\n"
    "  meniscus batch measure structures --out results        every file of a folder\n"
    "  meniscus batch surface a.pdb b.cif --out meshes -o .ply  a mesh for each\n"
    "Options: meniscus help batch measure, and so for surface and pockets.";

constexpr std::size_t kMostRows = 50;  // of failures that are shown

/// The length of the longest text under a key.
std::size_t longest(const std::vector<ordered_json>& results, const char* key) {
    std::size_t length = 0;
    for (const ordered_json& result : results) length = std::max(length, result[key].get<std::string>().size());
    return length;
}

/// A table of what failed, by name.
std::string table_of_failures(const std::vector<ordered_json>& failed) {
    const std::size_t width = std::min(longest(failed, "input"), std::size_t{40});
    const std::size_t width_of_status = longest(failed, "status");
    std::string text;
    for (std::size_t i = 0; i < std::min(failed.size(), kMostRows); ++i)
        text += fmt::format("  {:<{}}  {:<{}}  {}\n", one_line(failed[i]["input"].get<std::string>()), width,
                            failed[i]["status"].get<std::string>(), width_of_status,
                            one_line(failed[i]["error"].get<std::string>()));
    if (failed.size() > kMostRows) text += fmt::format("  and {} more\n", failed.size() - kMostRows);
    return text;
}

}  // namespace

void add_batch_command(CLI::App& program, Outcome& outcome) {
    CLI::App* command = program.add_subcommand("batch", "Many inputs, a line of results for each");
    command->footer(kExamples);
    const auto request = std::make_shared<batch::Request>();
    batch::add_subcommands(*command, *request, [request, &outcome] { outcome = run_batch(*request); });
}

Outcome run_batch(const batch::Request& request) {
    const bool computes = !request.inputs.empty() || !request.list.empty();
    batch::Shard shard;
    if (computes) shard = request.shard ? *request.shard : batch::shard_of_array().value_or(batch::Shard{});
    const batch::Places places(request.out, shard);
    const bool collects = request.collect || shard.count == 1;
    std::vector<ordered_json> failed;
    std::string summary;
    if (computes) {
        batch::RunResult result = batch::run(request, shard, places);
        summary = fmt::format("{}  {}, {} failed, {} already done, {:.1f} s\n", places.outputs(),
                              reading::counted(result.inputs, "input"), result.failed.size(), result.done_before,
                              result.seconds);
        failed = std::move(result.failed);
    }
    if (collects) {
        batch::Collected collected = batch::collect(places);
        summary += fmt::format("{}  {}, {} failed\n", places.results(), reading::counted(collected.inputs, "line"),
                               collected.failed.size());
        failed = std::move(collected.failed);
    }
    if (!request.quiet) print(summary + table_of_failures(failed));
    return failed.empty() ? Outcome::Done : Outcome::ChecksFailed;
}

}  // namespace meniscus::cli
