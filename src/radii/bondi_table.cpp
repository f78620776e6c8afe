// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Set `bondi`: A. Bondi, "van der Waals volumes and radii", J. Phys. Chem. 68, 441-451 (1964); H 1.20 as there.
#include <array>

#include "radii/tables.h"

namespace meniscus {
namespace {

// The elements of biomolecules and their usual company; any other element is a fallback (element_radii.h).
constexpr auto kBondiTable = std::to_array<RadiusRule>({
    {"*", "@C", 1.70},  {"*", "@N", 1.55},  {"*", "@O", 1.52},  {"*", "@S", 1.80},  {"*", "@P", 1.80},
    {"*", "@H", 1.20},  {"*", "@D", 1.20},  {"*", "@SE", 1.90}, {"*", "@F", 1.47},  {"*", "@CL", 1.75},
    {"*", "@BR", 1.85}, {"*", "@I", 1.98},  {"*", "@HE", 1.40}, {"*", "@NE", 1.54}, {"*", "@AR", 1.88},
    {"*", "@KR", 2.02}, {"*", "@XE", 2.16}, {"*", "@SI", 2.10}, {"*", "@AS", 1.85}, {"*", "@TE", 2.06},
    {"*", "@LI", 1.82}, {"*", "@NA", 2.27}, {"*", "@MG", 1.73}, {"*", "@K", 2.75},  {"*", "@NI", 1.63},
    {"*", "@CU", 1.40}, {"*", "@ZN", 1.39}, {"*", "@GA", 1.87}, {"*", "@PD", 1.63}, {"*", "@AG", 1.72},
    {"*", "@CD", 1.58}, {"*", "@IN", 1.93}, {"*", "@SN", 2.17}, {"*", "@PT", 1.72}, {"*", "@AU", 1.66},
    {"*", "@HG", 1.55}, {"*", "@TL", 1.96}, {"*", "@PB", 2.02}, {"*", "@U", 1.86},
});

}  // namespace

const std::span<const RadiusRule> kBondiRules = kBondiTable;

}  // namespace meniscus
