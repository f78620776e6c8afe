// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "meniscus/errors.h"
#include "meniscus/volume_file.h"
#include "reading/lower_case.h"
#include "volume/readers.h"

namespace meniscus {
namespace {

struct ReadableFormat {
    std::string_view suffix;
    Volume (*read)(const std::string&, VolumePart);
};
constexpr std::array kReadable{ReadableFormat{".dx", read_dx},      ReadableFormat{".dx.gz", read_dx},
                               ReadableFormat{".mrc", read_mrc},    ReadableFormat{".map", read_mrc},
                               ReadableFormat{".ccp4", read_mrc},   ReadableFormat{".mrc.gz", read_mrc},
                               ReadableFormat{".map.gz", read_mrc}, ReadableFormat{".ccp4.gz", read_mrc}};

Volume read(const std::string& path, VolumePart part) {
    const auto found = std::find_if(kReadable.begin(), kReadable.end(),
                                    [&](const ReadableFormat& f) { return lower_case(path).ends_with(f.suffix); });
    if (found != kReadable.end()) return found->read(path, part);
    std::string known;
    for (const ReadableFormat& format : kReadable) known.append(known.empty() ? "" : " ").append(format.suffix);
    throw UsageError(fmt::format("{}: unknown suffix for a volume; supported formats are {}", path, known));
}

}  // namespace

Volume read_volume(const std::string& path) { return read(path, VolumePart::All); }

VolumeGrid read_volume_grid(const std::string& path) { return read(path, VolumePart::Grid).grid; }

}  // namespace meniscus
