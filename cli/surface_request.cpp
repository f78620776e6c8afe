// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_request.h"

#include "help.h"
#include "option_words.h"

namespace meniscus::cli {

namespace {

constexpr const char* kFlowGroup = "Flow";

constexpr const char* kSurfaceExamples =
    "-o writes meshes (.ply .obj .stl .off .glb .vtp .vert .npz), pages (.html),\n"
    "pictures (.png), volumes (.dx .mrc .vdb) and the kept atoms (.xyzr .xyzrn).\n"
    "Without -o, mesh and page go to NAME.ply and NAME.html in this folder.\n"
    "Examples:\n"
    "  meniscus surface 1abc.pdb                                  mesh and page\n"
    "  meniscus surface 1abc.pdb -o 1abc.png --color patch        a picture\n"
    "  meniscus surface 1abc.pdb -o 1abc.stl --edge 1 --components outer   to print\n"
    "  meniscus surface 1abc.cif -o ab.ply --chains A,B --report ab.json";

void add_part_options(CLI::App& command, SurfaceRequest& request) {
    command
        .add_option("--show", request.show,
                    rarely("Write only the part of the surface that belongs to these atoms, as in //A/10-50; the "
                           "surface is computed with all atoms"))
        ->type_name("EXPR");
    command.add_flag("--per-chain", request.per_chain, rarely("One surface per chain: NAME_chainA and so on"));
    command.add_flag("--cavity-files", request.cavity_files,
                     rarely("Also write each cavity as a mesh of its own: NAME_cavity1 and so on"));
}

void add_encoding(CLI::App& command, SurfaceRequest& request) {
    const auto ascii = [&request](std::int64_t) { request.encoding = Encoding::Text; };
    command.add_flag_function("--ascii", ascii, rarely("Write PLY and STL as text"));
}

/// Refuses options that would do nothing.
void check_together(const CLI::App& command, const SurfaceRequest& request) {
    const auto is_given = [&](const char* name) { return command.count(name) > 0; };
    const SurfaceOptions& surface = request.surface;
    const std::string of_flow = first_given(command, kFlowGroup);
    if (!of_flow.empty() && surface.method != Method::Flow)
        throw UsageError(of_flow + " applies to the flow; use --method flow");
    if (is_given("--probe") && surface.surface == SurfaceKind::Vdw && surface.probe != 0.0)
        throw UsageError("--surface vdw has the probe radius 0; leave --probe out");
    if (request.no_exact && surface.verify)
        throw UsageError("--verify checks the exact numbers, which --no-exact leaves out; give one of them");
    describe(surface, [&](const Option& option, const auto&...) {
        const CLI::Option* given = command.get_option_no_throw(flag_of(option.name));
        if (given != nullptr && given->count() > 0) refuse_without_effect(option, surface, spell_as_option);
    });
}

/// What depends on several options.
void complete(const CLI::App& command, SurfaceRequest& request) {
    check_together(command, request);
    request.surface.remesh.finer_grid = command.count("--spacing") == 0;
    check_picture(request.picture);
    check_values(request.values, request.picture.colours);
    if (request.surface.method == Method::Gaussian && request.surface.surface != SurfaceKind::Ses)
        throw UsageError(
            "--method gaussian gives a single envelope of the atoms; for --surface sas|vdw use --method flow or "
            "direct");
    if (request.surface.surface == SurfaceKind::Vdw) request.surface.probe = 0.0;
    if (!request.show.empty() && request.per_chain)
        throw UsageError("--show and --per-chain cannot be combined; give one of them");
    if (request.cavity_files && request.surface.pieces == Pieces::Outer)
        throw UsageError("--cavity-files writes cavities, which --components outer leaves out; give one of them");
    request.surface.exact = !request.no_exact;
    request.surface.history = !request.history.empty();
    request.surface.initial_area = !request.report.empty();
    request.surface.quality = !request.report.empty();
    request.surface.two_sided_distance = !request.report.empty() && request.surface.remesh.is_on();
}

}  // namespace

void add_surface_options(CLI::App& command, SurfaceRequest& request) {
    const OptionAdder add(command);
    add_input(command, request);
    command.footer(kSurfaceExamples);
    command.option_defaults()->group("Atoms");
    add_atom_options(command, request);
    command.option_defaults()->group("Surface");
    describe_shape(request.surface, add);
    command.option_defaults()->group(kFlowGroup);
    describe(request.surface.flow, add);
    command.add_option("--history", request.history, rarely("Record of every step, .csv or .json"))->type_name("FILE");
    add_count(command, {"--snapshots", rarely("Write a mesh every N steps")}, request.snapshots);
    command.parse_complete_callback([&command, &request] { complete(command, request); });
    command.option_defaults()->group("Triangles");
    describe(request.surface.remesh, add);
    command.get_option("--vertex-density")->excludes(command.get_option("--edge"));
    command.option_defaults()->group("Output");
    add_output_options(command, request);
    add_part_options(command, request);
    add_encoding(command, request);
    command.option_defaults()->group("Colours and pictures");
    add_picture_options(command, request.picture);
    add_value_options(command, request.values);
    command.option_defaults()->group("Volumes");
    add_volume_options(command, request.volume);
    command.option_defaults()->group("Running");
    describe(request.run, add);
    add_progress(command, request.progress);
    command.add_flag("--no-exact", request.no_exact,
                     "Leave the exact area and volume out\n; saves 10 to 25 % of the time, less on fine grids");
    describe_checks(request.surface, add);
}

}  // namespace meniscus::cli
