// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "colours/further_colours.h"

#include <algorithm>
#include <limits>

#include "colours/palettes.h"

namespace meniscus {
namespace {

/// The difference of two colours in whole numbers, so that every machine makes the same choice: "redmean", a weighted
/// distance in sRGB (T. Riemersma, Colour metric, CompuPhase 2019).
int squared_difference(const Colour& a, const Colour& b) {
    const int mean = (a.red + b.red) / 2;
    const int red = a.red - b.red;
    const int green = a.green - b.green;
    const int blue = a.blue - b.blue;
    return ((512 + mean) * red * red + 1024 * green * green + (767 - mean) * blue * blue) / 256;
}

/// Per mille of white, by the weights of ITU-R BT.601.
int lightness(const Colour& c) { return (299 * c.red + 587 * c.green + 114 * c.blue) / 255; }

/// Every colour of a cube of sRGB that light and shade leave visible.
std::vector<Colour> candidate_colours() {
    constexpr int kStep = 12;
    std::vector<Colour> candidates;
    for (int red = 0; red <= 255; red += kStep)
        for (int green = 0; green <= 255; green += kStep)
            for (int blue = 0; blue <= 255; blue += kStep) {
                const Colour colour{static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green),
                                    static_cast<std::uint8_t>(blue)};
                if (lightness(colour) >= 300 && lightness(colour) <= 880) candidates.push_back(colour);
            }
    return candidates;
}

class FarthestColours {
public:
    explicit FarthestColours(std::span<const Colour> first)
        : candidates_(candidate_colours()), nearest_(candidates_.size(), std::numeric_limits<int>::max()) {
        keep_off(kNeutral);
        for (const Colour& colour : first) keep_off(colour);
    }

    Colour next() {
        const auto farthest = std::max_element(nearest_.begin(), nearest_.end()) - nearest_.begin();
        const Colour colour = candidates_[static_cast<std::size_t>(farthest)];
        keep_off(colour);
        return colour;
    }

private:
    void keep_off(const Colour& colour) {
        for (std::size_t i = 0; i < candidates_.size(); ++i)
            nearest_[i] = std::min(nearest_[i], squared_difference(candidates_[i], colour));
    }

    std::vector<Colour> candidates_;
    std::vector<int> nearest_;  // of each candidate, the squared difference from what is taken
};

std::vector<Colour> row_of_colours(std::span<const Colour> first, std::size_t count) {
    std::vector<Colour> row(first.begin(), first.end());
    FarthestColours others(first);
    while (row.size() < count) row.push_back(others.next());
    return row;
}

}  // namespace

const std::vector<Colour>& further_colours(std::span<const Colour> first, std::size_t count) {
    static const std::vector<Colour> kRow = row_of_colours(first, count);
    return kRow;
}

}  // namespace meniscus
