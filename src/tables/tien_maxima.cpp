// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "tables/tien_maxima.h"

#include <algorithm>
#include <array>

namespace meniscus {
namespace {

struct Maximum {
    std::string_view name;
    double area;  // Å²
};

constexpr std::array<Maximum, 20> kMaxima{
    {{"ALA", 129.0}, {"ARG", 274.0}, {"ASN", 195.0}, {"ASP", 193.0}, {"CYS", 167.0}, {"GLN", 225.0}, {"GLU", 223.0},
     {"GLY", 104.0}, {"HIS", 224.0}, {"ILE", 197.0}, {"LEU", 201.0}, {"LYS", 236.0}, {"MET", 224.0}, {"PHE", 240.0},
     {"PRO", 159.0}, {"SER", 155.0}, {"THR", 172.0}, {"TRP", 285.0}, {"TYR", 263.0}, {"VAL", 174.0}}};

}  // namespace

std::optional<double> tien_maximum(std::string_view name) {
    const auto* const found =
        std::find_if(kMaxima.begin(), kMaxima.end(), [&](const Maximum& m) { return m.name == name; });
    if (found == kMaxima.end()) return std::nullopt;
    return found->area;
}

}  // namespace meniscus
