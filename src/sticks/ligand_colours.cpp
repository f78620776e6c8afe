// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <string_view>

#include "colours/atom_colours.h"
#include "colours/palettes.h"
#include "meniscus/ligand_bodies.h"

namespace meniscus {
namespace {

/// Of carbon: green, orchid, amber, slate. None is the colour of another element that is common in ligands.
constexpr std::array kCarbons{rgb(0x35B54A), rgb(0xC2569B), rgb(0xD99A1C), rgb(0x4D5561)};

/// From all colours of the surface, on a scale on which black and white are 441 apart.
constexpr int kFar = 90;

struct ElementColour {
    std::string_view element;
    Colour colour;
};

/// Jmol's, with fluorine less green than carbon may be. source   jmol.sourceforge.net/jscolors
constexpr auto kElements = std::to_array<ElementColour>({
    {"H", rgb(0xFFFFFF)},  {"D", rgb(0xFFFFFF)},  {"N", rgb(0x3050F8)},  {"O", rgb(0xFF0D0D)},  {"F", rgb(0x8CE6E6)},
    {"P", rgb(0xFF8000)},  {"S", rgb(0xFFE030)},  {"CL", rgb(0x1FF01F)}, {"BR", rgb(0xA62929)}, {"I", rgb(0x940094)},
    {"B", rgb(0xFFB5B5)},  {"SE", rgb(0xFFA100)}, {"FE", rgb(0xE06633)}, {"ZN", rgb(0x7D80B0)}, {"MG", rgb(0x8AFF00)},
    {"CO", rgb(0xF090A0)}, {"NI", rgb(0x50D050)}, {"CU", rgb(0xC88033)}, {"MN", rgb(0x9C7AC7)}, {"MO", rgb(0x54B5B5)},
});

int squared_distance(const Colour& a, const Colour& b) {
    const int red = a.red - b.red;
    const int green = a.green - b.green;
    const int blue = a.blue - b.blue;
    return red * red + green * green + blue * blue;
}

Colour carbon_beside(std::span<const Colour> surface) {
    std::array<int, kCarbons.size()> nearest;
    nearest.fill(3 * 256 * 256);
    const Colour* before = nullptr;
    for (const Colour& colour : surface) {
        if (before != nullptr && *before == colour) continue;  // as nearly all of them
        before = &colour;
        for (std::size_t i = 0; i < kCarbons.size(); ++i)
            nearest[i] = std::min(nearest[i], squared_distance(kCarbons[i], colour));
    }
    auto chosen = std::find_if(nearest.begin(), nearest.end(), [](int squared) { return squared >= kFar * kFar; });
    if (chosen == nearest.end()) chosen = std::max_element(nearest.begin(), nearest.end());
    return kCarbons[static_cast<std::size_t>(chosen - nearest.begin())];
}

Colour colour_of(std::string_view element) {
    const auto found = std::find_if(kElements.begin(), kElements.end(),
                                    [&](const ElementColour& entry) { return entry.element == element; });
    return found == kElements.end() ? element_colour(element) : found->colour;
}

}  // namespace

std::vector<Colour> ligand_colours(const Ligands& ligands, std::span<const Colour> surface) {
    const Colour carbon = carbon_beside(surface);
    std::vector<Colour> colours;
    colours.reserve(ligands.labels.size());
    for (const AtomLabel& label : ligands.labels)
        colours.push_back(label.element == "C" ? carbon : colour_of(label.element));
    return colours;
}

}  // namespace meniscus
