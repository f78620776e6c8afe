// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What `meniscus surface` is asked to do, and the options that ask it.
#pragma once

#include <string>

#include "common_request.h"
#include "meniscus/surface.h"
#include "meniscus/write.h"
#include "picture_options.h"
#include "value_options.h"
#include "volume_options.h"

namespace meniscus::cli {

/// Without -o mesh and page go to NAME.ply and NAME.html in the current folder.
struct SurfaceRequest : CommonRequest {
    SurfaceOptions surface;
    RunOptions run{};
    std::string history;  ///< path of a record of the flow, empty for none
    int snapshots = 0;    ///< a mesh every so many steps of the flow, 0 for none
    Encoding encoding = Encoding::Binary;
    PictureRequest picture{};
    ValueRequest values{};
    VolumeRequest volume{};
    std::string show;           ///< selection whose part of the surface is written; empty: all of it
    bool cavity_files = false;  ///< each cavity also as a mesh of its own
    bool no_exact = false;      ///< numbers of the mesh alone
};

/// Gives a subcommand its options; parsing fills `request`, which must outlive the parser.
///
/// While parsing, UsageError is thrown for values that make no sense, CLI::ParseError for everything that
/// CLI11 itself refuses.
void add_surface_options(CLI::App& command, SurfaceRequest& request);

}  // namespace meniscus::cli
