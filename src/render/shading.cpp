// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/shading.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/srgb.h"

namespace meniscus {
namespace {

/// Directions to the lamps in the viewer's frame: right, up, towards.
constexpr Vec3 kKey{-0.45, 0.55, 0.70};
constexpr Vec3 kFill{0.60, -0.10, 0.80};

// Shares of the light. Sky and lamps together leave a white surface that faces the viewer just below white.
constexpr double kSkyShare = 0.58;
constexpr double kKeyShare = 0.50;
constexpr double kFillShare = 0.10;

/// The sky below is darker than that above by this share.
constexpr double kSkyGradient = 0.30;

/// Hollows are darker than the open share of their sky alone would make them, which brings out their depth.
constexpr double kSkyExponent = 1.5;

/// Where the surface turns away from the viewer it is darker by up to this share: light colours stand out from white.
constexpr double kRimShade = 0.30;

/// Hollows are lit less by the lamps too: they would lie in the soft shadow of what surrounds them.
constexpr double kLampShadow = 0.70;

// A wide, weak highlight: anything more looks like plastic.
constexpr double kGloss = 0.02;
constexpr double kGlossExponent = 24.0;

float single(double value) { return static_cast<float>(value); }

std::array<float, 256> decoding_table() {
    std::array<float, 256> table;
    for (std::size_t i = 0; i < table.size(); ++i) table[i] = single(linear_from_srgb(static_cast<double>(i) / 255.0));
    return table;
}

std::uint8_t to_byte(double share) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

Vec3 in_frame(const ViewFrame& frame, const Vec3& v) {
    return normalised(v.x * frame.right + v.y * frame.up + v.z * frame.towards);
}

/// Blinn & Phong's highlight of one lamp.
double gloss(const Vec3& normal, const Vec3& lamp, const Vec3& to_viewer) {
    return std::pow(std::max(0.0, dot(normal, normalised(lamp + to_viewer))), kGlossExponent);
}

}  // namespace

Light to_light(const Colour& colour) {
    static const std::array<float, 256> table = decoding_table();
    return {table[colour.red], table[colour.green], table[colour.blue]};
}

Colour to_colour(const Light& light, float opacity) {
    const auto byte = [](float l) { return to_byte(srgb_from_linear(std::clamp(static_cast<double>(l), 0.0, 1.0))); };
    return {byte(light.red), byte(light.green), byte(light.blue), to_byte(opacity)};
}

Lamps::Lamps(const ViewFrame& frame) : up_(frame.up), key_(in_frame(frame, kKey)), fill_(in_frame(frame, kFill)) {}

Light Lamps::shade(const Light& albedo, const Vec3& normal, const Vec3& to_viewer, float sky) const {
    const double from_sky =
        kSkyShare * std::pow(sky, kSkyExponent) * (1.0 - 0.5 * kSkyGradient * (1.0 - dot(normal, up_)));
    const double reached = 1.0 - kLampShadow * (1.0 - sky);
    const double key = kKeyShare * std::max(0.0, dot(normal, key_));
    const double fill = kFillShare * std::max(0.0, dot(normal, fill_));
    const double rim = 1.0 - kRimShade * std::pow(1.0 - std::clamp(dot(normal, to_viewer), 0.0, 1.0), 3.0);
    const double diffuse = rim * (from_sky + reached * (key + fill));
    const double highlight = kGloss * reached * gloss(normal, key_, to_viewer);
    const float white = single(highlight);
    return single(diffuse) * albedo + Light{white, white, white};
}

}  // namespace meniscus
