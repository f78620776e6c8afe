// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>
#include <memory>

#include "colours/checks.h"
#include "colours/component_colours.h"
#include "colours/depths.h"
#include "colours/feature_colours.h"
#include "colours/palettes.h"
#include "core/parallel.h"
#include "meniscus/vertex_values.h"
#include "platform/fresh_memory.h"

namespace meniscus {
namespace {

constexpr std::size_t kGrain = 1 << 14;  // vertices per task: some tens of microseconds

std::vector<Colour> by_feature(const Mesh& mesh, const Structure& structure, const FeatureColours& features) {
    check_atoms(mesh, structure);
    check_values(mesh.patches, mesh, "patch");
    std::vector<Colour> colours;
    resize_touched(colours, mesh.vertices.size());
    parallel_for(colours.size(), kGrain,
                 [&](std::size_t v) { colours[v] = features.at(mesh.atoms[v], mesh.patches[v]); });
    return colours;
}

template <class T>
std::vector<Colour> by_value(const std::vector<T>& values, std::span<const Colour> ramp, const ValueRange& range) {
    std::vector<Colour> colours(values.size());
    std::transform(values.begin(), values.end(), colours.begin(),
                   [&](T value) { return ramp_colour(ramp, place_in(range, static_cast<double>(value))); });
    return colours;
}

/// Depths take a second surface; whoever has them brings them along.
std::vector<Colour> by_depth(const Mesh& mesh, const Structure& structure, const ValueRange& range) {
    const VertexValues* brought = brought_depths(mesh);
    if (brought == nullptr) return by_value(depths(mesh, ExactSurface(structure.atoms)), cold_ramp(), range);
    check_values(brought->values, mesh, "depth");
    return by_value(brought->values, cold_ramp(), range);
}

/// What is no number lies outside every range; it must not reach the ramp.
Colour curvature_colour(const ValueRange& range, double curvature) {
    return ramp_colour(diverging_ramp(), std::isnan(curvature) ? 0.0 : place_in(range, curvature));
}

std::vector<Colour> by_name(const Mesh& mesh, const ColourOptions& options) {
    const VertexValues& named = values_named(mesh, options.value);
    check_values(named.values, mesh, options.value.c_str());
    const ValueRange range = range_in_force(options, mesh, {});
    const std::span<const Colour> ramp = ramp_of_values(range);
    std::vector<Colour> colours(named.values.size());
    std::transform(named.values.begin(), named.values.end(), colours.begin(), [&](float value) {
        return std::isnan(value) ? kNeutral : ramp_colour(ramp, place_in(range, double{value}));
    });
    return colours;
}

std::vector<Colour> by_pocket(const Mesh& mesh) {
    const VertexValues& ranks = values_named(mesh, kPocketValues);
    check_values(ranks.values, mesh, kPocketValues);
    std::vector<Colour> colours(ranks.values.size());
    std::transform(ranks.values.begin(), ranks.values.end(), colours.begin(), pocket_colour);
    return colours;
}

std::vector<Colour> by_component(const Mesh& mesh) {
    const std::vector<Colour> of_component = component_colours(mesh);
    std::vector<Colour> colours(mesh.vertices.size());
    for (std::size_t v = 0; v < colours.size(); ++v) colours[v] = of_component[mesh.components[v]];
    return colours;
}

template <class ColourOf>
ColourField field_of(const ExactSurface& surface, const ColourOf& colour_of) {
    return [surface, colour_of](std::span<const Vec3> points, std::span<Colour> colours) {
        const std::vector<NearestFeature> nearest = surface.nearest_features(points);
        std::transform(nearest.begin(), nearest.end(), colours.begin(), colour_of);
    };
}

}  // namespace

Colour pocket_colour(float rank) {
    return std::isnan(rank) || rank < 1.0F ? kNeutral : distinct_colour(static_cast<std::size_t>(rank));
}

Colour passage_colour(double radius) {
    constexpr double kDoublings = 4.0;  // from 1 to 16 Å
    constexpr double kLightest = 0.25;  // what is lighter is lost in a clear surface
    const double width = std::min(std::log2(std::max(radius, 1.0)) / kDoublings, 1.0);
    return ramp_colour(passage_ramp(), 1.0 - (1.0 - kLightest) * width);
}

std::vector<Colour> colour_vertices(const Mesh& mesh, const Structure& structure, const ColourOptions& options) {
    check_options(options);
    if (const auto features = feature_colours(structure, options)) return by_feature(mesh, structure, *features);
    if (options.scheme == ColourScheme::Component) return by_component(mesh);
    if (options.scheme == ColourScheme::Value) return by_name(mesh, options);
    if (options.scheme == ColourScheme::Pocket) return by_pocket(mesh);
    const ValueRange range = range_in_force(options, structure);
    if (options.scheme == ColourScheme::Depth) return by_depth(mesh, structure, range);
    check_values(mesh.mean_curvatures, mesh, "mean_curvature");
    return by_value(mesh.mean_curvatures, diverging_ramp(), range);
}

ColourField colour_by_feature(const ExactSurface& surface, const Structure& structure, const ColourOptions& options) {
    check_options(options);
    if (options.scheme == ColourScheme::Curvature)
        return field_of(surface, [range = range_in_force(options, structure)](const NearestFeature& nearest) {
            return curvature_colour(range, nearest.mean_curvature);
        });
    auto features = feature_colours(structure, options);
    if (!features) return {};
    return field_of(surface, [shared = std::make_shared<const FeatureColours>(std::move(*features))](
                                 const NearestFeature& nearest) { return shared->at(nearest.atom, nearest.patch); });
}

ColourField colour_by_level_set(const LevelSet& level_set, const ColourOptions& options) {
    check_options(options);
    if (options.scheme != ColourScheme::Curvature) return {};
    return [&level_set, range = range_in_force(options, {})](std::span<const Vec3> points, std::span<Colour> colours) {
        const std::vector<LevelSetSample> samples = level_set.samples(points);
        std::transform(samples.begin(), samples.end(), colours.begin(),
                       [&](const LevelSetSample& sample) { return curvature_colour(range, sample.mean_curvature()); });
    };
}

}  // namespace meniscus
