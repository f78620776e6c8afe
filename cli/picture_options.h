// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The options that say how a surface is coloured and drawn.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "meniscus/colours.h"
#include "meniscus/picture.h"
#include "output_plan.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace meniscus::cli {

struct PictureRequest {
    ColourOptions colours{};  ///< of meshes too
    PictureOptions picture;   ///< threads are those of the run
    bool legend = false;
    bool ligands = true;        ///< --draw; of GLB, too
    std::string view = "auto";  ///< as asked for
    std::string cut{};          ///< as asked for
    std::string drawn_by{};     ///< an option that was given and that only pictures heed; empty if there is none
    std::string viewed_by{};    ///< one that pictures and pages heed
    std::string shown_by{};     ///< one that pictures, pages and GLB heed
};

/// --color, --view, --size, --background, --cut, --perspective, --outline, --depth-cue, --legend. `request` must
/// outlive the parser. While parsing, UsageError is thrown for values that make no sense.
void add_picture_options(CLI::App& command, PictureRequest& request);

/// The same without --color.
void add_drawing_options(CLI::App& command, PictureRequest& request);

/// What depends on several of these options.
/// throws   UsageError for options that do not go together
void check_picture(const PictureRequest& request);

/// Whether an output has room for ligands beside the surface.
bool draws_ligands(const std::vector<Output>& outputs);

/// What depends on the outputs.
/// throws   UsageError for outputs that this build cannot make, and for options that none of the outputs heeds
void check_drawn(const PictureRequest& request, const std::vector<Output>& outputs);

/// The scheme and range in force, and how pictures are drawn, as the report has them.
/// drawn   whether there is a picture; without one what shapes it is null
nlohmann::ordered_json report_picture(const PictureRequest& request, const Structure& structure, const Mesh& mesh,
                                      bool drawn);

}  // namespace meniscus::cli
