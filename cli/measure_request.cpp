// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure_request.h"

#include <fmt/core.h>

#include "meniscus/file_words.h"
#include "option_words.h"
#include "output_plan.h"

namespace meniscus::cli {

namespace {

constexpr const char* kMeasureExamples =
    "-o writes tables (.csv .json), or the kept atoms with a value in the B-factor\n"
    "column (.pdb .cif).\n"
    "Examples:\n"
    "  meniscus measure 1abc.pdb                             areas, volumes, cavities\n"
    "  meniscus measure 1abc.pdb -o residues.csv             a table per residue\n"
    "  meniscus measure 1abc.pdb --between A:B               an interface\n"
    "  meniscus measure 1abc.pdb -o depth.pdb --value depth  depths as B factors";

std::size_t count_kind(const MeasureRequest& request, OutputKind kind) {
    return static_cast<std::size_t>(
        std::count_if(request.outputs.begin(), request.outputs.end(),
                      [&](const std::string& path) { return measure_kind_of(path) == kind; }));
}

}  // namespace

void add_measure_options(CLI::App& command, MeasureRequest& request) {
    add_input(command, request);
    command.footer(kMeasureExamples);
    command.option_defaults()->group("Atoms");
    add_atom_options(command, request);
    command.option_defaults()->group("Measures");
    OptionAdder{command}(kProbeOption, request.measure.probe);
    command
        .add_option("--between", request.between,
                    "Interface of groups of chains, as in A,C:B\n, or all: every pair of chains that touch; "
                    "repeatable. A ligand by its residue name in parentheses: 'A:(HEM)', 'A:B(HEM)'")
        ->type_name("A:B|all")
        ->allow_extra_args(false);
    command.option_defaults()->group("Output");
    add_output_options(command, request);
    add_choices(command,
                {"--per",
                 "What each row of a table stands for\n"
                 "; the first --per applies to the first table, the second to the second, the last to all that follow"},
                request.per, kRowsPerWords);
    add_choices(command, {"--value", "Value written as the B factor\n; one per copy, in their order, as with --per"},
                request.values, kAtomValueWords);
    command.option_defaults()->group("Running");
    OptionAdder{command}(kThreadsOption, request.measure.threads);
    add_progress(command, request.progress);
}

void check_request(const MeasureRequest& request) {
    const std::size_t tables = count_kind(request, OutputKind::Table);
    const std::size_t copies = count_kind(request, OutputKind::StructureCopy);
    if (request.per.size() > tables)
        throw UsageError("--per: each needs a table of its own; add -o FILE.csv or --format csv");
    if (request.values.size() > copies)
        throw UsageError("--value: each needs a copy of the structure of its own; add -o FILE.pdb");
    if (request.between.empty()) return;
    for (const std::string& text : request.between)
        if (!parse_between(text) && request.between.size() > 1)
            throw UsageError("--between: all cannot be combined with other interfaces");
    if (std::find(request.per.begin(), request.per.end(), RowsPer::Cavity) != request.per.end())
        throw UsageError("--per cavity: an interface has no cavities; leave out --between");
}

std::string restate_between(const std::string& text) {
    std::string restated;
    for (const std::string& group : CLI::detail::split(text, ':'))
        restated += (restated.empty() ? "" : ":") + CLI::detail::join(split_group(group), ",");
    return restated == text ? "" : restated;
}

std::optional<ChainPair> parse_between(const std::string& text) {
    if (text == "all") return std::nullopt;
    if (std::optional<ChainPair> pair = split_pair(text)) return pair;
    throw UsageError(fmt::format("--between: '{}' is not a pair of groups; write --between A:B, A,C:B or all", text));
}

}  // namespace meniscus::cli
