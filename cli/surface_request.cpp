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

void add_shape_options(CLI::App& command, SurfaceRequest& request) {
    SurfaceOptions& surface = request.surface;
    add_probe(command, surface.probe);
    add_choice(command,
               {"--method",
                "flow: smooth; direct: sharp ridges\n"
                ". flow: a level-set flow; direct: the exact distance itself; gaussian: only the density envelope that "
                "the flow starts from, which is not the solvent-excluded surface"},
               surface.method, kMethodWords);
    add_choice(command,
               {"--surface",
                rarely("Which surface: solvent-excluded, solvent-accessible (traced by the probe's centre) or van der "
                       "Waals (the same as --probe 0)")},
               surface.surface, kSurfaceWords);
    add_number(command, {"--spacing", "Grid spacing, Å\n; time and memory grow as 1/H²", "H"}, surface.spacing,
               Sign::Positive);
    add_choice(command, {"--components", "Closed pieces that the mesh keeps"}, surface.pieces, kPiecesWords);
    add_number(command,
               {"--min-cavity", "Drop cavities smaller than V Å³\n and what lies in them; outer pieces stay", "V"},
               surface.min_cavity, Sign::NotNegative);
    add_number(
        command,
        {"--fill-cavities", rarely("Drop cavities smaller than V Å³, and count their space as inside in volumes"), "V"},
        surface.fill_cavities, Sign::NotNegative);
    add_number(command, {"--density", rarely("Constant of the initial Gaussian map, Å^-2"), "C"}, surface.density,
               Sign::Negative);
}

void add_remesh_options(CLI::App& command, SurfaceRequest& request) {
    RemeshOptions& remesh = request.surface.remesh;
    CLI::Option* by_edge =
        add_word(command, {"--edge", "Even triangles with edges of about L Å\n, instead of those of the grid", "L"},
                 [&remesh](const std::string& text) { remesh.edge = parse_number("--edge", text, Sign::Positive); });
    add_word(command,
             {"--vertex-density", rarely("The same as --edge, given as vertices per Å²; use only one of the two"), "D"},
             [&remesh](const std::string& text) {
                 remesh.edge = edge_of_density(parse_number("--vertex-density", text, Sign::Positive));
             })
        ->excludes(by_edge);
    command.add_flag("--adaptive", remesh.adaptive, "With --edge: finer where curvature is high");
    command.add_flag("--keep-ridges", remesh.keep_ridges, "With --edge: edges follow the creases");
    add_choice(command,
               {"--corners",
                rarely("With --edge: where vertices lie. near: as near to the surface as possible with the triangles "
                       "within 0.03 L² Å of it on average; on-surface: on it; balanced: so that the triangles lie on "
                       "both sides of it, half as far away as with on-surface")},
               remesh.corners, kCornersWords);
    command.add_flag("--simplify-topology", remesh.simplify_topology,
                     rarely("With --edge: cut handles, close tunnels and drop pieces narrower than an edge"));
}

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

void add_memory_limit(CLI::App& command, SurfaceRequest& request) {
    add_word(command,
             {"--memory",
              "Refuse what would need more, as 4G or 500M\n; by default, the limit is the free memory of the machine",
              "LIMIT"},
             [&request](const std::string& text) { request.run.memory_limit_mb = parse_memory("--memory", text); });
}

/// Refuses options that would do nothing.
void check_together(const CLI::App& command, const SurfaceRequest& request) {
    const auto is_given = [&](const char* name) { return command.count(name) > 0; };
    const SurfaceOptions& surface = request.surface;
    const std::string of_flow = first_given(command, kFlowGroup);
    if (!of_flow.empty() && surface.method != Method::Flow)
        throw UsageError(of_flow + " applies to the flow; use --method flow");
    if (is_given("--density") && surface.method == Method::Direct)
        throw UsageError(
            "--density applies to the initial Gaussian map, which --method direct does not use; leave it out");
    if (is_given("--probe") && surface.surface == SurfaceKind::Vdw && surface.probe != 0.0)
        throw UsageError("--surface vdw has the probe radius 0; leave --probe out");
    const bool is_shaped =
        is_given("--adaptive") || is_given("--keep-ridges") || is_given("--corners") || is_given("--simplify-topology");
    if (request.no_exact && surface.verify)
        throw UsageError("--verify checks the exact numbers, which --no-exact leaves out; give one of them");
    if (is_shaped && !surface.remesh.is_on())
        throw UsageError(
            "--adaptive, --keep-ridges, --corners and --simplify-topology shape even triangles; ask for "
            "them with --edge");
}

/// What depends on several options.
void complete(const CLI::App& command, SurfaceRequest& request) {
    check_together(command, request);
    request.surface.flow = resolve(request.flow);
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
    request.surface.history = !request.flow.history.empty();
    request.surface.initial_area = !request.report.empty();
    request.surface.quality = !request.report.empty();
    request.surface.two_sided_distance = !request.report.empty() && request.surface.remesh.is_on();
}

}  // namespace

void add_surface_options(CLI::App& command, SurfaceRequest& request) {
    add_input(command, request);
    command.footer(kSurfaceExamples);
    command.option_defaults()->group("Atoms");
    add_atom_options(command, request);
    command.option_defaults()->group("Surface");
    add_shape_options(command, request);
    command.option_defaults()->group(kFlowGroup);
    add_flow_options(command, request.flow);
    command.parse_complete_callback([&command, &request] { complete(command, request); });
    command.option_defaults()->group("Triangles");
    add_remesh_options(command, request);
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
    add_run_options(command, request, request.run.threads);
    add_memory_limit(command, request);
    command.add_flag("--no-exact", request.no_exact,
                     "Leave the exact area and volume out\n; saves 10 to 25 % of the time, less on fine grids");
    command.add_flag("--verify", request.surface.verify, "Run the expensive self-checks, too");
}

const char* name_of(Pieces pieces) { return word_for(kPiecesWords, pieces); }

const char* name_of(Method method) { return word_for(kMethodWords, method); }

}  // namespace meniscus::cli
