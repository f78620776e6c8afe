// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <string>
#include <type_traits>
#include <vector>

#include "meniscus/describe_pockets.h"

namespace meniscus {
namespace {

double area_of(const std::vector<PocketMouth>& mouths) {
    double area = 0.0;
    for (const PocketMouth& mouth : mouths) area += mouth.area;
    return area;
}

template <class T>
std::string joined(const std::vector<T>& words) {
    std::string text;
    for (const T& word : words) {
        text += text.empty() ? "" : "; ";
        if constexpr (std::is_same_v<T, std::string>)
            text += word;
        else
            text += std::to_string(word);
    }
    return text;
}

}  // namespace

Table pockets_table(const std::vector<DescribedPocket>& pockets) {
    Table table{{"rank", "score", "probability", "tied_with", "cavity", "volume", "wall_area", "depth", "x", "y", "z",
                 "mouths", "mouth_area", "openings", "opening_area", "hydrophobicity", "charge", "donors", "acceptors",
                 "residues"},
                {}};
    for (const DescribedPocket& described : pockets) {
        const Pocket& p = described.pocket;
        const PocketChemistry& c = described.chemistry;
        table.rows.push_back({static_cast<std::int64_t>(p.rank), p.score, p.probability, joined(p.tied_with), p.cavity, p.volume, p.wall_area, p.depth, p.centre.x,
                              p.centre.y, p.centre.z, static_cast<std::int64_t>(p.mouths.size()), area_of(p.mouths),
                              static_cast<std::int64_t>(p.openings.size()), area_of(p.openings), c.hydrophobicity,
                              static_cast<std::int64_t>(c.charge), static_cast<std::int64_t>(c.donors),
                              static_cast<std::int64_t>(c.acceptors), joined(described.residues)});
    }
    return table;
}

}  // namespace meniscus
