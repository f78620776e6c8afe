// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What a surface was computed from and with, for files that can tell.
#pragma once

#include <string>

#include "meniscus/structure.h"
#include "meniscus/surface.h"

namespace meniscus {

/// JSON, in the words of the report: {"meniscus": version, "input": {file, sha256, radii, probe}, "options": those that
/// decide the result}. Options that have no effect are null.
std::string options_json(const SurfaceOptions& options, const Structure& structure);

}  // namespace meniscus
