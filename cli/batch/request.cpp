// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "batch/request.h"

#include <fmt/core.h>

#include <algorithm>
#include <memory>
#include <set>
#include <utility>

#include "batch/inputs.h"
#include "help.h"
#include "measure_request.h"
#include "meniscus/errors.h"
#include "option_words.h"
#include "output_plan.h"
#include "pockets_request.h"
#include "surface_request.h"

namespace meniscus::cli::batch {

namespace {

constexpr const char* kBatchExamples =
    "All other options of {0} apply to every input: see meniscus {0} --help.\n"
    "Results go to DIR/results.jsonl, a line of JSON per input; times and memory to\n"
    "DIR/times.jsonl. Exit codes: 0 all inputs succeeded; 6 some failed.\n"
    "Examples:\n"
    "  meniscus batch {0} structures --out results\n"
    "  meniscus batch {0} archive.tar --out results.tar --time-limit 600\n"
    "  meniscus batch {0} structures --out results --resume     continue it";

/// Names of what a batch decides itself: not passed on to the processes.
const std::set<std::string> kOwnNames{"INPUTS",        "--list",         "--base",     "--out",     "--jobs",
                                      "--time-limit",  "--memory-limit", "--resume",   "--shard",   "--collect",
                                      "--mixed-radii", "--quiet",        "--progress", "--threads", "-o",
                                      "--history",     "--help",         "--help-all"};

constexpr std::size_t kLeastMemory = 32;  // MB of address space, in which it starts and reads

/// "90", "90s", "15m", "2h" as seconds.
double parse_time(const std::string& option, const std::string& text) {
    double unit = 1.0;
    std::string number = text;
    if (!text.empty()) {
        const char last = text.back();
        if (last == 's' || last == 'm' || last == 'h') number.pop_back();
        if (last == 'm') unit = 60.0;
        if (last == 'h') unit = 3600.0;
    }
    try {
        return unit * parse_number(option, number, NumberRange::Positive);
    } catch (const UsageError&) {
        throw UsageError(fmt::format("{}: '{}' is not a time; write seconds, or for instance 15m or 2h", option, text));
    }
}

void check_ending(const char* option, const std::string& ending) {
    if (!ending.starts_with('.') && !ending.starts_with('_'))
        throw UsageError(
            fmt::format("{0} {1}: in a batch, outputs are named after their inputs; give only the ending, as in -o "
                        ".ply or -o _a.ply",
                        option, ending));
    if (ending.find('/') != std::string::npos)
        throw UsageError(fmt::format("{} {}: an ending cannot contain a folder", option, ending));
}

void check_kind(const std::string& command, const std::string& path) {
    if (command == "surface")
        kind_of(path);
    else if (command == "measure")
        measure_kind_of(path);
    else
        plan_pockets_outputs({path}, "");
}

void check_endings(const Request& request) {
    for (const std::string& ending : request.endings) {
        check_ending("-o", ending);
        check_kind(request.command, "NAME" + ending);
    }
    if (request.history.empty()) return;
    check_ending("--history", request.history);
    plan_history("NAME" + request.history, "");
}

/// The words that give an option again what it was given.
void append_words(const CLI::Option& option, std::vector<std::string>& words) {
    const std::string name = option.get_name(false, false);
    if (option.get_items_expected_max() == 0) {
        words.push_back(name);
        return;
    }
    for (const std::string& value : option.results()) words.push_back(fmt::format("{}={}", name, value));
}

/// What was given of the options that are not the batch's own.
std::vector<std::string> passed_on(const CLI::App& command) {
    std::vector<std::string> words;
    for (const CLI::Option* option : command.get_options())
        if (option->count() > 0 && !kOwnNames.contains(option->get_name(option->get_positional(), false)))
            append_words(*option, words);
    return words;
}

void add_own_options(CLI::App& command, Request& request) {
    command
        .add_option("INPUTS", request.inputs,
                    "files, folders (with subfolders), .tar archives; - for a list on standard input")
        ->type_name("");
    command.option_defaults()->group("Batch");
    command.add_option("--list", request.list, "A file with one input per line")->type_name("FILE");
    command.add_option("--base", request.base, "Name inputs by their paths below DIR")->type_name("DIR");
    command
        .add_option("--out", request.out,
                    "Where outputs go\n, laid out like the inputs: a folder, or an archive (.tar)")
        ->required()
        ->type_name("DIR|X.tar");
    add_count(command, {"--jobs", "Processes at a time\n, one per input", "N", "all cores"}, request.jobs);
    add_word(command, {"--time-limit", "For each input: 90 (seconds), 15m, 2h", "T"},
             [&request](const std::string& text) { request.time_limit = parse_time("--time-limit", text); });
    const auto memory = [&request](const std::string& text) {
        request.memory_limit_mb = parse_memory("--memory-limit", text);
        if (request.memory_limit_mb < kLeastMemory)
            throw UsageError(fmt::format("--memory-limit: must be at least {}M, which the program itself needs, not {}",
                                         kLeastMemory, text));
    };
    add_word(command, {"--memory-limit", "For each input: 500M, 4G", "LIMIT"}, memory);
    command.add_flag("--resume", request.resume, "Skip what is done, retry what failed");
    add_word(command,
             {"--shard", "Part I of N of the inputs, from 0\n; in a Slurm array, each task takes its own part", "I/N"},
             [&request](const std::string& text) { request.shard = parse_shard(text); });
    command.add_flag("--collect", request.collect,
                     "Merge the results of all shards\n; without inputs, do nothing else");
    command.add_flag("--mixed-radii", request.may_mix_radii, "Let --radii auto choose for each input");
}

void fill(Request& request, const CLI::App& command, const CommonRequest& given) {
    request.command = command.get_name();
    request.options = passed_on(command);
    request.endings = given.outputs;
    if (request.command == "surface" && request.endings.empty()) request.endings = {".ply"};
    check_endings(request);
    if (is_packed_archive(request.out))
        throw UsageError("--out " + request.out + ": archives of outputs are not compressed; name a folder, or a .tar");
    request.may_mix_radii = request.may_mix_radii || given.read.radii != "auto";
    request.quiet = given.quiet;
    request.progress = given.progress;
    if (request.inputs.empty() && request.list.empty() && !request.collect)
        throw UsageError("INPUTS: missing; name files, folders or archives, see meniscus batch " + request.command +
                         " --help");
}

/// What the options of the same subcommand outside of a batch become within one.
void adapt_options(CLI::App& command) {
    command.remove_option(command.get_option("INPUT"));
    command.remove_option(command.get_option("--report"));
    command.remove_option(command.get_option("--format"));
    for (CLI::Option* option : command.get_options())
        if (option != command.get_help_ptr() && option != command.get_help_all_ptr())
            option->description(rarely(option->get_description()));
    command.get_option("-o")
        ->description("Ending of an output\n, added to the input's name; repeatable")
        ->type_name(".SUFFIX");
}

/// Makes a subcommand with its usual options one of a batch.
/// take   moves what only this subcommand has to the request, and returns what it has in common with others
void complete_subcommand(CLI::App& command, Request& request, const std::function<const CommonRequest&()>& take,
                         const std::function<void()>& run) {
    adapt_options(command);
    add_own_options(command, request);
    command.footer(fmt::format(kBatchExamples, command.get_name()));
    command.callback([&command, &request, take, run] {
        fill(request, command, take());
        run();
    });
}

void add_surface(CLI::App& batch, Request& request, const std::function<void()>& run) {
    CLI::App& command = *batch.add_subcommand("surface", "The surface of every input");
    const auto given = std::make_shared<SurfaceRequest>();
    add_surface_options(command, *given);
    const auto take = [&request, given]() -> const CommonRequest& {
        request.threads = given->run.threads;
        request.history = given->history;
        return *given;
    };
    complete_subcommand(command, request, take, run);
}

void add_measure(CLI::App& batch, Request& request, const std::function<void()>& run) {
    CLI::App& command = *batch.add_subcommand("measure", "Exact areas and volumes of every input");
    const auto given = std::make_shared<MeasureRequest>();
    add_measure_options(command, *given);
    const auto take = [&request, given]() -> const CommonRequest& {
        request.threads = given->measure.threads;
        return *given;
    };
    complete_subcommand(command, request, take, run);
}

void add_pockets(CLI::App& batch, Request& request, const std::function<void()>& run) {
    CLI::App& command = *batch.add_subcommand("pockets", "The pockets of every input");
    const auto given = std::make_shared<PocketsRequest>();
    add_pockets_options(command, *given);
    for (const char* one_for_all : {"--over-models", "--tunnel-table"})
        command.remove_option(command.get_option(one_for_all));
    const auto take = [&request, given]() -> const CommonRequest& {
        request.threads = given->run.threads;
        return *given;
    };
    complete_subcommand(command, request, take, run);
}

}  // namespace

void add_subcommands(CLI::App& batch, Request& request, const std::function<void()>& run) {
    batch.require_subcommand(1);
    add_surface(batch, request, run);
    add_measure(batch, request, run);
    add_pockets(batch, request, run);
}

}  // namespace meniscus::cli::batch
