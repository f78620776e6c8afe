// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/shading.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

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

/// Where the surface turns away from the viewer it is darker by up to this share: light colours stand out from white.
constexpr double kRimShade = 0.30;

/// Hollows are lit less by the lamps too: they would lie in the soft shadow of what surrounds them.
constexpr double kLampShadow = 0.70;

// A wide, weak highlight: anything more looks like plastic.
constexpr double kGloss = 0.02;

float rounded_to_float(double value) { return static_cast<float>(value); }

std::array<float, 256> decoding_table() {
    std::array<float, 256> table;
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = rounded_to_float(linear_from_srgb(static_cast<double>(i) / 255.0));
    return table;
}

std::uint8_t to_byte(double share) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

std::uint8_t encoded(float light) {
    return to_byte(srgb_from_linear(std::clamp(static_cast<double>(light), 0.0, 1.0)));
}

/// encoded() by looking up: what begins where, and what lies at the beginning of each stretch of light.
class Encoder {
public:
    Encoder() {
        for (std::size_t byte = 1; byte < begins_.size(); ++byte) begins_[byte] = least_that_gives(byte);
        for (std::size_t i = 0; i < first_.size(); ++i) first_[i] = encoded(static_cast<float>(i) / kStretches);
    }

    std::uint8_t operator()(float light) const {
        const float clamped = light > 0.0F ? std::min(light, 1.0F) : 0.0F;  // what is no number is dark
        std::size_t byte = first_[static_cast<std::size_t>(clamped * kStretches)];
        while (byte + 1 < begins_.size() && clamped >= begins_[byte + 1]) ++byte;
        return static_cast<std::uint8_t>(byte);
    }

private:
    static constexpr int kStretches = 1024;

    static float least_that_gives(std::size_t byte) {
        auto low = std::bit_cast<std::uint32_t>(0.0F);
        auto high = std::bit_cast<std::uint32_t>(1.0F);  // numbers from 0 to 1 are in the order of their bits
        while (low < high) {
            const std::uint32_t middle = low + (high - low) / 2;
            if (encoded(std::bit_cast<float>(middle)) < byte)
                low = middle + 1;
            else
                high = middle;
        }
        return std::bit_cast<float>(high);
    }

    std::array<float, 256> begins_{};
    std::array<std::uint8_t, kStretches + 1> first_{};
};

Vec3 in_frame(const ViewFrame& frame, const Vec3& v) {
    return normalised(v.x * frame.right + v.y * frame.up + v.z * frame.towards);
}

/// Hollows are darker than the open share of their sky alone would make them, which brings out their depth.
double deepened(double sky) { return sky * std::sqrt(sky); }

double cube(double x) { return x * x * x; }

/// Blinn & Phong's highlight of one lamp, with an exponent of 24.
double gloss(const Vec3& normal, const Vec3& lamp, const Vec3& to_viewer) {
    const double to_3 = cube(std::max(0.0, dot(normal, normalised(lamp + to_viewer))));
    const double to_6 = to_3 * to_3;
    const double to_12 = to_6 * to_6;
    return to_12 * to_12;
}

}  // namespace

Light to_light(const Colour& colour) {
    static const std::array<float, 256> table = decoding_table();
    return {table[colour.red], table[colour.green], table[colour.blue]};
}

Colour to_colour(const Light& light, float opacity) {
    static const Encoder encode;
    return {encode(light.red), encode(light.green), encode(light.blue), to_byte(opacity)};
}

Lamps::Lamps(const ViewFrame& frame) : up_(frame.up), key_(in_frame(frame, kKey)), fill_(in_frame(frame, kFill)) {}

Light Lamps::shade(const Light& albedo, const Vec3& normal, const Vec3& to_viewer, float sky) const {
    const double from_sky = kSkyShare * deepened(sky) * (1.0 - 0.5 * kSkyGradient * (1.0 - dot(normal, up_)));
    const double reached = 1.0 - kLampShadow * (1.0 - sky);
    const double key = kKeyShare * std::max(0.0, dot(normal, key_));
    const double fill = kFillShare * std::max(0.0, dot(normal, fill_));
    const double rim = 1.0 - kRimShade * cube(1.0 - std::clamp(dot(normal, to_viewer), 0.0, 1.0));
    const double diffuse = rim * (from_sky + reached * (key + fill));
    const double highlight = kGloss * reached * gloss(normal, key_, to_viewer);
    const float white = rounded_to_float(highlight);
    return rounded_to_float(diffuse) * albedo + Light{white, white, white};
}

}  // namespace meniscus
