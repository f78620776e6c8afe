// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_request.h"

#include "option_words.h"

namespace meniscus::cli {

namespace {

constexpr Words<Method, 3> kMethods{
    {{"flow", Method::Flow}, {"direct", Method::Direct}, {"gaussian", Method::Gaussian}}};

constexpr Words<Pieces, 3> kPieces{{{"all", Pieces::All}, {"outer", Pieces::Outer}, {"cavities", Pieces::Cavities}}};

constexpr const char* kFormats =
    "-o writes meshes (.ply .obj .stl .off .glb), with the table NAME.atoms.csv beside them, pages to look at in a\n"
    "browser (.html), pictures (.png), and the kept atoms (.xyzr .xyzrn). Without -o mesh and page go to NAME.ply and\n"
    "NAME.html in the current folder.";

void add_shape_options(CLI::App& command, SurfaceRequest& request) {
    SurfaceOptions& surface = request.surface;
    add_probe(command, surface.probe);
    add_choice(command, "--method", surface.method, kMethods, "Smooth flow, sharp direct, or only the Gaussian start");
    add_number(command, "--spacing", surface.spacing, Sign::Positive, "H", "Grid spacing, Å");
    add_choice(command, "--components", surface.pieces, kPieces, "Which closed pieces the mesh keeps");
    add_number(command, "--min-cavity", surface.min_cavity, Sign::NotNegative, "V",
               "Drop cavities that enclose less, Å³, and what lies in them; outer pieces stay");
    add_number(command, "--density", surface.density, Sign::Negative, "C",
               "Constant of the initial Gaussian map, Å^-2");
}

void add_remesh_options(CLI::App& command, SurfaceRequest& request) {
    RemeshOptions& remesh = request.surface.remesh;
    const auto edge = [&remesh](const std::string& text) {
        remesh.edge = parse_number("--edge", text, Sign::Positive);
    };
    const auto density = [&remesh](const std::string& text) {
        remesh.edge = edge_of_density(parse_number("--vertex-density", text, Sign::Positive));
    };
    CLI::Option* by_edge =
        command.add_option_function<std::string>("--edge", edge, "Even triangles with edges of about this length, Å");
    by_edge->type_name("L");
    command.add_option_function<std::string>("--vertex-density", density, "The same by their vertices per Å²")
        ->type_name("D")
        ->excludes(by_edge);
    command.add_flag("--adaptive", remesh.adaptive, "Shorter edges where the surface bends more");
    command.add_flag("--keep-ridges", remesh.keep_ridges, "Edges run along the creases of the surface");
    command.add_flag("--simplify-topology", remesh.simplify_topology,
                     "Cut handles, close tunnels and drop pieces narrower than an edge");
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

/// What depends on several options.
void complete(SurfaceRequest& request) {
    request.surface.flow = resolve(request.flow);
    const bool recorded = !request.flow.history.empty() || request.flow.snapshots > 0;
    if (recorded && request.surface.method != Method::Flow)
        throw UsageError("--history and --snapshots show the steps of a flow; use --method flow");
    const RemeshOptions& remesh = request.surface.remesh;
    if ((remesh.adaptive || remesh.keep_ridges || remesh.simplify_topology) && !remesh.is_on())
        throw UsageError(
            "--adaptive, --keep-ridges and --simplify-topology shape even triangles; ask for them with --edge");
    request.surface.history = !request.flow.history.empty();
    request.surface.initial_area = !request.report.empty();
    request.surface.quality = !request.report.empty();
    request.surface.two_sided_distance = !request.report.empty() && remesh.is_on();
}

}  // namespace

void add_surface_options(CLI::App& command, SurfaceRequest& request) {
    add_input(command, request);
    command.footer(kFormats);
    command.option_defaults()->group("Atoms");
    add_atom_options(command, request);
    command.option_defaults()->group("Surface");
    add_shape_options(command, request);
    command.option_defaults()->group("Flow");
    add_flow_options(command, request.flow);
    command.parse_complete_callback([&request] { complete(request); });
    command.option_defaults()->group("Triangles");
    add_remesh_options(command, request);
    command.option_defaults()->group("Output");
    add_output_options(command, request);
    add_encoding(command, request);
    command.option_defaults()->group("Colours and pictures");
    add_picture_options(command, request.picture);
    command.option_defaults()->group("Running");
    add_run_options(command, request, request.surface.threads);
    add_memory_limit(command, request);
    command.add_flag("--verify", request.surface.verify,
                     "The expensive self-checks, too: does the mesh pass through itself?");
}

const char* name_of(Pieces pieces) { return word_for(kPieces, pieces); }

const char* name_of(Method method) { return word_for(kMethods, method); }

}  // namespace meniscus::cli
