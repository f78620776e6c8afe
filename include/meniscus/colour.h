// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Colours, fields of colours, and the schemes that colour a surface.
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

/// A function that finds the colours of points of a surface, fastest for many points close together. May be called by
/// several threads at once.
///
/// points   Å, in the frame of the input
/// colours  receives the colour of each point; has the same size
using ColourField = std::function<void(std::span<const Vec3> points, std::span<Colour> colours)>;

/// The values that get the first and the last colour of a palette; values beyond get the nearer of the two colours.
struct ValueRange {
    double min = 0.0;
    double max = 1.0;

    bool operator==(const ValueRange&) const = default;
};

/// What the colours of a surface show.
enum class ColourScheme {
    Automatic,       ///< Chain if there are several chains, else Single
    Single,          ///< one colour
    Patch,           ///< kind of patch: contact, toroidal, reentrant
    Element,         ///< element of the nearest atom
    Chain,           ///< chain of the nearest atom
    Residue,         ///< kind of the nearest residue or nucleotide
    ResiduePatch,    ///< contact patches by kind of residue, toroidal and reentrant ones red
    Hydrophobicity,  ///< hydrophobicity of the nearest residue, Kyte & Doolittle 1982
    Curvature,       ///< mean curvature, Å^-1
    Component,       ///< one colour for outer pieces, another for every cavity
    Depth,           ///< depth below the SES of a probe of kDepthProbe, Å
    BFactor,         ///< B factor of the nearest atom
    Pocket,          ///< the pocket whose wall it is, by the values kPocketValues of the mesh
    Plddt,           ///< bands of AlphaFold's confidence, which its files hold as B factors
    Value,           ///< the array of Mesh::values that ColourOptions::value names
};

}  // namespace meniscus
