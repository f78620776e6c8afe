// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/legend.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>
#include <set>
#include <string_view>
#include <utility>

#include "colours/atom_colours.h"
#include "colours/checks.h"
#include "colours/component_colours.h"
#include "colours/feature_colours.h"
#include "colours/palettes.h"
#include "meniscus/tables.h"
#include "meniscus/vertex_values.h"

namespace meniscus {
namespace {

/// What a class sorts by: a rank, then its name.
using ClassName = std::pair<int, std::string>;

constexpr std::array<const char*, 3> kPatchNames{"contact", "toroidal", "reentrant"};
constexpr std::string_view kCommonElements = "CNOSPH";
constexpr const char* kOther = "other";

ClassName element_class(const std::string& element) {
    if (element.empty()) return {2, kOther};
    std::string name = element;
    std::transform(name.begin() + 1, name.end(), name.begin() + 1,
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    const std::size_t place = name.size() == 1 ? kCommonElements.find(name) : std::string_view::npos;
    return place == std::string_view::npos ? ClassName{1, name} : ClassName{static_cast<int>(place) - 6, name};
}

ClassName residue_class(const Structure& structure, std::uint32_t atom) {
    const std::string_view kind =
        structure.residues.empty() ? "" : residue_kind(structure.residues[structure.labels[atom].residue].name);
    if (kind.empty()) return {2, kOther};
    return {kind.size() == 1 ? 1 : 0, std::string(kind)};  // nucleotides after amino acids
}

ClassName plddt_class(double plddt) {
    const PlddtBand& band = plddt_band(plddt);
    return {static_cast<int>(-band.above), band.name};
}

/// The classes of (atom, patch) in a scheme; every class has one colour.
class Classes {
public:
    Classes(const Structure& structure, ColourScheme scheme)
        : structure_(structure), scheme_(scheme), chains_(chains_of(structure)) {}

    ClassName operator()(std::uint32_t atom, PatchKind patch) const {
        switch (scheme_) {
            case ColourScheme::Patch:
                return {static_cast<int>(patch), kPatchNames[static_cast<std::size_t>(patch)]};
            case ColourScheme::Element:
                return element_class(structure_.labels[atom].element);
            case ColourScheme::Chain:
                return chain_class(chains_.of_atom[atom]);
            case ColourScheme::ResiduePatch:
                if (patch != PatchKind::Contact) return {3, "toroidal, reentrant"};
                return residue_class(structure_, atom);
            case ColourScheme::Plddt:
                return plddt_class(structure_.labels[atom].b_factor);
            default:
                return residue_class(structure_, atom);
        }
    }

private:
    ClassName chain_class(std::uint32_t chain) const {
        const std::string& name = chains_.names[chain];
        return {static_cast<int>(chain), name.empty() ? "-" : name};
    }

    const Structure& structure_;
    ColourScheme scheme_;
    Chains chains_;
};

/// True at 3 * atom + patch for every pair that a vertex has.
std::vector<bool> features_that_occur(const Mesh& mesh, const Structure& structure) {
    check_atoms(mesh, structure);
    check_values(mesh.patches, mesh, "patch");
    std::vector<bool> occurs(3 * structure.labels.size());
    for (std::size_t v = 0; v < mesh.atoms.size(); ++v)
        occurs[3 * std::size_t{mesh.atoms[v]} + static_cast<std::size_t>(mesh.patches[v])] = true;
    return occurs;
}

std::vector<LegendEntry> entries_of_features(const Mesh& mesh, const Structure& structure,
                                             const FeatureColours& colours, ColourScheme scheme) {
    const Classes class_of(structure, scheme);
    const std::vector<bool> occurs = features_that_occur(mesh, structure);
    std::map<ClassName, Colour> found;
    for (std::size_t i = 0; i < occurs.size(); ++i) {
        if (!occurs[i]) continue;
        const auto atom = static_cast<std::uint32_t>(i / 3);
        const auto patch = static_cast<PatchKind>(i % 3);
        found.emplace(class_of(atom, patch), colours.at(atom, patch));
    }
    std::vector<LegendEntry> entries;
    entries.reserve(found.size());
    for (const auto& [name, colour] : found) entries.push_back({name.second, colour});
    return entries;
}

std::vector<LegendEntry> entries_of_components(const Mesh& mesh) {
    std::vector<LegendEntry> entries;
    std::size_t cavities = 0;
    bool outer = false;
    for (const Colour& colour : component_colours(mesh)) {
        if (colour != kPlain)
            entries.push_back({"cavity " + std::to_string(++cavities), colour});
        else if (!std::exchange(outer, true))
            entries.insert(entries.begin(), {"outer", colour});
    }
    return entries;
}

std::vector<LegendEntry> entries_of_pockets(const Mesh& mesh) {
    std::set<float> ranks;
    bool without = false;
    for (const float rank : values_named(mesh, kPocketValues).values)
        if (std::isnan(rank))
            without = true;
        else
            ranks.insert(rank);
    std::vector<LegendEntry> entries;
    entries.reserve(ranks.size() + 1);
    for (const float rank : ranks)
        entries.push_back({"pocket " + std::to_string(std::lround(rank)), pocket_colour(rank)});
    if (without) entries.push_back({"no pocket", kNeutral});
    return entries;
}

/// Where residues have no hydropathy, their colour stands beside the ramp.
std::vector<LegendEntry> entries_beside_hydropathy(const Mesh& mesh, const Structure& structure) {
    check_atoms(mesh, structure);
    std::vector<bool> has_value(structure.residues.size());
    std::transform(structure.residues.begin(), structure.residues.end(), has_value.begin(),
                   [](const Residue& residue) { return hydropathy(residue.name).has_value(); });
    const bool without = std::any_of(mesh.atoms.begin(), mesh.atoms.end(), [&](std::uint32_t atom) {
        return has_value.empty() || !has_value[structure.labels[atom].residue];
    });
    return without ? std::vector<LegendEntry>{{kOther, kNeutral}} : std::vector<LegendEntry>{};
}

Legend of_ramp(std::string title, std::span<const Colour> ramp, const ValueRange& range) {
    return {.title = std::move(title), .ramp = {ramp.begin(), ramp.end()}, .range = range};
}

Legend of_values(const Mesh& mesh, const ColourOptions& options, const ValueRange& range) {
    Legend legend = of_ramp(options.value, ramp_of_values(range), range);
    const std::vector<float>& values = values_named(mesh, options.value).values;
    if (std::any_of(values.begin(), values.end(), [](float value) { return std::isnan(value); }))
        legend.entries.push_back({"no value", kNeutral});
    return legend;
}

const char* title_of_classes(ColourScheme scheme) {
    switch (scheme) {
        case ColourScheme::Patch:
            return "Patch";
        case ColourScheme::Element:
            return "Element";
        case ColourScheme::Chain:
            return "Chain";
        case ColourScheme::Plddt:
            return "pLDDT";
        default:
            return "Residue";
    }
}

}  // namespace

Legend make_legend(const Mesh& mesh, const Structure& structure, const ColourOptions& options) {
    check_options(options);
    const ColourScheme scheme = scheme_in_force(options.scheme, structure);
    const ValueRange range = range_in_force(options, mesh, structure);
    switch (scheme) {
        case ColourScheme::Single:
            return {};
        case ColourScheme::Component:
            return {.title = "Component", .entries = entries_of_components(mesh)};
        case ColourScheme::Pocket:
            return {.title = "Pockets", .entries = entries_of_pockets(mesh)};
        case ColourScheme::Hydrophobicity: {
            Legend legend = of_ramp("Hydropathy (Kyte & Doolittle)", hydropathy_ramp(), kHydropathyRange);
            legend.entries = entries_beside_hydropathy(mesh, structure);
            return legend;
        }
        case ColourScheme::Curvature:
            return of_ramp("Mean curvature, 1/Å", diverging_ramp(), range);
        case ColourScheme::Depth:
            return of_ramp("Depth, Å", cold_ramp(), range);
        case ColourScheme::BFactor:
            return of_ramp("B factor, Å²", warm_ramp(), range);
        case ColourScheme::Value:
            return of_values(mesh, options, range);
        default:
            return {.title = title_of_classes(scheme),
                    .entries = entries_of_features(mesh, structure, *feature_colours(structure, options), scheme)};
    }
}

}  // namespace meniscus
