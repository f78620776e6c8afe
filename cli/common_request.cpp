// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "common_request.h"

#include <fmt/core.h>

#include <filesystem>

#include "help.h"
#include "meniscus/file_words.h"
#include "option_words.h"

namespace meniscus::cli {

namespace {

constexpr Words<ProgressMode, 4> kProgress{
    {{"auto", ProgressMode::Auto}, {"on", ProgressMode::On}, {"off", ProgressMode::Off}, {"json", ProgressMode::Json}}};

std::vector<std::string> split_chains(const std::string& list) {
    std::vector<std::string> chains = CLI::detail::split(list, ',');
    if (list.empty() || std::find(chains.begin(), chains.end(), "") != chains.end())
        throw UsageError(fmt::format("--chains: empty name in '{}'; write --chains A,B", list));
    return chains;
}

void set_model(CommonRequest& request, const std::string& text) {
    request.all_models = text == "all";
    request.read.join_models = text == "join";
    if (request.all_models || request.read.join_models) return;
    if (text.find_first_not_of("+-0123456789") != std::string::npos)
        throw UsageError(fmt::format("--model: unknown value '{}'; write a number counted from 1, all or join", text));
    request.read.model = parse_count("--model", text);
}

void add_waters(CLI::App& command, std::optional<bool>& keep) {
    CLI::Option* yes = command.add_flag_function(
        "--waters", [&keep](std::int64_t) { keep = true; }, "Keep waters\n; those of PQR files: without a warning");
    command
        .add_flag_function(
            "--no-waters", [&keep](std::int64_t) { keep = false; },
            rarely("Leave out waters of PQR files, too, which are kept with a warning otherwise"))
        ->excludes(yes);
}

void set_altloc(CommonRequest& request, const std::string& text) {
    if (text.size() != 1) throw UsageError(fmt::format("--altloc: must be one character, not '{}'", text));
    request.read.altloc = text;
}

}  // namespace

std::string spell_as_option(std::string_view option, std::string_view value) {
    if (option == "keep_waters") return value == "false" ? "--no-waters" : "--waters";
    if (option == "model" && value == "N") return "--model N|all";
    return value.empty() ? flag_of(option) : flag_of(option) + " " + std::string(value);
}

ReadOptions options_of_model(const CommonRequest& request, int model) {
    ReadOptions options = request.read;
    options.join_models = model == kJoinedModels;
    if (!options.join_models) options.model = model;
    options.checksum = false;
    return options;
}

std::vector<ReadFile> files_of_structure(const std::string& input, const ReadOptions& options) {
    std::vector<ReadFile> files{{"the input", input}};
    std::error_code error;  // where there is no such file it is the name of a set
    if (std::filesystem::exists(options.radii, error)) files.push_back({"the file of --radii", options.radii});
    return files;
}

void add_input(CLI::App& command, CommonRequest& request) {
    command.add_option("INPUT", request.input, ".pdb .ent .cif .mmcif .bcif .gro .pdbqt .pqr .xyzr .xyzrn, .gz; or -")
        ->required()
        ->type_name("");
}

void add_atom_options(CLI::App& command, CommonRequest& request) {
    ReadOptions& read = request.read;
    command
        .add_option("--radii", read.radii,
                    "Radius set, or a file of rules\n: bondi, united, protor, naccess, parse; auto: the file's own for "
                    "PQR and xyzr, else bondi if the structure has hydrogens, else united")
        ->type_name("SET")
        ->capture_default_str();
    add_choice(command, {"--hydrogens", "Hydrogens; auto: as the radii require"}, read.hydrogens, kHydrogenWords);
    add_word(command,
             {"--model",
              "Model to read, counted from 1\n; all: each as a structure of its own; join: all together as one, copies "
              "of chain A being A-2, A-3 ...",
              "N|all|join", "1"},
             [&request](const std::string& text) { set_model(request, text); });
    command.add_option("--assembly", read.assembly, rarely("Biological assembly named in the file"))->type_name("ID");
    add_word(command,
             {"--altloc", rarely("Alternative location to use, instead of the one with the highest occupancy"), "ID"},
             [&request](const std::string& text) { set_altloc(request, text); });
    add_word(command, {"--chains", "Chains to keep\n, by author name; label:A for mmCIF label names", "A,B"},
             [&read](const std::string& text) { read.chains = split_chains(text); });
    add_word(command, {"--select", "Atoms to keep, as in //A/10-50\n, in gemmi's selection syntax", "EXPR"},
             [&read](const std::string& text) {
                 if (text.empty()) throw UsageError("--select: empty; write for instance //A/10-50");
                 read.select = text;
             });
    add_choice(command,
               {"--hetero",
                "Hetero atoms to keep\n beside the polymer: groups of two or more atoms (ligands), or ions and metals, "
                "too (all)"},
               read.hetero, kHeteroWords);
    add_waters(command, read.keep_waters);
    command.add_flag("--strict-radii", read.strict_radii,
                     rarely("Refuse atoms of unknown type instead of giving them their element's radius"));
}

void add_output_options(CLI::App& command, CommonRequest& request) {
    command
        .add_option("-o", request.outputs,
                    "File to write; its suffix is the format\n; repeatable; - is standard output, with --format")
        ->type_name("FILE")
        ->allow_extra_args(false);
    command
        .add_option("--format", request.format,
                    rarely("Write to standard output, in this format: a suffix without its point, as in ply or csv"))
        ->type_name("FORMAT");
    add_word(command, {"--report", "Report as JSON; - for standard output", "FILE"},
             [&request](const std::string& path) {
                 if (path.empty()) throw UsageError("--report: empty; name a file, or write - for standard output");
                 request.report = path == "/dev/stdout" ? "-" : path;
             });
    command.add_flag("-q,--quiet", request.quiet, "No summary, no notes, no progress bar");
}

void add_progress(CLI::App& command, ProgressMode& progress) {
    add_choice(command,
               {"--progress", rarely("Progress on standard error; auto: a bar on a terminal; json: a line per update")},
               progress, kProgress);
}

std::vector<std::string> join_negative_values(const std::vector<std::string>& arguments) {
    std::vector<std::string> joined;
    for (const std::string& argument : arguments) {
        const bool after_option =
            !joined.empty() && joined.back().starts_with("--") && joined.back().find('=') == std::string::npos;
        if (after_option && looks_like_negative_number(argument.substr(0, argument.find_first_of(",:"))))
            joined.back() += "=" + argument;
        else
            joined.push_back(argument);
    }
    return joined;
}

}  // namespace meniscus::cli
