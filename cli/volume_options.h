// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The options that say which values are written on which grid (-o FILE.dx, .mrc, .vdb).
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "meniscus/field.h"
#include "output_plan.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace meniscus::cli {

struct VolumeRequest {
    FieldOptions field;              ///< threads are those of the run
    std::optional<VolumeGrid> grid;  ///< as NX,NY,NZ,H,CX,CY,CZ
    std::string grid_file;           ///< or a file that has it
    std::string grid_text;           ///< as asked for
    bool apbs_maps = false;
    std::vector<std::string> given;  ///< those of these options that were given
};

/// --grid, --field, --eps, --ion-radius, --maps. `request` must outlive the parser. While parsing, UsageError is thrown
/// for values that make no sense.
void add_volume_options(CLI::App& command, VolumeRequest& request);

/// Replaces each volume by the four maps of APBS, if they are asked for: NAME_dielx.dx, NAME_diely.dx,
/// NAME_dielz.dx and NAME_kappa.dx for NAME.dx.
/// throws   UsageError for options that do not go together or with the outputs, and for formats that this build lacks
std::vector<Output> plan_volumes(const VolumeRequest& request, std::vector<Output> outputs);

/// The grid that is asked for, or the one of this spacing round all atoms.
/// throws   InputError for a file that cannot be read; UsageError for spacings that differ where a .vdb is to be
///          written
VolumeGrid find_grid(const VolumeRequest& request, const ExactSurface& exact, double spacing,
                     const std::vector<Output>& outputs);

/// How many volumes stand for one output.
std::size_t volumes_of(const VolumeRequest& request);

/// What the outputs of a run are written from.
class Volumes {
public:
    Volumes() = default;
    Volumes(const VolumeRequest& request, const VolumeGrid& grid, const Surface& surface, int threads);

    void write(const std::string& path) const;

private:
    VolumeContent content_ = VolumeContent::Distance;
    std::vector<Volume> volumes_;  // one, or the four maps
};

/// As the report has it.
/// written   whether there is a volume; without one all is null
nlohmann::ordered_json report_volumes(const VolumeRequest& request, bool written);

/// throws   UsageError for a .vdb that this build cannot write
void check_vdb(const std::string& path);

}  // namespace meniscus::cli
