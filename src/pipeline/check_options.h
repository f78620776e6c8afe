// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the options of a surface have to be.
#pragma once

#include "meniscus/surface.h"

namespace meniscus {

/// throws   UsageError for an option out of range, and for options that do not go together
void check_options(const SurfaceOptions& options);

}  // namespace meniscus
