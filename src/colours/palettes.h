// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Palettes: distinct colours for things that have no order, ramps for values. All but the conventional ones (elements,
// pLDDT) are told apart by the colour-blind, as long as there are no more than twelve classes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "meniscus/colour.h"

namespace meniscus {

/// The colour that 0xRRGGBB stands for.
constexpr Colour rgb(std::uint32_t code) {
    return {static_cast<std::uint8_t>(code >> 16U), static_cast<std::uint8_t>(code >> 8U & 0xFFU),
            static_cast<std::uint8_t>(code & 0xFFU)};
}

/// Of a surface that shows nothing but itself, and of what a scheme knows nothing about.
inline constexpr Colour kPlain = rgb(0x77AADD);
inline constexpr Colour kNeutral = rgb(0xCCCCCC);

/// Colours that everybody can tell apart, and all that there are.
inline constexpr std::size_t kDistinctColours = 12;
inline constexpr std::size_t kAllColours = 1024;

/// The n-th of a row of distinct colours, which begins again after kAllColours; the first is kPlain.
///
/// Up to kDistinctColours they are told apart by the colour-blind too; those that follow are each as far as can be from
/// all before it and from kNeutral in normal vision, and come ever closer (docs/design/colours.md).
/// source   P. Tol, Colour Schemes, SRON technical note 2021 ("light", "medium contrast", "vibrant") and one of Okabe &
///          Ito 2008, in an order in which each is as far as can be from those before it, for the colour-blind too
/// cost     the first call beyond kDistinctColours takes some 20 ms
Colour distinct_colour(std::size_t n);

/// Values from 0 to 1, values beyond as the ends; colours between those of the ramp are linear in sRGB.
/// source   ColorBrewer (Harrower & Brewer, Cartogr. J. 40, 2003, 27-37), as are all ramps below
Colour ramp_colour(std::span<const Colour> ramp, double value);

std::span<const Colour> diverging_ramp();   ///< RdBu from blue: curvature
std::span<const Colour> potential_ramp();   ///< the same from red, as electrostatic potentials are shown
std::span<const Colour> hydropathy_ramp();  ///< BrBG from green
std::span<const Colour> warm_ramp();        ///< YlOrBr: B factors
std::span<const Colour> cold_ramp();        ///< YlGnBu: depth
std::span<const Colour> passage_ramp();     ///< RdPu: tunnels

}  // namespace meniscus
