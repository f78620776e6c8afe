// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Tunnels and pores of `meniscus pockets`: their options, how they are found, and what the summary says of them.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "meniscus/describe_tunnels.h"
#include "meniscus/draw_pockets.h"
#include "meniscus/pockets.h"
#include "meniscus/structure.h"
#include "meniscus/tunnels.h"
#include "meniscus/write.h"

namespace CLI {  // NOLINT(readability-identifier-naming): CLI11's name
class App;
}

namespace meniscus::cli {

/// A pore as it is asked for: along an axis through the middle of all atoms, or between two points.
struct AskedPore {
    std::string text;
    std::variant<Vec3, PoreEnds> way;  ///< direction, or ends
};

struct TunnelRequest {
    bool from_pockets = false;      ///< --tunnels
    std::vector<std::string> from;  ///< --tunnels-from: points, or selections
    std::optional<AskedPore> pore;  ///< --pore
    std::string table;              ///< --tunnel-table: path, empty for none
    TunnelOptions options;

    bool wants_tunnels() const { return from_pockets || !from.empty(); }
};

/// throws   UsageError for a start that selects nothing
void check_starts(const TunnelRequest& request, const Structure& structure);

struct FoundTunnels {
    std::optional<std::vector<DescribedTunnel>> tunnels;  ///< nothing where they were not asked for
    std::optional<DescribedWay> pore;                     ///< nothing also where no ball passes
    std::vector<std::string> notes;                       ///< on starts from which there is no tunnel
};

/// "x", "y" or "z", or the six coordinates of two points: "0,0,-20,0,0,20".
/// throws   UsageError
AskedPore parse_pore(const std::string& text);

/// Adds the options of tunnels and pores; parsing fills `request`, which must outlive the parser.
void add_tunnel_options(CLI::App& command, TunnelRequest& request);

/// throws   UsageError for --tunnel-table without anything to write
void check_tunnels(const TunnelRequest& request);

/// throws   UsageError for a start that selects nothing
FoundTunnels find_asked_tunnels(const TunnelRequest& request, const ExactSurface& exact, const Pockets& pockets,
                                const Structure& structure, const RunOptions& run);

/// The ways as write_pocket_atoms() takes them, as they are drawn, and as a table of radii.
PathsOfPockets paths_of(const FoundTunnels& found);
PocketWays drawable(const FoundTunnels& found);
Table profile_of(const FoundTunnels& found);

/// Completes the options of a report.
void report_tunnel_options(const TunnelRequest& request, nlohmann::ordered_json& block);

/// The lines of the summary; empty where nothing was asked for.
std::string describe_tunnels(const TunnelRequest& request, const FoundTunnels& found);

}  // namespace meniscus::cli
