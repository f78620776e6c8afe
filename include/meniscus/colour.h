// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A colour, and colours all over space.
#pragma once

#include <cstdint>
#include <functional>

#include "meniscus/vec3.h"

namespace meniscus {

/// An sRGB colour; alpha 255 is opaque. Red, green and blue are not multiplied by alpha.
struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    std::uint8_t alpha = 255;

    bool operator==(const Colour&) const = default;
};

/// The colour of any point of a surface. May be called from several threads at once.
using ColourField = std::function<Colour(const Vec3&)>;

}  // namespace meniscus
