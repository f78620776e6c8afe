// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The short readable summary that ends a run.
#pragma once

#include <string>
#include <vector>

#include "meniscus/structure.h"
#include "meniscus/surface.h"
#include "output_plan.h"
#include "report.h"

namespace meniscus::cli {

/// A few lines, the last one ended: what was read, the surface's measures, its distance to the exact surface, time
/// and the files written.
std::string make_summary(const Structure& structure, const Surface& surface, const RunFacts& facts,
                         const std::vector<Output>& written);

/// The checks that a surface has not passed, as "name (value, bound)"; empty if it passed all of them.
std::string failed_checks(const Surface& surface);

}  // namespace meniscus::cli
