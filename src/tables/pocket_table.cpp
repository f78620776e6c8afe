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
        row.emplace_back(described.at);
        row.emplace_back(static_cast<std::int64_t>(p.site));
        const LigandFit ligand = described.ligand.value_or(LigandFit{});
        row.emplace_back(static_cast<std::int64_t>(ligand.atoms));
        row.emplace_back(static_cast<std::int64_t>(ligand.inside));
        row.emplace_back(ligand.area);
        row.emplace_back(ligand.buried_area);
        row.emplace_back(static_cast<std::int64_t>(described.track));
    }
    return table;
}

Table tracks_table(const std::vector<DescribedTrack>& tracks, std::size_t models) {
    Table table{{"track", "models", "of", "open", "best_rank", "score", "score_sd", "volume", "volume_sd", "depth",
                 "depth_sd", "mouth_radius", "mouth_radius_sd", "ways", "bottleneck", "bottleneck_sd", "residues"},
                {}};
    for (const DescribedTrack& described : tracks) {
        const PocketTrack& t = described.track;
        table.rows.push_back({static_cast<std::int64_t>(described.number), static_cast<std::int64_t>(t.models),
                              static_cast<std::int64_t>(models), static_cast<std::int64_t>(t.open),
                              static_cast<std::int64_t>(t.best_rank), t.score.mean, t.score.deviation, t.volume.mean,
                              t.volume.deviation, t.depth.mean, t.depth.deviation, t.mouth_radius.mean,
                              t.mouth_radius.deviation, static_cast<std::int64_t>(t.ways), t.bottleneck.mean,
                              t.bottleneck.deviation, joined(described.residues)});
    }
    return table;
}

}  // namespace meniscus
