// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pockets_request.h"

#include <algorithm>

#include "help.h"
#include "meniscus/describe_pockets.h"
#include "option_words.h"

namespace meniscus::cli {

namespace {

constexpr const char* kPocketsExamples =
    "Pockets are ranked by how much they resemble the places of ligands. -o writes a\n"
    "table (.csv .json), atoms and grid points (.pdb .cif), a map (.dx .mrc), arrays\n"
    "(.npz), bodies (.ply .glb), a picture (.png) or a page (.html).\n"
    "Examples:\n"
    "  meniscus pockets 1abc.pdb                       the pockets, best first\n"
    "  meniscus pockets 1abc.pdb -o pockets.csv        as a table\n"
    "  meniscus pockets 1abc.pdb -o pockets.pdb        as atoms for a viewer\n"
    "  meniscus pockets 1abc.pdb -o pockets.html       as a page to turn and inspect\n"
    "  meniscus pockets 1abc.pdb --at '(LIG)'          the pocket of a ligand\n"
    "  meniscus pockets 1abc.pdb --tunnels             with the ways out of them\n"
    "  meniscus pockets 1abc.pdb --hetero ligands      ligands belong to the wall";

}  // namespace

void add_pockets_options(CLI::App& command, PocketsRequest& request) {
    request.read.radii = "united";  // as the ranking was fitted
    request.read.hetero = HeteroPolicy::None;
    add_input(command, request);
    command.footer(kPocketsExamples);
    command.option_defaults()->group("Atoms");
    add_atom_options(command, request);
    command.option_defaults()->group("Pockets");
    describe(request.pockets, OptionAdder{command});
    command
        .add_option_function<std::vector<std::string>>(
            "--at",
            [&request](const std::vector<std::string>& places) {
                if (std::find(places.begin(), places.end(), "") != places.end())
                    throw UsageError("--at: empty; write for instance (HEM), //A/57 or X,Y,Z");
                request.at = places;
            },
            "Pocket at a place, instead of those that are found\n: a ligand, as (HEM); residues, as //A/57 or "
            "'//A/57 + //A/102'; a point, as X,Y,Z; repeatable")
        ->type_name("PLACE")
        ->allow_extra_args(false);
    add_word(command,
             {"--at-reach", rarely("How far pockets of --at reach, Å; from atoms 4, from a point 8 unless given"), "R"},
             [&request](const std::string& text) {
                 request.at_reach = parse_number("--at-reach", text, NumberRange::Positive);
             });
    command.option_defaults()->group("Tunnels");
    add_tunnel_options(command, request.tunnels);
    command.option_defaults()->group("Output");
    add_output_options(command, request);
    add_choice(command, {"--field", "What maps hold: ranks of pockets, or the probability of a ligand's atom"},
               request.field, kPocketFieldWords);
    add_word(command,
             {"--over-models",
              "With --model all, table of pockets over all models\n: in how many each is open, mean and deviation of "
              "its volume; .csv or .json",
              "FILE"},
             [&request](const std::string& path) {
                 plan_table("--over-models", path, "");
                 request.over_models = path;
             });
    add_word(command, {"--tunnel-table", "Radii along tunnels and pore, .csv or .json", "FILE"},
             [&request](const std::string& path) {
                 plan_tunnel_table(path, "");
                 request.tunnels.table = path;
             });
    command.option_defaults()->group("Picture");
    add_drawing_options(command, request.picture);
    command.option_defaults()->group("Running");
    OptionAdder{command}(kThreadsOption, request.run.threads);
    add_progress(command, request.progress);
}

}  // namespace meniscus::cli
