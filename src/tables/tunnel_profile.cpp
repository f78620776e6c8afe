// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <string>

#include "meniscus/describe_tunnels.h"
#include "meniscus/measures.h"

namespace meniscus {
namespace {

std::string label_of(const Structure& structure, std::uint32_t atom) {
    const AtomLabel& label = structure.labels[atom];
    if (structure.residues.empty()) return "atom " + std::to_string(atom);
    const std::string residue = spaced_label(structure.residues[label.residue]);
    return label.name.empty() ? residue : residue + " " + label.name;
}

void add_rows(Table& table, const char* kind, const Cell& number, const Cell& pocket, const Cell& rank,
              const TunnelPath& path) {
    for (const PathPoint& p : path.points)
        table.rows.push_back(
            {std::string(kind), number, pocket, rank, p.distance, p.radius, p.position.x, p.position.y, p.position.z});
}

}  // namespace

DescribedWay describe_way(const TunnelPath& path, const Structure& structure) {
    DescribedWay way{path, {}};
    for (const std::uint32_t atom : path.bottleneck.atoms)
        if (atom != kNone) way.atoms.push_back(label_of(structure, atom));
    return way;
}

Table profile_table(std::span<const DescribedTunnel> tunnels, const DescribedWay* pore) {
    Table table{{"kind", "number", "pocket", "rank", "distance", "radius", "x", "y", "z"}, {}};
    std::int64_t number = 0;
    for (const DescribedTunnel& tunnel : tunnels) {
        const Cell pocket = tunnel.pocket ? Cell(static_cast<std::int64_t>(*tunnel.pocket)) : Cell();
        add_rows(table, "tunnel", ++number, pocket, static_cast<std::int64_t>(tunnel.rank), tunnel.way.path);
    }
    if (pore != nullptr) add_rows(table, "pore", std::int64_t{1}, {}, {}, pore->path);
    return table;
}

}  // namespace meniscus
