// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pockets_drawing.h"

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

namespace meniscus::cli {

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

std::vector<PageWay> ways_of(const FoundTunnels& found) {
    std::vector<PageWay> ways;
    for (const DescribedTunnel& tunnel : found.tunnels.value_or(std::vector<DescribedTunnel>{})) {
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
std::optional<Viewpoint> view_of(const PictureRequest& request, const std::vector<PageWay>& ways) {
    if (request.picture.viewpoint || ways.empty() || ways.back().from != kPore) return request.picture.viewpoint;
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
                           const FoundTunnels& ways, const RunOptions& run)
    : bodies_{pocket_bodies(pockets), {}}, ways_(ways_of(ways)) {
    surface_ = meniscus::mesh(exact, {}, run);
    surface_.mesh.values.push_back(pocket_values(pockets, surface_.mesh));
    colours_ = colour_vertices(surface_.mesh, structure, kByPocket);
    bodies_.colours = colour_vertices(bodies_.mesh, structure, kByPocket);
    for (Colour& colour : bodies_.colours) colour.alpha = kBodyAlpha;
    const PathsOfPockets paths = paths_of(ways);
    for (const TunnelPath& path : paths.tunnels) tubes_ = joined(std::move(tubes_), tube_along(path, run));
    if (paths.pore) tubes_ = joined(std::move(tubes_), tube_along(*paths.pore, run));
}

Picture DrawnPockets::picture(const Structure& structure, const PictureRequest& request, int threads) const {
    PictureOptions options = request.picture;
    options.opacity = kSeeThrough;
    options.viewpoint = view_of(request, ways_);
    options.threads = threads;
    return draw_surface(surface_, structure, {surface_.mesh, colours_},
                        {.picture = options,
                         .scheme = kByPocket,
                         .legend = request.legend,
                         .ligands = request.ligands,
                         .beside = joined(bodies_, tubes_)});
}

std::string DrawnPockets::page(const Structure& structure, const PictureRequest& request,
                               const std::vector<DescribedPocket>& described, int threads) const {
    return make_page(surface_.mesh, structure,
                     {.colours = kByPocket,
                      .viewpoint = view_of(request, ways_),
                      .projection = request.picture.projection,
                      .ligands = request.ligands,
                      .rows = page_rows(structure, surface_),
                      .pockets = page_pockets(described),
                      .bodies = &bodies_.mesh,
                      .ways = ways_,
                      .tubes = &tubes_,
                      .exact = surface_.exact,
                      .threads = threads});
}

void DrawnPockets::write_glb(const std::string& path, const Structure& structure, bool with_ligands,
                             int threads) const {
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
    const Bodies ligands = with_ligands ? ligand_bodies(structure.ligands, surface_.mesh, colours_) : Bodies{};
    write_mesh(path, surface_.mesh,
               {.colours = colours_,
                .structure = &structure,
                .beside = &ligands,
                .named = named,
                .probe = surface_.options.probe,
                .shortest_edge = surface_.measures.shortest_edge,
                .threads = threads});
}

}  // namespace meniscus::cli
