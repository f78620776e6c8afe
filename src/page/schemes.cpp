// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "page/schemes.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "colours/component_colours.h"
#include "colours/feature_colours.h"
#include "colours/palettes.h"
#include "meniscus/tables.h"
#include "meniscus/vertex_values.h"

namespace meniscus::page {

using nlohmann::ordered_json;

namespace {

/// In the order in which they are offered.
struct Scheme {
    const char* id;
    const char* label;
    ColourScheme scheme;
};
constexpr std::array kAll{
    Scheme{"single", "One colour", ColourScheme::Single},
    Scheme{"chain", "Chain", ColourScheme::Chain},
    Scheme{"patch", "Patch type", ColourScheme::Patch},
    Scheme{"residue", "Residue type", ColourScheme::Residue},
    Scheme{"residue-patch", "Residue type, contact only", ColourScheme::ResiduePatch},
    Scheme{"hydrophobicity", "Hydrophobicity", ColourScheme::Hydrophobicity},
    Scheme{"element", "Element", ColourScheme::Element},
    Scheme{"curvature", "Mean curvature", ColourScheme::Curvature},
    Scheme{"depth", "Depth", ColourScheme::Depth},
    Scheme{"component", "Outer surface and cavities", ColourScheme::Component},
    Scheme{"pocket", "Pockets", ColourScheme::Pocket},
    Scheme{"bfactor", "B factor", ColourScheme::BFactor},
    Scheme{"plddt", "Confidence (pLDDT)", ColourScheme::Plddt},
};

/// Whether a scheme of atoms tells any two apart.
bool tells_apart(const Structure& structure, ColourScheme scheme) {
    const auto features = feature_colours(structure, {scheme});
    const std::vector<Colour>& colours = features->of_atom;
    return std::any_of(colours.begin(), colours.end(), [&](const Colour& c) { return c != colours.front(); });
}

/// B factors that look like a confidence: from 0 to 100, one per residue, not all the same.
bool looks_like_confidence(const Structure& structure) {
    bool alike = true;
    for (std::size_t i = 0; i < structure.labels.size(); ++i) {
        const AtomLabel& label = structure.labels[i];
        if (!(label.b_factor >= 0.0 && label.b_factor <= 100.0)) return false;
        if (i == 0) continue;
        const AtomLabel& before = structure.labels[i - 1];
        const bool same = label.b_factor == before.b_factor;
        if (label.residue == before.residue && !same) return false;
        alike = alike && same;
    }
    return !alike && structure.residues.size() < structure.labels.size();
}

bool shows_something(ColourScheme scheme, const Mesh& mesh, const Structure& structure) {
    switch (scheme) {
        case ColourScheme::Curvature:
            return mesh.mean_curvatures.size() == mesh.vertices.size();
        case ColourScheme::Component:
            return std::any_of(mesh.components.begin(), mesh.components.end(), [](std::uint32_t c) { return c > 0; });
        case ColourScheme::Pocket:
            return std::any_of(mesh.values.begin(), mesh.values.end(),
                               [](const VertexValues& values) { return values.name == kPocketValues; });
        case ColourScheme::Plddt:
            return looks_like_confidence(structure);
        case ColourScheme::Single:
        case ColourScheme::Patch:
        case ColourScheme::Depth:
            return true;
        case ColourScheme::ResiduePatch:
            return tells_apart(structure, ColourScheme::Residue);
        default:
            return tells_apart(structure, scheme);
    }
}

/// B factors come with values of the scheme's own name, which is offered already.
bool is_scheme(const std::string& name) {
    return std::any_of(kAll.begin(), kAll.end(), [&](const Scheme& scheme) { return name == scheme.id; });
}

std::string planes(const std::vector<Colour>& colours) {
    std::string bytes;
    bytes.reserve(3 * colours.size());
    for (const auto channel : {&Colour::red, &Colour::green, &Colour::blue})
        for (const Colour& colour : colours) bytes.push_back(static_cast<char>(colour.*channel));
    return bytes;
}

ordered_json hex_list(std::span<const Colour> colours) {
    ordered_json list = ordered_json::array();
    for (const Colour& colour : colours) list.push_back(hex(colour));
    return list;
}

ordered_json legend_json(const Legend& legend) {
    ordered_json entries = ordered_json::array();
    for (const LegendEntry& entry : legend.entries) entries.push_back({entry.label, hex(entry.colour)});
    return {{"title", legend.title},
            {"entries", entries},
            {"ramp", hex_list(legend.ramp)},
            {"min", legend.range.min},
            {"max", legend.range.max}};
}

ordered_json describe_features(const OfferedScheme& scheme, const FeatureColours& features, Streams& streams) {
    const std::string stream = std::string("colours-") + scheme.id;
    streams.add(stream, planes(features.of_atom));
    ordered_json patches = ordered_json::array();
    for (const auto& colour : features.of_patch)
        patches.push_back(colour ? ordered_json(hex(*colour)) : ordered_json());
    return {{"kind", "atom"}, {"stream", stream}, {"patches", patches}};
}

}  // namespace

std::string hex(const Colour& colour) {
    std::string text = "#";
    for (const unsigned channel : {colour.red, colour.green, colour.blue}) {
        text += "0123456789abcdef"[channel >> 4U];
        text += "0123456789abcdef"[channel & 15U];
    }
    return text;
}

std::vector<OfferedScheme> offered_schemes(const Mesh& mesh, const Structure& structure, const ColourOptions& first) {
    const ColourScheme shown = scheme_in_force(first.scheme, structure);
    std::vector<OfferedScheme> offered;
    for (const Scheme& scheme : kAll) {
        const bool asked_for = scheme.scheme == shown;
        if (!asked_for && !shows_something(scheme.scheme, mesh, structure)) continue;
        offered.push_back({scheme.id, scheme.label, {.scheme = scheme.scheme}});
        if (!asked_for) continue;
        offered.back().options.range = first.range;
        offered.back().options.colour = first.colour;
    }
    for (const VertexValues& values : mesh.values) {
        if (is_scheme(values.name)) continue;
        offered.push_back({values.name, values.name, {.scheme = ColourScheme::Value, .value = values.name}});
        if (first.value == values.name) offered.back().options.range = first.range;
    }
    return offered;
}

ordered_json describe(const OfferedScheme& scheme, const Mesh& mesh, const Structure& structure, Streams& streams) {
    ordered_json block{{"id", scheme.id}, {"label", scheme.label}};
    const Legend legend = make_legend(mesh, structure, scheme.options);
    block["legend"] = legend_json(legend);
    if (const auto features = feature_colours(structure, scheme.options)) {
        block.update(describe_features(scheme, *features, streams));
    } else if (scheme.options.scheme == ColourScheme::Component) {
        block["kind"] = "component";
        block["colours"] = hex_list(component_colours(mesh));
    } else if (scheme.options.scheme == ColourScheme::Pocket) {
        block["kind"] = "class";
        block["values"] = scheme.id;
        block["colours"] = ordered_json::object();
        for (const float rank : values_named(mesh, kPocketValues).values)
            if (!std::isnan(rank)) block["colours"][std::to_string(std::lround(rank))] = hex(pocket_colour(rank));
        block["none"] = hex(kNeutral);
    } else {
        block["kind"] = "value";
        block["values"] = scheme.id;
        block["ramp"] = hex_list(legend.ramp);
        block["range"] = {legend.range.min, legend.range.max};
    }
    return block;
}

}  // namespace meniscus::page
