// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "colours/feature_colours.h"

#include <algorithm>
#include <limits>

#include "colours/atom_colours.h"
#include "colours/palettes.h"
#include "meniscus/tables.h"
#include "meniscus/vertex_values.h"

namespace meniscus {
namespace {

constexpr Colour kContact = rgb(0x77AADD);
constexpr Colour kToroidal = rgb(0xEEDD88);
constexpr Colour kReentrant = rgb(0xEE8866);

/// Of all patches that are no contact, as in Pan & Tai 2009, figure 3.
constexpr Colour kNoContact = rgb(0xD7301F);

constexpr ValueRange kCurvatures{-0.7, 0.7};  // Å^-1: an atom of 1.43 Å, a probe's sphere
constexpr ValueRange kDepths{0.0, kDepthProbe};

std::string_view residue_name(const Structure& structure, const AtomLabel& label) {
    return structure.residues.empty() ? std::string_view{} : structure.residues[label.residue].name;
}

template <class ColourOf>
std::vector<Colour> per_label(const Structure& structure, const ColourOf& colour_of) {
    std::vector<Colour> colours(structure.labels.size());
    std::transform(structure.labels.begin(), structure.labels.end(), colours.begin(), colour_of);
    return colours;
}

template <class ColourOf>
std::vector<Colour> per_residue_name(const Structure& structure, const ColourOf& colour_of) {
    return per_label(structure, [&](const AtomLabel& label) { return colour_of(residue_name(structure, label)); });
}

std::vector<Colour> chain_colours(const Structure& structure) {
    const Chains chains = chains_of(structure);
    std::vector<Colour> colours;
    colours.reserve(chains.of_atom.size());
    for (const std::uint32_t chain : chains.of_atom) colours.push_back(distinct_colour(chain));
    return colours;
}

Colour hydropathy_colour(std::string_view residue) {
    const std::optional<double> value = hydropathy(residue);
    return value ? ramp_colour(hydropathy_ramp(), place_in(kHydropathyRange, *value)) : kNeutral;
}

std::vector<Colour> b_factor_colours(const Structure& structure, const ValueRange& range) {
    return per_label(structure,
                     [&](const AtomLabel& label) { return ramp_colour(warm_ramp(), place_in(range, label.b_factor)); });
}

ValueRange b_factor_range(const Structure& structure) {
    const auto& labels = structure.labels;
    if (labels.empty()) return {};
    const auto [low, high] = std::minmax_element(
        labels.begin(), labels.end(), [](const AtomLabel& a, const AtomLabel& b) { return a.b_factor < b.b_factor; });
    return {low->b_factor, high->b_factor};
}

}  // namespace

ColourScheme scheme_in_force(ColourScheme scheme, const Structure& structure) {
    if (scheme != ColourScheme::Automatic) return scheme;
    return chains_of(structure).names.size() > 1 ? ColourScheme::Chain : ColourScheme::Single;
}

bool takes_range(ColourScheme scheme) {
    return scheme == ColourScheme::Curvature || scheme == ColourScheme::Depth || scheme == ColourScheme::BFactor ||
           scheme == ColourScheme::Value;
}

ValueRange default_range(ColourScheme scheme, const Structure& structure) {
    if (scheme == ColourScheme::Curvature) return kCurvatures;
    if (scheme == ColourScheme::Depth) return kDepths;
    return scheme == ColourScheme::BFactor ? b_factor_range(structure) : ValueRange{};
}

ValueRange range_in_force(const ColourOptions& options, const Structure& structure) {
    return options.range ? *options.range : default_range(options.scheme, structure);
}

ValueRange range_in_force(const ColourOptions& options, const Mesh& mesh, const Structure& structure) {
    const bool by_mesh = options.scheme == ColourScheme::Value && !options.range;
    return by_mesh ? range_of(values_named(mesh, options.value)) : range_in_force(options, structure);
}

std::span<const Colour> ramp_of_values(const ValueRange& range) {
    return range.min < 0.0 && range.max > 0.0 ? potential_ramp() : cold_ramp();
}

/// Where all values are alike, so are the colours: the first of the ramp.
double place_in(const ValueRange& range, double value) {
    return range.max > range.min ? (value - range.min) / (range.max - range.min) : 0.0;
}

std::optional<FeatureColours> feature_colours(const Structure& structure, const ColourOptions& options) {
    switch (scheme_in_force(options.scheme, structure)) {
        case ColourScheme::Single:
            return FeatureColours{.of_atom =
                                      std::vector<Colour>(structure.atoms.size(), options.colour.value_or(kPlain))};
        case ColourScheme::Patch:
            return FeatureColours{.of_atom = std::vector<Colour>(structure.atoms.size(), kContact),
                                  .of_patch = {kContact, kToroidal, kReentrant}};
        case ColourScheme::Element:
            return FeatureColours{per_label(structure, [](const AtomLabel& l) { return element_colour(l.element); })};
        case ColourScheme::Chain:
            return FeatureColours{chain_colours(structure)};
        case ColourScheme::Residue:
            return FeatureColours{per_residue_name(structure, residue_colour)};
        case ColourScheme::ResiduePatch:
            return FeatureColours{.of_atom = per_residue_name(structure, residue_colour),
                                  .of_patch = {std::nullopt, kNoContact, kNoContact}};
        case ColourScheme::Hydrophobicity:
            return FeatureColours{per_residue_name(structure, hydropathy_colour)};
        case ColourScheme::BFactor:
            return FeatureColours{b_factor_colours(structure, range_in_force(options, structure))};
        case ColourScheme::Plddt:
            return FeatureColours{
                per_label(structure, [](const AtomLabel& l) { return plddt_band(l.b_factor).colour; })};
        default:
            return std::nullopt;
    }
}

}  // namespace meniscus
