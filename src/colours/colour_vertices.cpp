// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>

#include "colours/feature_colours.h"
#include "colours/palettes.h"
#include "meniscus/errors.h"

namespace meniscus {
namespace {

void check_options(const ColourOptions& options) {
    if (!options.range) return;
    if (!takes_range(options.scheme)) throw UsageError("only curvature, depth and bfactor take a range of values");
    if (!std::isfinite(options.range->min) || !std::isfinite(options.range->max) ||
        !(options.range->min < options.range->max))
        throw UsageError("a range of values needs two finite numbers, the smaller one first");
}

template <class T>
void need(const std::vector<T>& array, const Mesh& mesh, const char* name) {
    if (array.size() != mesh.vertices.size())
        throw UsageError(std::string("these colours need one value of '") + name + "' per vertex");
}

void check_atoms(const Mesh& mesh, const Structure& structure) {
    need(mesh.atoms, mesh, "atom");
    const std::size_t n = structure.labels.size();
    if (n != structure.atoms.size() ||
        std::any_of(mesh.atoms.begin(), mesh.atoms.end(), [n](auto a) { return a >= n; }))
        throw UsageError("the mesh names an atom that the structure does not have");
}

std::vector<Colour> by_feature(const Mesh& mesh, const Structure& structure, const FeatureColours& features) {
    check_atoms(mesh, structure);
    need(mesh.patches, mesh, "patch");
    std::vector<Colour> colours(mesh.vertices.size());
    for (std::size_t v = 0; v < colours.size(); ++v) colours[v] = features.at(mesh.atoms[v], mesh.patches[v]);
    return colours;
}

template <class T>
std::vector<Colour> by_value(const std::vector<T>& values, std::span<const Colour> ramp, const ValueRange& range) {
    std::vector<Colour> colours(values.size());
    std::transform(values.begin(), values.end(), colours.begin(),
                   [&](T value) { return ramp_colour(ramp, place_in(range, static_cast<double>(value))); });
    return colours;
}

/// What is no number lies outside every range; it must not reach the ramp.
Colour curvature_colour(const ValueRange& range, double curvature) {
    return ramp_colour(diverging_ramp(), std::isnan(curvature) ? 0.0 : place_in(range, curvature));
}

/// Of each vertex, how far it lies within the SES of a large probe, Å.
std::vector<double> depths(const Mesh& mesh, const Structure& structure) {
    std::vector<double> depth = signed_distance(AccessibleSurface(structure.atoms, kDepthProbe), mesh.vertices);
    for (double& d : depth) d = std::max(0.0, -d);
    return depth;
}

/// Six times the volume that each component encloses, negative for the wall of a cavity.
std::vector<double> volumes_of_components(const Mesh& mesh) {
    const std::uint32_t last =
        mesh.components.empty() ? 0 : *std::max_element(mesh.components.begin(), mesh.components.end());
    std::vector<double> volumes(std::size_t{last} + 1);
    const Vec3 origin = mesh.vertices.empty() ? Vec3{} : mesh.vertices.front();
    for (const auto& [a, b, c] : mesh.triangles)
        volumes[mesh.components[a]] +=
            dot(mesh.vertices[a] - origin, cross(mesh.vertices[b] - origin, mesh.vertices[c] - origin));
    return volumes;
}

std::vector<Colour> by_component(const Mesh& mesh) {
    need(mesh.components, mesh, "component");
    std::vector<Colour> of_component;
    std::size_t cavities = 0;
    for (const double volume : volumes_of_components(mesh))
        of_component.push_back(volume < 0.0 ? distinct_colour(++cavities) : kPlain);
    std::vector<Colour> colours(mesh.vertices.size());
    for (std::size_t v = 0; v < colours.size(); ++v) colours[v] = of_component[mesh.components[v]];
    return colours;
}

}  // namespace

std::vector<Colour> colour_vertices(const Mesh& mesh, const Structure& structure, const ColourOptions& options) {
    check_options(options);
    if (const auto features = feature_colours(structure, options)) return by_feature(mesh, structure, *features);
    if (options.scheme == ColourScheme::Component) return by_component(mesh);
    const ValueRange range = range_in_force(options, structure);
    if (options.scheme == ColourScheme::Depth) return by_value(depths(mesh, structure), cold_ramp(), range);
    need(mesh.mean_curvatures, mesh, "mean_curvature");
    return by_value(mesh.mean_curvatures, diverging_ramp(), range);
}

ColourField colour_by_feature(const AccessibleSurface& surface, const Structure& structure,
                              const ColourOptions& options) {
    check_options(options);
    if (options.scheme == ColourScheme::Curvature)
        return [&surface, range = range_in_force(options, structure)](const Vec3& point) {
            return curvature_colour(range, surface.nearest(point).mean_curvature);
        };
    auto features = feature_colours(structure, options);
    if (!features) return {};
    return [&surface, shared = std::make_shared<const FeatureColours>(std::move(*features))](const Vec3& point) {
        const NearestFeature nearest = surface.nearest(point);
        return shared->at(nearest.atom, nearest.patch);
    };
}

ColourField colour_by_level_set(const LevelSet& level_set, const ColourOptions& options) {
    check_options(options);
    if (options.scheme != ColourScheme::Curvature) return {};
    return [&level_set, range = range_in_force(options, {})](const Vec3& point) {
        return curvature_colour(range, level_set.sample(point).mean_curvature());
    };
}

}  // namespace meniscus
