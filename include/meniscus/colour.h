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

/// The values that get the first and the last colour of a palette; what is beyond them gets the same.
struct ValueRange {
    double min = 0.0;
    double max = 1.0;

    bool operator==(const ValueRange&) const = default;
};

enum class ColourScheme {
    Automatic,       ///< Chain if there are several, else Single
    Single,          ///< one colour
    Patch,           ///< contact, toroidal, reentrant
    Element,         ///< of the nearest atom
    Chain,           ///< of the nearest atom
    Residue,         ///< kind of residue or nucleotide
    ResiduePatch,    ///< contact patches by kind of residue, toroidal and reentrant ones red
    Hydrophobicity,  ///< Kyte & Doolittle 1982, of the residue
    Curvature,       ///< mean curvature, Å^-1
    Component,       ///< outer pieces alike, every cavity its own
    Depth,           ///< below the SES of a probe of kDepthProbe, Å
    BFactor,         ///< of the nearest atom
    Plddt,           ///< the bands of AlphaFold's confidence, which its files keep as B factors
    Value,           ///< those of Mesh::values that ColourOptions::value names
};

}  // namespace meniscus
