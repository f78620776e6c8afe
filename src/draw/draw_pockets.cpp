// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/draw_pockets.h"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>

#include "meniscus/colours.h"
#include "meniscus/draw_surface.h"
#include "meniscus/ligand_bodies.h"
#include "meniscus/mesh_part.h"
#include "meniscus/write.h"

namespace meniscus {

namespace {

const ColourOptions kByPocket{.scheme = ColourScheme::Pocket};
constexpr double kSeeThrough = 0.35;      // opacity of the surface in pictures
constexpr std::uint8_t kBodyAlpha = 191;  // ligands are seen in there

constexpr const char* kPore = "pore";

PageWay way_of(const DescribedWay& described) {
    const TunnelPath& path = described.path;
    PageWay way{.radius = path.bottleneck.radius,
                .distance = path.points[path.bottleneck.point].distance,
                .bottleneck = path.bottleneck.position,
                .begin = path.points.front().position,
                .end = path.points.back().position,
                .length = path.length,
                .curvature = path.curvature};
    for (const std::string& atom : described.atoms) way.atoms.append(way.atoms.empty() ? "" : ", ").append(atom);
    if (path.bottleneck.at_end) way.atoms = "at an end, near " + way.atoms;
    way.profile.reserve(path.points.size());
    for (const PathPoint& point : path.points) way.profile.push_back({point.distance, point.radius});
    return way;
}

std::vector<PageWay> ways_of(const PocketWays& found) {
    std::vector<PageWay> ways;
    for (const DescribedTunnel& tunnel : found.tunnels) {
        PageWay way = way_of(tunnel.way);
        const std::size_t number = ways.size() + 1;
        way.name =
            tunnel.pocket ? fmt::format("tunnel {}.{}", *tunnel.pocket, tunnel.rank) : fmt::format("tunnel {}", number);
        way.from = tunnel.pocket ? fmt::format("pocket {}", *tunnel.pocket) : "start";
        way.rank = tunnel.rank;
        if (tunnel.pocket) way.colour = pocket_colour(static_cast<float>(*tunnel.pocket));
        ways.push_back(std::move(way));
    }
    if (found.pore) {
        ways.push_back(way_of(*found.pore));
        ways.back().name = ways.back().from = kPore;
    }
    return ways;
}

/// A pore stands upright, seen from the side, unless one asks for another view.
std::optional<Viewpoint> view_of(const PictureOptions& options, const std::vector<PageWay>& ways) {
    if (options.viewpoint || ways.empty() || ways.back().from != kPore) return options.viewpoint;
    const Vec3 along = ways.back().end - ways.back().begin;
    if (!(norm(along) > 0.0)) return {};
    const Vec3 axis = std::abs(along.z) < 0.8 * norm(along) ? Vec3{0.0, 0.0, 1.0} : Vec3{0.0, 1.0, 0.0};
    return Viewpoint{.from = cross(along, axis), .up = along};
}

/// The balls of a way, so near to each other that what they cover looks smooth; the narrowest is one of them.
Atoms balls_of(const TunnelPath& path) {
    constexpr double kStep = 0.15;  // of the radius
    Atoms balls;
    for (std::size_t i = 0; i < path.points.size(); ++i) {
        const auto& [position, distance, radius] = path.points[i];
        const bool is_needed = i == path.bottleneck.point || i + 1 == path.points.size() || balls.centres.empty();
        if (!is_needed && norm(position - balls.centres.back()) < kStep * radius) continue;
        balls.centres.push_back(position);
        balls.radii.push_back(radius);
    }
    return balls;
}

/// What the balls of a way cover, in the colours of their radii; coarser where it is wide.
Bodies tube_along(const TunnelPath& path, const RunOptions& run) {
    const Atoms balls = balls_of(path);
    const double widest = *std::max_element(balls.radii.begin(), balls.radii.end());
    const ExactSurface exact(balls, {SurfaceKind::Vdw, 0.0});
    Bodies tube{meniscus::mesh(exact, {.spacing = std::clamp(widest / 15.0, 0.3, 1.0)}, {.threads = run.threads}).mesh,
                {}};
    tube.mesh.components.assign(tube.mesh.vertices.size(), 0);
    tube.colours.reserve(tube.mesh.vertices.size());
    for (const std::uint32_t ball : tube.mesh.atoms) tube.colours.push_back(passage_colour(balls.radii[ball]));
    return tube;
}

}  // namespace

DrawnPockets::DrawnPockets(const ExactSurface& exact, const Pockets& pockets, const Structure& structure,
                           const PocketWays& ways, const RunOptions& run)
    : bodies_{pocket_bodies(pockets), {}}, ways_(ways_of(ways)) {
    surface_ = meniscus::mesh(exact, {}, run);
    surface_.mesh.values.push_back(pocket_values(pockets, surface_.mesh));
    colours_ = colour_vertices(surface_.mesh, structure, kByPocket);
    bodies_.colours = colour_vertices(bodies_.mesh, structure, kByPocket);
    for (Colour& colour : bodies_.colours) colour.alpha = kBodyAlpha;
    for (const DescribedTunnel& tunnel : ways.tunnels)
        tubes_ = joined(std::move(tubes_), tube_along(tunnel.way.path, run));
    if (ways.pore) tubes_ = joined(std::move(tubes_), tube_along(ways.pore->path, run));
}

Picture DrawnPockets::picture(const Structure& structure, const DrawPocketsOptions& options) const {
    PictureOptions picture = options.picture;
    picture.opacity = kSeeThrough;
    picture.viewpoint = view_of(picture, ways_);
    picture.threads = options.threads;
    return draw_surface(surface_, structure, {surface_.mesh, colours_},
                        {.picture = picture,
                         .scheme = kByPocket,
                         .legend = options.legend,
                         .ligands = options.ligands,
                         .beside = joined(bodies_, tubes_)});
}

std::string DrawnPockets::page(const Structure& structure, std::span<const DescribedPocket> described,
                               const DrawPocketsOptions& options) const {
    return make_page(surface_.mesh, structure,
                     {.colours = kByPocket,
                      .viewpoint = view_of(options.picture, ways_),
                      .projection = options.picture.projection,
                      .ligands = options.ligands,
                      .rows = page_rows(structure, surface_),
                      .pockets = page_pockets(described),
                      .bodies = &bodies_.mesh,
                      .ways = ways_,
                      .tubes = &tubes_,
                      .exact = surface_.exact,
                      .threads = options.threads});
}

void DrawnPockets::write_glb(const std::string& path, const Structure& structure,
                             const DrawPocketsOptions& options) const {
    std::vector<NamedMesh> named;
    for (std::size_t v = 0; v < bodies_.mesh.components.size(); ++v) {
        if (v > 0 && bodies_.mesh.components[v] == bodies_.mesh.components[v - 1]) continue;
        const std::uint32_t pocket = bodies_.mesh.components[v];
        named.push_back(
            {fmt::format("pocket {}", pocket + 1), part_of_component(bodies_.mesh, pocket).mesh, bodies_.colours[v]});
    }
    for (std::uint32_t w = 0; w < ways_.size(); ++w) {
        MeshPart tube = part_of_component(tubes_.mesh, w);
        std::vector<Colour> colours;
        colours.reserve(tube.vertices.size());
        for (const VertexId v : tube.vertices) colours.push_back(tubes_.colours[v]);
        named.push_back({.name = ways_[w].name, .mesh = std::move(tube.mesh), .colours = std::move(colours)});
    }
    const Bodies ligands = options.ligands ? ligand_bodies(structure.ligands, surface_.mesh, colours_) : Bodies{};
    write_mesh(path, surface_.mesh,
               {.colours = colours_,
                .structure = &structure,
                .beside = &ligands,
                .named = named,
                .probe = surface_.options.probe,
                .shortest_edge = surface_.measures.shortest_edge,
                .threads = options.threads});
}

}  // namespace meniscus
