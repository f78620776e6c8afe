// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The blocks of a report that hold exact measures; the same for every subcommand.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>

#include "meniscus/interfaces.h"
#include "meniscus/measures.h"
#include "meniscus/surface.h"

namespace meniscus::cli {

/// "exact": totals and their absolute errors.
nlohmann::ordered_json exact_json(const Measures& measures);

/// "components": one entry per closed piece of the SES, by falling volume.
nlohmann::ordered_json components_json(const Measures& measures);

/// One entry of "interfaces"; a and b: the chains of each side, "A,C".
nlohmann::ordered_json interface_json(const std::string& a, const std::string& b, const Interface& interface);

/// "exact_agreement (patches of atom 3 by 0.1 Å², ...)", or empty if the evaluations agree.
std::string disputed_patches(bool agreed, std::span<const std::string> disputed);

}  // namespace meniscus::cli
