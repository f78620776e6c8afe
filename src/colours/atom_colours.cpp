// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "colours/atom_colours.h"

#include <algorithm>
#include <array>
#include <string>

#include "colours/palettes.h"
#include "radii/aliases.h"
#include "tables/hydropathy.h"

namespace meniscus {
namespace {

template <class T>
struct Entry {
    std::string_view name;
    T value;
};

constexpr auto kElements = std::to_array<Entry<Colour>>({
    {"H", rgb(0xFFFFFF)},  {"D", rgb(0xFFFFFF)},  {"C", rgb(0xC8C8C8)},  {"N", rgb(0x8F8FFF)},  {"O", rgb(0xF00000)},
    {"S", rgb(0xFFC832)},  {"P", rgb(0xFFA500)},  {"F", rgb(0xDAA520)},  {"SI", rgb(0xDAA520)}, {"AU", rgb(0xDAA520)},
    {"CL", rgb(0x00FF00)}, {"B", rgb(0x00FF00)},  {"NA", rgb(0x0000FF)}, {"MG", rgb(0x228B22)}, {"BR", rgb(0xA52A2A)},
    {"ZN", rgb(0xA52A2A)}, {"CU", rgb(0xA52A2A)}, {"NI", rgb(0xA52A2A)}, {"FE", rgb(0xFFA500)}, {"BA", rgb(0xFFA500)},
    {"CA", rgb(0x808090)}, {"MN", rgb(0x808090)}, {"AL", rgb(0x808090)}, {"TI", rgb(0x808090)}, {"CR", rgb(0x808090)},
    {"AG", rgb(0x808090)}, {"I", rgb(0xA020F0)},  {"LI", rgb(0xB22222)}, {"HE", rgb(0xFFC0CB)},
});

constexpr auto kResidues = std::to_array<Entry<Colour>>({
    {"ALA", rgb(0x7FBC8B)}, {"CYS", rgb(0x05D560)}, {"ASP", rgb(0xC4853A)}, {"GLU", rgb(0xB18953)},
    {"PHE", rgb(0x0ACBF4)}, {"GLY", rgb(0xDCABBB)}, {"HIS", rgb(0xCCAADF)}, {"ILE", rgb(0x08CAB9)},
    {"LYS", rgb(0xD0B57A)}, {"LEU", rgb(0x0FCFC6)}, {"MET", rgb(0x05A396)}, {"ASN", rgb(0xE8AA86)},
    {"PRO", rgb(0x96C756)}, {"GLN", rgb(0xA58C6A)}, {"ARG", rgb(0xAF8687)}, {"SER", rgb(0x93A37D)},
    {"THR", rgb(0x669E5F)}, {"VAL", rgb(0x26CDAD)}, {"TRP", rgb(0x1696FF)}, {"TYR", rgb(0x6FBFF9)},
    {"A", rgb(0xEE6677)},   {"C", rgb(0xCCBB44)},   {"G", rgb(0x228833)},   {"T", rgb(0x4477AA)},
    {"U", rgb(0x66CCEE)},
});

constexpr std::array kPlddtBands{
    PlddtBand{90.0, "above 90, very high", rgb(0x0053D6)},
    PlddtBand{70.0, "70 to 90, confident", rgb(0x65CBF3)},
    PlddtBand{50.0, "50 to 70, low", rgb(0xFFDB13)},
    PlddtBand{0.0, "below 50, very low", rgb(0xFF7D45)},
};

template <class Table>
auto find_value(const Table& table, std::string_view name) {
    const auto found = std::find_if(table.begin(), table.end(), [&](const auto& entry) { return entry.name == name; });
    return found == table.end() ? std::nullopt : std::optional(found->value);
}

/// One name for a kind of residue: DA and ADE are A, HIE is HIS, selenomethionine MET.
std::string kind_of_residue(std::string_view residue) {
    const std::string name = canonical_names(residue, "CA").residue;
    if (name == "MSE") return "MET";
    if (name == "SEC") return "CYS";
    return name.size() == 2 && name.front() == 'D' ? name.substr(1) : name;
}

}  // namespace

Colour element_colour(std::string_view element) { return find_value(kElements, element).value_or(kNeutral); }

Colour residue_colour(std::string_view residue) {
    return find_value(kResidues, kind_of_residue(residue)).value_or(kNeutral);
}

std::string_view residue_kind(std::string_view residue) {
    const std::string kind = kind_of_residue(residue);
    const auto found =
        std::find_if(kResidues.begin(), kResidues.end(), [&](const auto& entry) { return entry.name == kind; });
    return found == kResidues.end() ? std::string_view{} : found->name;
}

std::optional<double> hydropathy(std::string_view residue) { return hydropathy_of(kind_of_residue(residue)); }

const PlddtBand& plddt_band(double plddt) {
    return *std::find_if(kPlddtBands.begin(), kPlddtBands.end() - 1,
                         [plddt](const PlddtBand& band) { return plddt > band.above; });
}

}  // namespace meniscus
