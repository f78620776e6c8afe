// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/options_json.h"

#include "meniscus/file_name.h"
#include "meniscus/version.h"

namespace meniscus {

std::string options_json(const SurfaceOptions& options, const Structure& structure) {
    using nlohmann::ordered_json;
    const ordered_json input{{"file", file_name(structure.file)},
                             {"sha256", structure.sha256},
                             {"radii", file_name(structure.radii_set)},
                             {"probe", options.probe}};
    const ordered_json json{{"meniscus", kVersion}, {"input", input}, {"options", options_block(options)}};
    return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
}

}  // namespace meniscus
