// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The readable summary that ends `meniscus measure`.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "meniscus/measures.h"
#include "meniscus/structure.h"
#include "meniscus/tables.h"
#include "output_plan.h"
#include "report.h"

namespace meniscus::cli {

/// What was read, areas and volumes with their errors, the pieces of the surface, the largest cavities, time and files.
std::string make_summary(const Structure& structure, const Measures& measures, const RunFacts& facts,
                         const std::vector<Output>& written);

/// A table of interfaces, one line each.
std::string summarise_interfaces(std::span<const ChainInterface> interfaces);

/// "A,C:B".
std::string interface_name(const ChainPair& chains);

}  // namespace meniscus::cli
