// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pockets_request.h"

#include "meniscus/describe_pockets.h"
#include "option_words.h"

namespace meniscus::cli {

namespace {

constexpr const char* kPocketsExamples =
    "Pockets are ranked by how much they resemble the places of ligands. -o writes a\n"
    "table (.csv .json), atoms and grid points (.pdb .cif), a map (.dx .mrc) or arrays\n"
    "(.npz).\n"
    "Examples:\n"
    "  meniscus pockets 1abc.pdb                       the pockets, best first\n"
    "  meniscus pockets 1abc.pdb -o pockets.csv        as a table\n"
    "  meniscus pockets 1abc.pdb -o pockets.pdb        as atoms for a viewer\n"
    "  meniscus pockets 1abc.pdb --hetero ligands      with ligands as a part of the wall";

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
    command.option_defaults()->group("Output");
    add_output_options(command, request);
    add_choice(command, {"--field", "What maps hold: ranks of pockets, or the probability of a ligand's atom"},
               request.field, kPocketFieldWords);
    command.option_defaults()->group("Running");
    OptionAdder{command}(kThreadsOption, request.run.threads);
    add_progress(command, request.progress);
}

}  // namespace meniscus::cli
