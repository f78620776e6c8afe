// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <string>
#include <vector>

#include "meniscus/describe_tunnels.h"
#include "meniscus/measures.h"

namespace meniscus {
namespace {

std::string label_of(const Structure& structure, std::uint32_t atom) {
    const AtomLabel& label = structure.labels[atom];
    const std::string residue = structure.residues.empty() ? "" : spaced_label(structure.residues[label.residue]);
    if (residue.empty()) return "atom " + std::to_string(atom);
    return label.name.empty() ? residue : residue + " " + label.name;
}

// head: kind, number, pocket, rank
void add_rows(Table& table, const std::vector<Cell>& head, const TunnelPath& path) {
    for (const PathPoint& p : path.points) {
        std::vector<Cell>& row = table.rows.emplace_back(head);
        for (const double value : {p.distance, p.radius, p.position.x, p.position.y, p.position.z})
            row.emplace_back(value);
    }
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
        std::vector<Cell> head{std::string("tunnel"), ++number};
        if (tunnel.pocket)
            head.emplace_back(static_cast<std::int64_t>(*tunnel.pocket));
        else
            head.emplace_back();
        head.emplace_back(static_cast<std::int64_t>(tunnel.rank));
        add_rows(table, head, tunnel.way.path);
    }
    if (pore != nullptr) add_rows(table, {std::string("pore"), std::int64_t{1}, Cell(), Cell()}, pore->path);
    return table;
}

}  // namespace meniscus
