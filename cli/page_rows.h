// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The numbers of the report that a page shows beside its surface.
#pragma once

#include <vector>

#include "meniscus/measures.h"
#include "meniscus/page.h"
#include "meniscus/structure.h"
#include "meniscus/surface.h"
#include "surface_request.h"

namespace meniscus::cli {

/// exact   measures of the structure's atoms
std::vector<PageRow> page_rows(const SurfaceRequest& request, const Structure& structure, const Surface& surface,
                               const Measures& exact);

}  // namespace meniscus::cli
