// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "colours/further_colours.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "colours/palettes.h"
#include "meniscus/vec3.h"

namespace meniscus {
namespace {

/// In hundredths of DIN99, as below: L* of about 38 and 90.
constexpr int kDarkest = 4950;
constexpr int kLightest = 9350;

/// Where a colour lies in DIN99, in hundredths: whole numbers, so that every machine makes the same choice. Distances
/// are near to those of CIEDE2000 there. source   DIN 6176:2001 on CIELAB (D65); sRGB after IEC 61966-2-1
struct Place {
    int lightness = 0;
    int a = 0;
    int b = 0;
};

double linear_light(std::uint8_t channel) {
    const double value = channel / 255.0;
    return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

double lab_response(double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; }

int hundredths(double value) { return static_cast<int>(std::lround(100.0 * value)); }

Place place_of(const Colour& colour) {
    const Vec3 light{linear_light(colour.red), linear_light(colour.green), linear_light(colour.blue)};
    const double x = lab_response(dot({0.4124564, 0.3575761, 0.1804375}, light) / 0.95047);
    const double y = lab_response(dot({0.2126729, 0.7151522, 0.0721750}, light));
    const double z = lab_response(dot({0.0193339, 0.1191920, 0.9503041}, light) / 1.08883);
    const Vec3 lab{116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
    constexpr double kTurn = 16.0 / 180.0 * std::numbers::pi;
    const double e = std::cos(kTurn) * lab.y + std::sin(kTurn) * lab.z;
    const double f = 0.7 * (std::cos(kTurn) * lab.z - std::sin(kTurn) * lab.y);
    const double chroma = std::hypot(e, f);
    const double scale = chroma > 0.0 ? std::log1p(0.045 * chroma) / (0.045 * chroma) : 0.0;
    return {hundredths(105.51 * std::log1p(0.0158 * lab.x)), hundredths(scale * e), hundredths(scale * f)};
}

int squared_difference(const Place& p, const Place& q) {
    const int lightness = p.lightness - q.lightness;
    const int a = p.a - q.a;
    const int b = p.b - q.b;
    return lightness * lightness + a * a + b * b;
}

struct Candidate {
    Colour colour;
    Place place;
};

/// A cube of sRGB without what light and shade would hide on a white page.
std::vector<Candidate> candidates_for_rows() {
    constexpr int kStep = 12;
    std::vector<Candidate> candidates;
    for (int red = 0; red <= 255; red += kStep)
        for (int green = 0; green <= 255; green += kStep)
            for (int blue = 0; blue <= 255; blue += kStep) {
                const Colour colour{static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green),
                                    static_cast<std::uint8_t>(blue)};
                const Place place = place_of(colour);
                if (place.lightness >= kDarkest && place.lightness <= kLightest) candidates.push_back({colour, place});
            }
    return candidates;
}

class FarthestColours {
public:
    explicit FarthestColours(std::span<const Colour> first)
        : candidates_(candidates_for_rows()), nearest_(candidates_.size(), std::numeric_limits<int>::max()) {
        keep_off(kNeutral);
        for (const Colour& colour : first) keep_off(colour);
    }

    Colour next() {
        const auto farthest = std::max_element(nearest_.begin(), nearest_.end()) - nearest_.begin();
        const Colour colour = candidates_[static_cast<std::size_t>(farthest)].colour;
        keep_off(colour);
        return colour;
    }

private:
    void keep_off(const Colour& colour) {
        const Place place = place_of(colour);
        for (std::size_t i = 0; i < candidates_.size(); ++i)
            nearest_[i] = std::min(nearest_[i], squared_difference(candidates_[i].place, place));
    }

    std::vector<Candidate> candidates_;
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
