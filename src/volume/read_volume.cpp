// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "meniscus/errors.h"
#include "meniscus/volume.h"
#include "volume/readers.h"

namespace meniscus {
namespace {

struct Format {
    std::string_view suffix;
    Volume (*read)(const std::string&, VolumePart);
};
constexpr std::array kFormats{Format{".dx", read_dx},      Format{".dx.gz", read_dx},   Format{".mrc", read_mrc},
                              Format{".map", read_mrc},    Format{".ccp4", read_mrc},   Format{".mrc.gz", read_mrc},
                              Format{".map.gz", read_mrc}, Format{".ccp4.gz", read_mrc}};

Volume read(const std::string& path, VolumePart part) {
    const auto found =
        std::find_if(kFormats.begin(), kFormats.end(), [&](const Format& f) { return path.ends_with(f.suffix); });
    if (found != kFormats.end()) return found->read(path, part);
    std::string known;
    for (const Format& format : kFormats) known.append(known.empty() ? "" : " ").append(format.suffix);
    throw UsageError(fmt::format("{}: unknown suffix for a volume; supported formats are {}", path, known));
}

}  // namespace

Volume read_volume(const std::string& path) { return read(path, VolumePart::All); }

VolumeGrid read_volume_grid(const std::string& path) { return read(path, VolumePart::Grid).grid; }

}  // namespace meniscus
