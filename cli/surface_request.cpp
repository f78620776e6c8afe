// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_request.h"

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <utility>

#include "meniscus/errors.h"
#include "numbers.h"

namespace meniscus::cli {

namespace {

template <class T, std::size_t N>
using Words = std::array<std::pair<const char*, T>, N>;

constexpr Words<Method, 3> kMethods{
    {{"flow", Method::Flow}, {"direct", Method::Direct}, {"gaussian", Method::Gaussian}}};
constexpr Words<HydrogenPolicy, 3> kHydrogens{
    {{"auto", HydrogenPolicy::Auto}, {"keep", HydrogenPolicy::Keep}, {"drop", HydrogenPolicy::Drop}}};
constexpr Words<HeteroPolicy, 3> kHetero{
    {{"none", HeteroPolicy::None}, {"ligands", HeteroPolicy::Ligands}, {"all", HeteroPolicy::All}}};
constexpr Words<ProgressMode, 4> kProgress{
    {{"auto", ProgressMode::Auto}, {"on", ProgressMode::On}, {"off", ProgressMode::Off}, {"json", ProgressMode::Json}}};
constexpr Words<const char*, 1> kFlows{{{"anchored", "anchored"}}};

constexpr const char* kFormats =
    "-o writes meshes (.ply .obj .stl .off), with the table NAME.atoms.csv beside them, and the kept atoms\n"
    "(.xyzr .xyzrn). Without -o the mesh goes to NAME.ply in the current folder.";

template <class T, std::size_t N>
const char* word_for(const Words<T, N>& words, T value) {
    return std::find_if(words.begin(), words.end(), [&](const auto& w) { return w.second == value; })->first;
}

template <class T, std::size_t N>
std::string join(const Words<T, N>& words, const char* separator) {
    std::string list;
    for (const auto& word : words) list.append(list.empty() ? "" : separator).append(word.first);
    return list;
}

/// An option whose value is one of a few words.
template <class Target, class T, std::size_t N>
void add_choice(CLI::App& command, const char* name, Target& target, const Words<T, N>& words, const char* text) {
    const auto choose = [name, &target, &words](const std::string& value) {
        const auto found = std::find_if(words.begin(), words.end(), [&](const auto& w) { return value == w.first; });
        if (found == words.end())
            throw UsageError(fmt::format("{}: unknown value '{}'; one of {}", name, value, join(words, ", ")));
        target = found->second;
    };
    command.add_option_function<std::string>(name, choose, text)
        ->type_name(join(words, "|"))
        ->default_str(words.front().first);
}

void add_number(CLI::App& command, const char* name, double& target, Sign sign, const char* symbol, const char* text) {
    const auto read = [name, &target, sign](const std::string& value) { target = parse_number(name, value, sign); };
    command.add_option_function<std::string>(name, read, text)
        ->type_name(symbol)
        ->default_str(fmt::format("{}", target));
}

CLI::Option* add_count(CLI::App& command, const char* name, int& target, const char* text) {
    const auto read = [name, &target](const std::string& value) { target = parse_count(name, value); };
    return command.add_option_function<std::string>(name, read, text)->type_name("N");
}

std::vector<std::string> split_chains(const std::string& list) {
    std::vector<std::string> chains = CLI::detail::split(list, ',');
    if (list.empty() || std::find(chains.begin(), chains.end(), "") != chains.end())
        throw UsageError(fmt::format("--chains: empty name in '{}'; write --chains A,B", list));
    return chains;
}

void set_model(SurfaceRequest& request, const std::string& text) {
    request.all_models = text == "all";
    if (!request.all_models) request.read.model = parse_count("--model", text);
}

void set_altloc(SurfaceRequest& request, const std::string& text) {
    if (text.size() != 1) throw UsageError(fmt::format("--altloc: must be one character, not '{}'", text));
    request.read.altloc = text;
}

void add_atom_options(CLI::App& command, SurfaceRequest& request) {
    ReadOptions& read = request.read;
    command.add_option("--radii", read.radii, "bondi, united, protor, naccess, parse, auto, or a file of rules")
        ->type_name("SET")
        ->capture_default_str();
    add_choice(command, "--hydrogens", read.hydrogens, kHydrogens, "Hydrogens: as the radii need, keep, or drop");
    const auto model = [&request](const std::string& text) { set_model(request, text); };
    command.add_option_function<std::string>("--model", model, "Model to read, counted from 1, or all of them")
        ->type_name("N|all")
        ->default_str("1");
    command.add_option("--assembly", read.assembly, "Biological assembly named in the file")->type_name("ID");
    const auto altloc = [&request](const std::string& text) { set_altloc(request, text); };
    command
        .add_option_function<std::string>("--altloc", altloc, "Alternative location instead of the highest occupancy")
        ->type_name("ID");
    const auto chains = [&read](const std::string& text) { read.chains = split_chains(text); };
    command.add_option_function<std::string>("--chains", chains, "Chains to keep; label:A for mmCIF label names")
        ->type_name("A,B");
    command.add_option("--select", read.select, "Atoms to keep, in gemmi's selection syntax")->type_name("EXPR");
    add_choice(command, "--hetero", read.hetero, kHetero, "Hetero atoms to keep beside the polymer");
    command.add_flag("--waters", read.keep_waters, "Keep waters");
    command.add_flag("--strict-radii", read.strict_radii, "Refuse atoms of unknown type");
}

void add_shape_options(CLI::App& command, SurfaceRequest& request) {
    SurfaceOptions& surface = request.surface;
    add_number(command, "--probe", surface.probe, Sign::NotNegative, "R", "Probe radius, Å; 0: van der Waals surface");
    add_choice(command, "--method", surface.method, kMethods, "Smooth flow, sharp direct, or only the Gaussian start");
    add_choice(command, "--flow", request.flow, kFlows, "Which evolution the flow runs");
    add_number(command, "--spacing", surface.spacing, Sign::Positive, "H", "Grid spacing, Å");
    add_number(command, "--density", surface.density, Sign::Negative, "C",
               "Constant of the initial Gaussian map, Å^-2");
    add_number(command, "--time-step", surface.time_step, Sign::Positive, "T", "Time step of the flow, in units of H²");
    add_count(command, "--max-steps", surface.max_steps, "Most steps of the flow")
        ->default_str(fmt::format("{}", surface.max_steps));
}

void add_output_options(CLI::App& command, SurfaceRequest& request) {
    command.add_option("-o", request.outputs, "File to write, in the format of its suffix; may be given several times")
        ->type_name("FILE")
        ->allow_extra_args(false);
    const auto ascii = [&request](std::int64_t) { request.encoding = Encoding::Text; };
    command.add_flag_function("--ascii", ascii, "Write PLY and STL as text");
    command.add_option("--report", request.report, "Report as JSON; - for standard output")->type_name("FILE");
    command.add_flag("--quiet", request.quiet, "No summary and no progress bar");
}

void add_run_options(CLI::App& command, SurfaceRequest& request) {
    add_count(command, "--threads", request.surface.threads, "Threads; the result does not depend on it")
        ->default_str("all cores");
    const auto memory = [&request](const std::string& text) {
        request.surface.memory_limit_mb = parse_memory("--memory", text);
    };
    command.add_option_function<std::string>("--memory", memory, "Refuse what would need more, e.g. 4G or 500M")
        ->type_name("LIMIT");
    add_choice(command, "--progress", request.progress, kProgress, "Progress on standard error");
}

}  // namespace

void add_surface_options(CLI::App& command, SurfaceRequest& request) {
    command
        .add_option("INPUT", request.input,
                    "Structure: .pdb .ent .cif .mmcif .pqr .xyzr .xyzrn, each also .gz; - for standard input")
        ->required()
        ->type_name("");
    command.footer(kFormats);
    command.option_defaults()->group("Atoms");
    add_atom_options(command, request);
    command.option_defaults()->group("Surface");
    add_shape_options(command, request);
    command.option_defaults()->group("Output");
    add_output_options(command, request);
    command.option_defaults()->group("Running");
    add_run_options(command, request);
}

const char* name_of(Method method) { return word_for(kMethods, method); }
const char* name_of(HydrogenPolicy policy) { return word_for(kHydrogens, policy); }
const char* name_of(HeteroPolicy policy) { return word_for(kHetero, policy); }

std::vector<std::string> join_negative_values(const std::vector<std::string>& arguments) {
    std::vector<std::string> joined;
    for (const std::string& argument : arguments) {
        const bool after_option =
            !joined.empty() && joined.back().starts_with("--") && joined.back().find('=') == std::string::npos;
        if (after_option && looks_like_negative_number(argument))
            joined.back() += "=" + argument;
        else
            joined.push_back(argument);
    }
    return joined;
}

}  // namespace meniscus::cli
