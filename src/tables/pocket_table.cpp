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

// Cells without a meaning stay empty.
void add_place(std::vector<Cell>& row, const DescribedPocket& described) {
    const bool is_given = !described.at.empty();
    row.push_back(is_given ? Cell(described.at) : Cell());
    row.push_back(is_given && described.pocket.site > 0 ? Cell(static_cast<std::int64_t>(described.pocket.site))
                                                        : Cell());
    if (!described.ligand) {
        row.resize(row.size() + 4);
        return;
    }
    row.emplace_back(static_cast<std::int64_t>(described.ligand->atoms));
    row.emplace_back(static_cast<std::int64_t>(described.ligand->inside));
    row.emplace_back(described.ligand->area);
    row.emplace_back(described.ligand->buried_area);
}

void add_spread(std::vector<Cell>& row, const Spread& spread) {
    row.push_back(spread.values > 0 ? Cell(spread.mean) : Cell());
    row.push_back(spread.values > 1 ? Cell(spread.deviation) : Cell());
}

}  // namespace

Table pockets_table(const std::vector<DescribedPocket>& pockets) {
    Table table{{"rank",
                 "score",
                 "probability",
                 "tied_with",
                 "cavity",
                 "volume",
                 "wall_area",
                 "depth",
                 "x",
                 "y",
                 "z",
                 "mouths",
                 "mouth_area",
                 "openings",
                 "opening_area",
                 "hydrophobicity",
                 "charge",
                 "donors",
                 "acceptors",
                 "residues",
                 "at",
                 "site",
                 "ligand_atoms",
                 "ligand_inside",
                 "ligand_area",
                 "ligand_buried_area",
                 "track"},
                {}};
    for (const DescribedPocket& described : pockets) {
        const Pocket& p = described.pocket;
        const PocketChemistry& c = described.chemistry;
        table.rows.push_back({static_cast<std::int64_t>(p.rank),
                              p.score,
                              p.probability,
                              joined(p.tied_with),
                              p.cavity,
                              p.volume,
                              p.wall_area,
                              p.depth,
                              p.centre.x,
                              p.centre.y,
                              p.centre.z,
                              static_cast<std::int64_t>(p.mouths.size()),
                              area_of(p.mouths),
                              static_cast<std::int64_t>(p.openings.size()),
                              area_of(p.openings),
                              c.hydrophobicity,
                              static_cast<std::int64_t>(c.charge),
                              static_cast<std::int64_t>(c.donors),
                              static_cast<std::int64_t>(c.acceptors),
                              joined(described.residues)});
        std::vector<Cell>& row = table.rows.back();
        add_place(row, described);
        row.push_back(described.track == 0 ? Cell() : Cell(static_cast<std::int64_t>(described.track)));
    }
    return table;
}

Table tracks_table(const std::vector<DescribedTrack>& tracks, std::size_t models, bool with_tunnels) {
    Table table{{"track", "models", "of", "open", "best_rank", "score", "score_sd", "volume", "volume_sd", "depth",
                 "depth_sd", "mouth_radius", "mouth_radius_sd", "ways", "bottleneck", "bottleneck_sd", "residues"},
                {}};
    for (const DescribedTrack& described : tracks) {
        const PocketTrack& t = described.track;
        std::vector<Cell>& row = table.rows.emplace_back();
        for (const std::size_t count : {described.number, t.models, models, t.open, t.best_rank})
            row.emplace_back(static_cast<std::int64_t>(count));
        for (const Spread& spread : {t.score, t.volume, t.depth, t.mouth_radius}) add_spread(row, spread);
        row.push_back(with_tunnels ? Cell(static_cast<std::int64_t>(t.ways)) : Cell());
        add_spread(row, t.bottleneck);
        row.emplace_back(joined(described.residues));
    }
    return table;
}

}  // namespace meniscus
