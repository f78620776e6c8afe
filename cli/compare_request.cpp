// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "compare_request.h"

#include <fmt/core.h>

#include <array>

#include "help.h"
#include "meniscus/read_mesh.h"
#include "option_words.h"
#include "output_plan.h"
#include "standard_output.h"

namespace meniscus::cli {

namespace {

constexpr const char* kAtomGroup = "Atoms";
constexpr const char* kSurfaceGroup = "Surfaces";

constexpr const char* kCompareExamples =
    "A and B are meshes (.ply .obj .stl .off .glb .vert+.face, each also .gz) or\n"
    "structures, whose exact surface is used. -o writes A's mesh coloured by\n"
    "its distance from B, red outside, blue inside (.ply .glb).\n"
    "Examples:\n"
    "  meniscus compare other.obj 1abc.pdb              another program's surface\n"
    "  meniscus compare a.ply b.ply -o difference.ply   where two meshes differ";

// Formats of meshes that have no room for distances.
constexpr std::array<const char*, 4> kWithoutValues{".obj", ".stl", ".off", ".vert"};

ValueRange parse_range(const std::string& text) {
    const std::size_t colon = text.find(':', 1);
    if (colon == std::string::npos) throw UsageError(fmt::format("--range: '{}' is not MIN:MAX", text));
    const ValueRange range{parse_number("--range", text.substr(0, colon), NumberRange::Any),
                           parse_number("--range", text.substr(colon + 1), NumberRange::Any)};
    if (range.min >= range.max)
        throw UsageError(fmt::format("--range: '{}' is empty; write the smaller value first", text));
    return range;
}

void add_surfaces(CLI::App& command, CompareRequest& request) {
    command.add_option("A", request.input, "a mesh or a structure")->required()->type_name("");
    command.add_option("B", request.second, "another mesh or structure")->required()->type_name("");
}

}  // namespace

void add_compare_options(CLI::App& command, CompareRequest& request) {
    add_surfaces(command, request);
    command.footer(kCompareExamples);
    command.option_defaults()->group(kAtomGroup);
    add_atom_options(command, request);
    command.option_defaults()->group(kSurfaceGroup);
    const OptionAdder add(command);
    add(kProbeOption, request.structure.probe);
    add(Option{.name = "spacing",
               .meaning = "Grid spacing of the mesh that is used to spread points over a structure's surface, Å",
               .example = "--spacing 0.4",
               .symbol = "H",
               .range = NumberRange::Positive},
        request.structure.spacing);
    command.option_defaults()->group("Distances");
    add(Option{.name = "points",
               .brief = "Minimum number of points per Å²",
               .meaning = "Distances are taken at D or more points per Å², spread over the triangles, at least four on "
                          "each; the maximum also includes the vertices",
               .example = "--points 20",
               .symbol = "D",
               .range = NumberRange::Positive},
        request.compare.density);
    command.option_defaults()->group("Output");
    add_output_options(command, request);
    add_word(command,
             {"--range", "Distances shown in full blue and red, Å\n; by default, 99 % of A's area lies between them",
              "MIN:MAX"},
             [&request](const std::string& text) { request.range = parse_range(text); });
    command.option_defaults()->group("Running");
    add(kThreadsOption, request.compare.threads);
    add_progress(command, request.progress);
    command.parse_complete_callback([&command, &request] {
        for (const char* group : {kSurfaceGroup, kAtomGroup})
            if (const std::string name = first_given(command, group); !name.empty()) request.of_structures = name;
    });
}

void check_request(const CompareRequest& request) {
    if (request.all_models) throw UsageError("--model all: only one model can be compared; give its number");
    if (request.input == "-" && request.second == "-")
        throw UsageError("A and B cannot both come from standard input; name a file for one of them");
    if (!request.of_structures.empty() && is_mesh_file(request.input) && is_mesh_file(request.second))
        throw UsageError(request.of_structures + " applies to structures, but both files are meshes; leave it out");
    if (request.range && request.outputs.empty())
        throw UsageError("--range sets the colours of a mesh; ask for one with -o FILE.ply or FILE.glb");
    for (const std::string& path : request.outputs) {
        const std::string suffix = suffix_of(path);
        const bool holds_values =
            std::find(kWithoutValues.begin(), kWithoutValues.end(), suffix) == kWithoutValues.end();
        if (kind_of(path) != OutputKind::Mesh || !holds_values)
            throw UsageError(spell_output(path) + ": this format cannot hold distances; choose .ply or .glb");
    }
}

}  // namespace meniscus::cli
