// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pockets_tunnels.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <CLI/App.hpp>
#include <algorithm>
#include <array>
#include <cstddef>

#include "io/options_json.h"
#include "meniscus/errors.h"
#include "messages.h"
#include "option_words.h"
#include "reading/option_numbers.h"
#include "summary_text.h"

namespace meniscus::cli {

using nlohmann::ordered_json;

namespace {

constexpr std::size_t kMostRows = 30;

Vec3 middle_of(const std::vector<Vec3>& centres) {
    Vec3 sum;
    for (const Vec3& centre : centres) sum += centre;
    return (1.0 / static_cast<double>(std::max<std::size_t>(centres.size(), 1))) * sum;
}

Vec3 start_of(const std::string& text, const Structure& structure) {
    constexpr const char* kOption = "--tunnels-from";
    if (const std::optional<Vec3> point = point_in(kOption, text)) return *point;
    const std::vector<bool> selected = select_atoms(structure, text, kOption);
    std::vector<Vec3> centres;
    for (std::size_t i = 0; i < selected.size(); ++i)
        if (selected[i]) centres.push_back(structure.atoms.centres[i]);
    return middle_of(centres);
}

// Why tunnels from given starts are missing.
std::vector<std::string> notes_on_starts(const TunnelRequest& request, std::span<const Vec3> starts,
                                         const std::vector<DescribedTunnel>& found, const ExactSurface& bulk) {
    std::vector<std::string> notes;
    const std::vector<double> distances = bulk.signed_distance(starts.first(request.from.size()));
    for (std::size_t i = 0; i < request.from.size(); ++i) {
        if (std::any_of(found.begin(), found.end(), [&](const DescribedTunnel& t) { return t.start == i + 1; }))
            continue;
        const std::string name = "--tunnels-from " + one_line(request.from[i]);
        notes.push_back(distances[i] >= 0.0
                            ? name + ": lies outside the molecule, in the bulk"
                            : fmt::format("{}: no ball of {} Å gets out", name, request.options.min_radius));
    }
    return notes;
}

FoundTunnels find_from_starts(const TunnelRequest& request, const ExactSurface& exact, const Pockets& pockets,
                              const Structure& structure, const RunOptions& run) {
    std::vector<Vec3> starts;
    std::vector<std::optional<std::size_t>> ranks;
    for (const std::string& text : request.from) {
        starts.push_back(start_of(text, structure));
        ranks.emplace_back();
    }
    for (const Pocket& pocket : pockets.pockets) {
        if (!request.from_pockets) break;
        if (pocket.voxels.empty() && !pocket.cavity) continue;  // a place of --at without pocket space
        starts.push_back(pocket.deepest);
        ranks.emplace_back(pocket.rank);
    }
    TunnelOptions options = request.options;
    options.large_probe = pockets.options.large_probe;
    std::vector<DescribedTunnel> described;
    for (const Tunnel& tunnel : find_tunnels(exact, starts, options, run)) {
        const std::optional<std::size_t> given =
            tunnel.start < request.from.size() ? std::optional(tunnel.start + 1) : std::nullopt;
        described.push_back({ranks[tunnel.start], tunnel.rank, describe_way(tunnel.path, structure), given});
    }
    FoundTunnels found;
    found.notes =
        notes_on_starts(request, starts, described, exact.of_same_atoms({SurfaceKind::Ses, options.large_probe}));
    found.tunnels = std::move(described);
    return found;
}

std::optional<TunnelPath> find_asked_pore(const AskedPore& asked, const ExactSurface& exact, const RunOptions& run) {
    const Vec3* direction = std::get_if<Vec3>(&asked.way);
    const PoreEnds ends = direction != nullptr ? ends_along(exact, middle_of(exact.atoms().centres), *direction)
                                               : std::get<PoreEnds>(asked.way);
    return find_pore(exact, ends, {}, run);
}

std::string atoms_of(const DescribedWay& way) {
    std::string text;
    for (const std::string& atom : way.atoms) text.append(text.empty() ? "" : ", ").append(one_line(atom));
    return way.path.bottleneck.at_end ? "at an end, near " + text : text;
}

std::string row_of(const std::string& name, const std::string& rank, const DescribedWay& way) {
    return fmt::format("  {:>8} {:>5} {:>8.3f} {:>9.1f} {:>9.2f}  {}\n", name, rank, way.path.bottleneck.radius,
                       way.path.length, way.path.curvature, atoms_of(way));
}

}  // namespace

AskedPore parse_pore(const std::string& text) {
    if (text == "x") return {text, Vec3{1.0, 0.0, 0.0}};
    if (text == "y") return {text, Vec3{0.0, 1.0, 0.0}};
    if (text == "z") return {text, Vec3{0.0, 0.0, 1.0}};
    if (std::count(text.begin(), text.end(), ',') != 5)
        throw UsageError(fmt::format("--pore {}: must be x, y or z, or two points X,Y,Z,X,Y,Z", one_line(text)));
    const std::vector<double> n = numbers_in("--pore", text);
    const PoreEnds ends{{n[0], n[1], n[2]}, {n[3], n[4], n[5]}};
    if (ends.from == ends.to) throw UsageError(fmt::format("--pore {}: both points are the same", one_line(text)));
    return {text, ends};
}

void add_tunnel_options(CLI::App& command, TunnelRequest& request) {
    command.add_flag("--tunnels", request.from_pockets, "Tunnels from every pocket and cavity to the bulk");
    command
        .add_option_function<std::vector<std::string>>(
            "--tunnels-from",
            [&request](const std::vector<std::string>& texts) {
                for (const std::string& text : texts) {
                    if (text.empty()) throw UsageError("--tunnels-from: needs a point X,Y,Z or a selection");
                    point_in("--tunnels-from", text);
                    request.from.push_back(text);
                }
            },
            "Tunnels from a point, or from the middle of the selected atoms; repeatable")
        ->type_name("X,Y,Z|SEL")
        ->allow_extra_args(false);
    describe(request.options, OptionAdder{command});
    add_word(command, {"--pore", "Pore along an axis, or between two points X,Y,Z,X,Y,Z", "AXIS|FROM,TO"},
             [&request](const std::string& text) { request.pore = parse_pore(text); });
}

void check_starts(const TunnelRequest& request, const Structure& structure) {
    for (const std::string& text : request.from) start_of(text, structure);
}

void check_tunnels(const TunnelRequest& request) {
    if (!request.table.empty() && !request.wants_tunnels() && !request.pore)
        throw UsageError("--tunnel-table needs --tunnels, --tunnels-from or --pore");
}

FoundTunnels find_asked_tunnels(const TunnelRequest& request, const ExactSurface& exact, const Pockets& pockets,
                                const Structure& structure, const RunOptions& run) {
    FoundTunnels found;
    if (request.wants_tunnels()) found = find_from_starts(request, exact, pockets, structure, run);
    if (request.pore)
        if (const auto path = find_asked_pore(*request.pore, exact, run)) found.pore = describe_way(*path, structure);
    return found;
}

PathsOfPockets paths_of(const FoundTunnels& found) {
    PathsOfPockets paths;
    for (const DescribedTunnel& tunnel : found.tunnels.value_or(std::vector<DescribedTunnel>{}))
        paths.tunnels.push_back(tunnel.way.path);
    if (found.pore) paths.pore = found.pore->path;
    return paths;
}

PocketWays drawable(const FoundTunnels& found) {
    return {found.tunnels.value_or(std::vector<DescribedTunnel>{}), found.pore};
}

Table profile_of(const FoundTunnels& found) {
    return profile_table(found.tunnels.value_or(std::vector<DescribedTunnel>{}), found.pore ? &*found.pore : nullptr);
}

void report_tunnel_options(const TunnelRequest& request, ordered_json& block) {
    OptionsAsJson options{SurfaceOptions{}};
    describe(request.options, options);
    block["tunnels"] = request.from_pockets;
    block["tunnels_from"] = request.from;
    block.update(options.block);
    block["pore"] = request.pore ? ordered_json(request.pore->text) : ordered_json();
}

std::string describe_tunnels(const TunnelRequest& request, const FoundTunnels& found) {
    std::string text;
    const bool has_rows = (found.tunnels && !found.tunnels->empty()) || found.pore;
    if (has_rows)
        text += fmt::format("  {:>8} {:>5} {:>8} {:>9} {:>9}  {}\n", "from", "rank", "radius/Å", "length/Å",
                            "curvature", "narrowest between");
    if (found.tunnels) {
        std::size_t rows = 0;
        for (const DescribedTunnel& tunnel : *found.tunnels)
            if (rows++ < kMostRows)
                text += row_of(
                    tunnel.pocket ? fmt::format("pocket {}", *tunnel.pocket) : fmt::format("start {}", *tunnel.start),
                    std::to_string(tunnel.rank), tunnel.way);
        if (rows > kMostRows)
            text += fmt::format("           and {} more tunnels; list all with --report FILE\n", rows - kMostRows);
        if (rows == 0) text += summary_line("tunnels", fmt::format("none of {} Å", request.options.min_radius));
    }
    if (found.pore)
        text += row_of("pore " + (request.pore->text.size() == 1 ? request.pore->text : ""), "", *found.pore);
    if (request.pore && !found.pore)
        text += summary_line("pore", fmt::format("none: no ball of {} Å passes", PoreOptions{}.min_radius));
    return text;
}

}  // namespace meniscus::cli
