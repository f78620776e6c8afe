// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "meniscus/errors.h"
#include "meniscus/version.h"
#include "meniscus/volume_file.h"
#include "reading/lower_case.h"
#include "volume/writers.h"

namespace meniscus {
namespace {

struct WritableFormat {
    std::string_view suffix;
    void (*write)(const std::string&, const Volume&, VolumeContent);
};
constexpr std::array kWritable{WritableFormat{".dx", write_dx}, WritableFormat{".mrc", write_mrc},
                               WritableFormat{".vdb", write_vdb}};

const char* meaning(VolumeContent content) {
    switch (content) {
        case VolumeContent::Mask:
            return "Mask: 1 inside, 0 outside";
        case VolumeContent::Dielectric:
            return "Relative dielectric constant";
        case VolumeContent::Ions:
            return "Ion accessibility: 1 outside the enlarged atoms, 0 inside";
        case VolumeContent::Probability:
            return "Probability of a ligand's atom in pocket space, not calibrated";
        case VolumeContent::Pockets:
            return "Rank of the pocket, 0 where there is none";
        default:
            return "Signed distance to the surface, Angstrom, inside positive";
    }
}

}  // namespace

std::array<std::string, 2> header_lines(VolumeContent content) {
    return {fmt::format("Meniscus {}", kVersion), meaning(content)};
}

void write_volume(const std::string& path, const Volume& volume, VolumeContent content) {
    if (volume.grid.size() != volume.values.size() || volume.values.empty())
        throw UsageError(fmt::format("{}: a volume with {} values has a grid of {} nodes; give one value per node",
                                     path, volume.values.size(), volume.grid.size()));
    const auto found = std::find_if(kWritable.begin(), kWritable.end(),
                                    [&](const WritableFormat& f) { return lower_case(path).ends_with(f.suffix); });
    if (found != kWritable.end()) return found->write(path, volume, content);
    std::string known;
    for (const WritableFormat& format : kWritable) known.append(known.empty() ? "" : " ").append(format.suffix);
    throw UsageError(fmt::format("{}: unknown suffix for a volume; choose one of {}", path, known));
}

}  // namespace meniscus
