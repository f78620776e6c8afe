// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "tables/hydropathy.h"

#include <algorithm>
#include <array>

namespace meniscus {
namespace {

struct Hydropathy {
    std::string_view residue;
    double value = 0.0;
};
constexpr std::array kHydropathies{
    Hydropathy{"ILE", 4.5},  Hydropathy{"VAL", 4.2},  Hydropathy{"LEU", 3.8},  Hydropathy{"PHE", 2.8},
    Hydropathy{"CYS", 2.5},  Hydropathy{"MET", 1.9},  Hydropathy{"ALA", 1.8},  Hydropathy{"GLY", -0.4},
    Hydropathy{"THR", -0.7}, Hydropathy{"SER", -0.8}, Hydropathy{"TRP", -0.9}, Hydropathy{"TYR", -1.3},
    Hydropathy{"PRO", -1.6}, Hydropathy{"HIS", -3.2}, Hydropathy{"GLU", -3.5}, Hydropathy{"GLN", -3.5},
    Hydropathy{"ASP", -3.5}, Hydropathy{"ASN", -3.5}, Hydropathy{"LYS", -3.9}, Hydropathy{"ARG", -4.5},
};

}  // namespace

std::optional<double> hydropathy_of(std::string_view standard_residue) {
    const auto* found = std::find_if(kHydropathies.begin(), kHydropathies.end(),
                                     [&](const Hydropathy& h) { return h.residue == standard_residue; });
    return found == kHydropathies.end() ? std::nullopt : std::optional(found->value);
}

}  // namespace meniscus
