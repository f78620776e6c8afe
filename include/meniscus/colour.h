// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A colour, and colours all over space.
#pragma once

#include <cstdint>
#include <functional>
#include <span>

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

/// Finds the colours of points of a surface: soonest for many that lie next to each other. May be called from several
/// threads at once.
///
/// points   Å, in the frame of the input
/// colours  where the colour of each point goes; as many as points
using ColourField = std::function<void(std::span<const Vec3> points, std::span<Colour> colours)>;

}  // namespace meniscus
