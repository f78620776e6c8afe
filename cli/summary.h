// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The short readable summary that ends a run.
#pragma once

#include <string>
#include <vector>

#include "meniscus/measures.h"
#include "meniscus/structure.h"
#include "meniscus/surface.h"
#include "output_plan.h"
#include "report.h"

namespace meniscus::cli {

/// A few lines, the last one ended: what was read, the exact measures and beside them the mesh's, its distance to the
/// exact surface, time and the files written.
std::string make_summary(const Structure& structure, const Surface& surface, const RunFacts& facts,
                         const std::vector<Output>& written);

/// The checks that a surface has not passed, as "name (value, bound)", and the disputed patches if the exact measures
/// are not agreed on; empty if all is well.
std::string failed_checks(const Surface& surface);

}  // namespace meniscus::cli
