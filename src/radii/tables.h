// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The rules of the built-in sets, one table per file; each file cites where its values come from.
#pragma once

#include <span>
#include <string_view>

#include "radii/radius_set.h"

namespace meniscus {

/// Names of water molecules, in the form of a rule's residues.
inline constexpr std::string_view kWaterResidues =
    "HOH,WAT,DOD,H2O,D2O,TIP,TIP2,TIP3,TIP4,TIP5,TP3,TP4,TP5,T3P,T4P,T5P,SOL,SPC,SPCE";

extern const std::span<const RadiusRule> kBondiRules;
extern const std::span<const RadiusRule> kUnitedRules;
extern const std::span<const RadiusRule> kProtorRules;
extern const std::span<const RadiusRule> kNaccessRules;
extern const std::span<const RadiusRule> kParseRules;

}  // namespace meniscus
