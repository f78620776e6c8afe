// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The command line of MSMS.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace meniscus::dropins {

struct MsmsRequest {
    double probe = 1.5;     ///< Å
    double density = 1.0;   ///< vertices per Å²
    double hdensity = 3.0;  ///< only told
    std::string input;
    std::string surface;  ///< stem of .vert and .face; empty: not written
    std::string area;     ///< .area is added if it is missing; empty: not written
    bool triangulated = true;
    bool with_area = true;
    bool without_hydrogens = false;
    bool with_header = true;
    bool all_components = false;
    std::vector<std::uint32_t> cavity_atoms{};  ///< of one_cavity, from 0 on; empty: not asked for
    bool help = false;
    std::vector<std::string> warnings{};  ///< of what was asked for and makes no difference
};

/// Reads the arguments. An option may be cut short; of several that begin so, the first in MSMS's order is meant.
/// throws   UsageError for what MSMS does not know, values that are missing or no numbers, and its server modes
MsmsRequest parse_msms(const std::vector<std::string>& arguments);

/// What `-h` prints.
std::string msms_usage();

}  // namespace meniscus::dropins
