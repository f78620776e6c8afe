// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The one function of the module that knows OpenVDB. It is loaded when a .vdb is written: OpenVDB takes 0.1 s and 28 MB
// to be loaded, which all other runs are spared.
#pragma once

#include <iosfwd>
#include <string>

#include "meniscus/volume.h"

namespace meniscus {

struct VdbRequest {
    const Volume& volume;
    VolumeContent content;
    std::string creator;
    std::string description;
};

using VdbWriter = void(const VdbRequest&, std::ostream&);
inline constexpr const char* kVdbWriterName = "meniscus_write_vdb";

}  // namespace meniscus
