// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The options and the results of tunnels and pores, described as describe_options.h and describe_results.h describe the
// others.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meniscus/describe_options.h"
#include "meniscus/describe_results.h"
#include "meniscus/structure.h"
#include "meniscus/tables.h"
#include "meniscus/tunnels.h"

namespace meniscus {

/// The options of tunnels that users choose.
template <MaybeConst<TunnelOptions> Options, class Visitor>
void describe(Options& o, Visitor&& visit) {
    visit(Option{.name = "tunnel_radius",
                 .brief = "Radius of the narrowest tunnels, Å",
                 .meaning = "Least radius of the bottleneck of a tunnel, Å; with `--tunnels` or `--tunnels-from`",
                 .example = "--tunnels --tunnel-radius 1.2",
                 .symbol = "R",
                 .range = NumberRange::Positive},
          o.min_radius);
    visit(Option{.name = "tunnel_count",
                 .brief = "Number of tunnels from each start",
                 .meaning = "Number of tunnels from each start, widest first; with `--tunnels` or `--tunnels-from`",
                 .example = "--tunnels --tunnel-count 1",
                 .symbol = "N"},
          o.count);
}

/// A way with the names of the atoms at its bottleneck.
struct DescribedWay {
    TunnelPath path;
    std::vector<std::string> atoms;  ///< labels, "A:SER 195 OG"
};

struct DescribedTunnel {
    std::optional<std::size_t> pocket;  ///< rank of the pocket where it begins; none for a given start
    std::size_t rank = 0;               ///< among those of its start, from 1
    DescribedWay way;
    std::optional<std::size_t> start{};  ///< number of the given start, from 1; none for a pocket
};

template <class Visitor>
void describe(const DescribedWay& w, Visitor& visit) {
    const TunnelPath& p = w.path;
    visit({"bottleneck_radius", "Å", "radius of the largest ball that passes: the clearance at the narrowest place"},
          p.bottleneck.radius);
    visit({"bottleneck", "Å", "the narrowest place, `[x, y, z]`"}, p.bottleneck.position);
    visit({"bottleneck_atoms", "", "the three atoms that the ball touches there, as `A:SER 195 OG`"}, w.atoms);
    visit({"bottleneck_at_end", "",
           "whether the narrowest place is an end of the way instead, so that the atoms are only the nearest ones"},
          p.bottleneck.at_end);
    visit({"certified_radius", "Å",
           "least clearance of the whole polyline, segments included: proves that a ball of this radius passes"},
          p.certified_radius);
    visit({"length", "Å", "length of the way"}, p.length);
    visit({"curvature", "", "length over the straight distance of the ends"}, p.curvature);
    visit.list({"profile", "", "list of the points of the polyline, from the start"}, p.points,
               [](auto& inner, const PathPoint& point) {
                   inner({"distance", "Å", "from the start, along the way"}, point.distance);
                   inner({"radius", "Å", "the clearance"}, point.radius);
                   inner({"position", "Å", "`[x, y, z]`"}, point.position);
               });
}

template <class Visitor>
void describe(const DescribedTunnel& t, Visitor& visit) {
    visit({"pocket", "", "rank of the pocket where it begins; `null` for a start that was given"}, t.pocket);
    visit({"start", "", "number of the start that was given, from 1; `null` for a pocket"}, t.start);
    visit({"rank", "", "place among the tunnels of its start, from 1: the widest first"}, t.rank);
    describe(t.way, visit);
}

DescribedWay describe_way(const TunnelPath& path, const Structure& structure);

/// A row per point of every tunnel, then of the pore.
///
/// pore   none: nullptr
Table profile_table(std::span<const DescribedTunnel> tunnels, const DescribedWay* pore);

}  // namespace meniscus
