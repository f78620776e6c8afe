// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What `meniscus pockets` is asked to do, and the options that ask it.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "common_request.h"
#include "meniscus/pockets.h"
#include "meniscus/volume.h"
#include "picture_options.h"

namespace meniscus::cli {

/// Without -o nothing is written beside the report.
struct PocketsRequest : CommonRequest {
    PocketOptions pockets;
    RunOptions run;
    std::vector<std::string> at;     ///< --at, in order
    std::optional<double> at_reach;  ///< --at-reach, Å
    std::string over_models;         ///< --over-models: path, empty for none
    PictureRequest picture{};
    VolumeContent field = VolumeContent::Pockets;  ///< --field, of volumes
};

/// Gives a subcommand its options; parsing fills `request`, which must outlive the parser.
/// throws   as add_surface_options
void add_pockets_options(CLI::App& command, PocketsRequest& request);

}  // namespace meniscus::cli
