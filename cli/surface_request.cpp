// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_request.h"

#include "option_words.h"

namespace meniscus::cli {

namespace {

constexpr Words<Method, 3> kMethods{
    {{"flow", Method::Flow}, {"direct", Method::Direct}, {"gaussian", Method::Gaussian}}};
constexpr Words<const char*, 1> kFlows{{{"anchored", "anchored"}}};

constexpr const char* kFormats =
    "-o writes meshes (.ply .obj .stl .off), with the table NAME.atoms.csv beside them, and the kept atoms\n"
    "(.xyzr .xyzrn). Without -o the mesh goes to NAME.ply in the current folder.";

void add_shape_options(CLI::App& command, SurfaceRequest& request) {
    SurfaceOptions& surface = request.surface;
    add_probe(command, surface.probe);
    add_choice(command, "--method", surface.method, kMethods, "Smooth flow, sharp direct, or only the Gaussian start");
    add_choice(command, "--flow", request.flow, kFlows, "Which evolution the flow runs");
    add_number(command, "--spacing", surface.spacing, Sign::Positive, "H", "Grid spacing, Å");
    add_number(command, "--density", surface.density, Sign::Negative, "C",
               "Constant of the initial Gaussian map, Å^-2");
    add_number(command, "--time-step", surface.time_step, Sign::Positive, "T", "Time step of the flow, in units of H²");
    add_count(command, "--max-steps", surface.max_steps, "Most steps of the flow")
        ->default_str(fmt::format("{}", surface.max_steps));
}

void add_encoding(CLI::App& command, SurfaceRequest& request) {
    const auto ascii = [&request](std::int64_t) { request.encoding = Encoding::Text; };
    command.add_flag_function("--ascii", ascii, "Write PLY and STL as text");
}

void add_memory_limit(CLI::App& command, SurfaceRequest& request) {
    const auto memory = [&request](const std::string& text) {
        request.surface.memory_limit_mb = parse_memory("--memory", text);
    };
    command.add_option_function<std::string>("--memory", memory, "Refuse what would need more, e.g. 4G or 500M")
        ->type_name("LIMIT");
}

}  // namespace

void add_surface_options(CLI::App& command, SurfaceRequest& request) {
    add_input(command, request);
    command.footer(kFormats);
    command.option_defaults()->group("Atoms");
    add_atom_options(command, request);
    command.option_defaults()->group("Surface");
    add_shape_options(command, request);
    command.option_defaults()->group("Output");
    add_output_options(command, request);
    add_encoding(command, request);
    command.option_defaults()->group("Running");
    add_run_options(command, request, request.surface.threads);
    add_memory_limit(command, request);
}

const char* name_of(Method method) { return word_for(kMethods, method); }

}  // namespace meniscus::cli
