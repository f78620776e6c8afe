// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The rules of the built-in sets, one table per file; each file cites where its values come from.
#pragma once

#include <span>

#include "radii/radius_set.h"

namespace meniscus {

extern const std::span<const RadiusRule> kBondiRules;
extern const std::span<const RadiusRule> kUnitedRules;
extern const std::span<const RadiusRule> kProtorRules;
extern const std::span<const RadiusRule> kNaccessRules;
extern const std::span<const RadiusRule> kParseRules;

}  // namespace meniscus
