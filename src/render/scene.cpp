// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "render/cut_plane.h"
#include "render/sky_reach.h"

namespace meniscus {
namespace {

/// Of a section through the molecule: a light, warm grey that no palette has.
constexpr Colour kSection{222, 217, 208, 255};

/// Least share of the sky for bodies beside the surface: what lies in a deep pocket is to be seen in its colours.
constexpr double kLeastSkyOfBodies = 0.6;

/// A quantity of the corners at a point of the triangle.
template <class T, class Get>
T interpolated(const Triangle& t, const RayHit& hit, const Get& get) {
    return (1.0 - hit.u - hit.v) * get(t[0]) + hit.u * get(t[1]) + hit.v * get(t[2]);
}

Light interpolated_light(const Triangle& t, const RayHit& hit, std::span<const Colour> colours) {
    const auto u = static_cast<float>(hit.u);
    const auto v = static_cast<float>(hit.v);
    return (1.0F - u - v) * to_light(colours[t[0]]) + u * to_light(colours[t[1]]) + v * to_light(colours[t[2]]);
}

/// The camera that looks at a surface and has the bodies beside it in its picture, too: they do not turn it.
Camera camera_of(const Mesh& surface, const Mesh& bodies, const PictureOptions& options) {
    if (bodies.vertices.empty()) return {surface.vertices, options};
    PictureOptions same_view = options;
    if (!same_view.viewpoint) {
        const ViewFrame frame = principal_frame(surface.vertices);
        same_view.viewpoint = Viewpoint{frame.towards, frame.up};
    }
    std::vector<Vec3> all = surface.vertices;
    all.insert(all.end(), bodies.vertices.begin(), bodies.vertices.end());
    return {all, same_view};
}

/// Without the bodies of which a cut keeps nothing.
Mesh kept_bodies(const Mesh& bodies, const HalfSpace& kept) {
    std::set<std::uint32_t> shown;
    for (std::size_t v = 0; v < bodies.vertices.size(); ++v)
        if (kept.contains(bodies.vertices[v])) shown.insert(bodies.components[v]);
    Mesh rest = bodies;
    std::erase_if(rest.triangles, [&](const Triangle& t) { return !shown.contains(bodies.components[t[0]]); });
    return rest;
}

}  // namespace

Scene::Scene(const Painted& surface, const RayScene& rays, const PictureOptions& options, const ColourField& exact,
             const Bodies& beside)
    : surface_(surface),
      colours_of_bodies_(beside.colours),
      options_(options),
      exact_(exact),
      camera_(camera_of(surface.mesh, beside.mesh, options)),
      kept_(options.cut ? std::optional(find_cut(surface.mesh, *options.cut, Camera(surface.mesh.vertices, options)))
                        : std::nullopt),
      has_section_(kept_ && is_body(surface.mesh)),
      rays_(kept_ ? rays.cut(*kept_) : rays),
      sky_({rays_, surface.mesh, reach_of_sky(camera_)}),
      sky_from_inside_({rays_, surface.mesh, reach_of_sky(camera_), SkyRays::Side::Molecule}),
      lamps_(camera_.frame()),
      background_(to_light(options.background)),
      front_(nearest_kept()) {
    const Mesh shown = kept_ ? kept_bodies(beside.mesh, *kept_) : beside.mesh;
    for (const bool solid : {true, false}) {
        Mesh alike = shown;
        std::erase_if(alike.triangles, [&](const Triangle& t) { return (beside.colours[t[0]].alpha == 255) != solid; });
        if (!alike.triangles.empty())
            beside_.push_back(std::make_unique<Beside>(std::move(alike), rays_, reach_of_sky(camera_)));
    }
}

double Scene::nearest_kept() const {
    if (!kept_) return 0.0;
    double nearest = camera_.depth_range();
    for (const Vec3& vertex : surface_.mesh.vertices)
        if (kept_->contains(vertex)) nearest = std::min(nearest, camera_.depth(vertex));
    return nearest;
}

/// True where a ray meets the side of the molecule: walls of cavities shown alone, meshes that are not closed.
bool Scene::faces_away(const Triangle& t, const Vec3& direction) const {
    const std::vector<Vec3>& corners = surface_.mesh.vertices;
    const Vec3& corner = corners[t[0]];
    return dot(cross(corners[t[1]] - corner, corners[t[2]] - corner), direction) > 0.0;
}

Light Scene::light_from(const Sight& sight) const {
    const RayHit& hit = *sight.hit;
    const Mesh& mesh = mesh_of(sight);
    const Triangle& t = mesh.triangles[hit.triangle];
    Vec3 normal = normalised(interpolated<Vec3>(t, hit, [&mesh](VertexId v) { return mesh.normals[v]; }));
    if (sight.from_inside) normal = -normal;
    const SkyLight& seen_sky = sight.body != nullptr ? sight.body->sky : sight.from_inside ? sky_from_inside_ : sky_;
    auto sky = interpolated<double>(t, hit, [&seen_sky](VertexId v) { return double{seen_sky.at(v)}; });
    if (sight.body != nullptr) sky = kLeastSkyOfBodies + (1.0 - kLeastSkyOfBodies) * sky;
    return lamps_.shade(sight.albedo, normal, -sight.ray.direction, static_cast<float>(sky));
}

Glimpse Scene::glimpse(Glimpse::Kind kind, const Light& light, const Vec3& point) const {
    const double depth = std::max(0.0, camera_.depth(point));
    const double share = (depth - front_) / std::max(camera_.depth_range() - front_, 1e-9);
    const double haze = options_.depth_cue * std::clamp(share, 0.0, 1.0);
    return {mixed(light, background_, static_cast<float>(haze)), static_cast<float>(depth), kind};
}

std::vector<Scene::Sight> Scene::sights_at(std::span<const Spot> spots) const {
    std::vector<Sight> sights;
    sights.reserve(spots.size());
    std::array<Ray, RayScene::kTogether> rays;
    std::array<std::optional<RayHit>, RayScene::kTogether> hits;
    for (; !spots.empty(); spots = spots.subspan(std::min(rays.size(), spots.size()))) {
        const std::span<const Spot> few = spots.first(std::min(rays.size(), spots.size()));
        std::transform(few.begin(), few.end(), rays.begin(),
                       [this](const Spot& spot) { return camera_.ray(spot.x, spot.y); });
        rays_.first_hits(std::span(rays).first(few.size()), std::numeric_limits<double>::infinity(), hits);
        for (std::size_t i = 0; i < few.size(); ++i) {
            const bool inside = hits[i] && faces_away(surface_.mesh.triangles[hits[i]->triangle], rays[i].direction);
            sights.push_back({.ray = rays[i], .hit = hits[i], .from_inside = inside});
        }
    }
    return sights;
}

/// Where along its ray something of the surface is seen, Å: a section before what is hit behind it.
double Scene::seen_at(const Sight& sight) const {
    if (!sight.hit) return std::numeric_limits<double>::infinity();
    if (shows_section(sight)) return kept_->part_of_ray(sight.ray.origin, sight.ray.direction).begin;
    return sight.hit->distance;
}

/// What the same rays hit of bodies.
std::vector<Scene::Sight> Scene::sights_of(const Beside& bodies, std::span<const Sight> along) const {
    std::vector<Sight> sights;
    sights.reserve(along.size());
    std::array<Ray, RayScene::kTogether> rays;
    std::array<std::optional<RayHit>, RayScene::kTogether> hits;
    for (; !along.empty(); along = along.subspan(std::min(rays.size(), along.size()))) {
        const std::span<const Sight> few = along.first(std::min(rays.size(), along.size()));
        std::transform(few.begin(), few.end(), rays.begin(), [](const Sight& sight) { return sight.ray; });
        bodies.rays.first_hits(std::span(rays).first(few.size()), std::numeric_limits<double>::infinity(), hits);
        for (std::size_t i = 0; i < few.size(); ++i)
            sights.push_back({.ray = rays[i], .hit = hits[i], .body = &bodies});
    }
    return sights;
}

float Scene::opacity_of(const Sight& sight) const {
    if (shows_section(sight)) return 1.0F;
    if (sight.body == nullptr) return static_cast<float>(options_.opacity);
    return static_cast<float>(colours_of_bodies_[sight.body->mesh.triangles[sight.hit->triangle][0]].alpha) / 255.0F;
}

/// Forgets what lies behind something solid along one ray, which is not to be asked for its colour.
void Scene::forget_hidden(std::span<std::vector<Sight>> layers, std::size_t ray) const {
    double solid = std::numeric_limits<double>::infinity();
    for (const std::vector<Sight>& layer : layers)
        if (layer[ray].hit && opacity_of(layer[ray]) == 1.0F) solid = std::min(solid, seen_at(layer[ray]));
    for (std::vector<Sight>& layer : layers)
        if (layer[ray].hit && seen_at(layer[ray]) > solid) layer[ray].hit.reset();
}

/// Where the corners of triangles differ the exact colours are asked for, all at once.
void Scene::find_albedos(std::span<Sight> sights) const {
    std::vector<std::size_t> asked;
    std::vector<Vec3> points;
    for (std::size_t i = 0; i < sights.size(); ++i) {
        if (!sights[i].hit || shows_section(sights[i])) continue;
        const Triangle& t = mesh_of(sights[i]).triangles[sights[i].hit->triangle];
        const bool of_body = sights[i].body != nullptr;
        const std::span<const Colour> colours = of_body ? colours_of_bodies_ : surface_.colours;
        const bool uniform = colours[t[0]] == colours[t[1]] && colours[t[1]] == colours[t[2]];
        if (uniform || !exact_ || of_body) {
            sights[i].albedo = uniform ? to_light(colours[t[0]]) : interpolated_light(t, *sights[i].hit, colours);
            continue;
        }
        asked.push_back(i);
        points.push_back(sights[i].point());
    }
    if (asked.empty()) return;
    std::vector<Colour> colours(asked.size());
    exact_(points, colours);
    for (std::size_t i = 0; i < asked.size(); ++i) sights[asked[i]].albedo = to_light(colours[i]);
}

Glimpse Scene::glimpse_of(const Sight& sight) const {
    if (!sight.hit) return {.light = background_};
    const Ray& ray = sight.ray;
    if (shows_section(sight))
        return glimpse(Glimpse::Kind::Section, to_light(kSection),
                       ray.origin + kept_->part_of_ray(ray.origin, ray.direction).begin * ray.direction);
    return glimpse(sight.body != nullptr ? Glimpse::Kind::Body : Glimpse::Kind::Surface, light_from(sight),
                   sight.point());
}

/// What is seen of a surface and bodies along one ray, through those that are clear.
Glimpse Scene::glimpse_through(std::span<const Sight* const> sights) const {
    std::vector<const Sight*> order(sights.begin(), sights.end());
    std::erase_if(order, [](const Sight* sight) { return !sight->hit; });
    if (order.empty()) return {.light = background_};
    std::sort(order.begin(), order.end(), [this](const Sight* a, const Sight* b) { return seen_at(*a) < seen_at(*b); });
    Glimpse seen = glimpse_of(*order.front());
    float left = 1.0F - opacity_of(*order.front());  // of what lies behind
    if (left <= 0.0F) return seen;
    seen.light = (1.0F - left) * seen.light;
    for (std::size_t i = 1; i < order.size() && left > 0.0F; ++i) {
        const float opacity = opacity_of(*order[i]);
        seen.light += left * opacity * glimpse_of(*order[i]).light;
        left *= 1.0F - opacity;
    }
    seen.light += left * background_;
    return seen;
}

std::vector<Glimpse> Scene::look(std::span<const Spot> spots) const {
    std::vector<std::vector<Sight>> layers{sights_at(spots)};
    for (const std::unique_ptr<Beside>& bodies : beside_) layers.push_back(sights_of(*bodies, layers.front()));
    for (std::size_t i = 0; i < spots.size(); ++i) forget_hidden(layers, i);
    for (std::vector<Sight>& layer : layers) find_albedos(layer);
    std::vector<Glimpse> seen;
    seen.reserve(spots.size());
    std::vector<const Sight*> along(layers.size());
    for (std::size_t i = 0; i < spots.size(); ++i) {
        std::transform(layers.begin(), layers.end(), along.begin(), [i](const std::vector<Sight>& l) { return &l[i]; });
        seen.push_back(glimpse_through(along));
    }
    return seen;
}

}  // namespace meniscus
