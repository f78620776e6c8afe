// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The schemes whose colours come from the kind of patch and the nearest atom.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "meniscus/colours.h"

namespace meniscus {

/// Of ColourScheme::Hydrophobicity: from arginine to isoleucine.
inline constexpr ValueRange kHydropathyRange{-4.5, 4.5};

struct FeatureColours {
    std::vector<Colour> of_atom{};                    ///< in the structure's order
    std::array<std::optional<Colour>, 3> of_patch{};  ///< by PatchKind; goes before the atom's

    Colour at(std::uint32_t atom, PatchKind patch) const {
        return of_patch[static_cast<std::size_t>(patch)].value_or(of_atom[atom]);
    }
};

/// Nothing for schemes of other things: curvature, component, depth, values.
/// cost     O(n)
std::optional<FeatureColours> feature_colours(const Structure& structure, const ColourOptions& options);

/// What shows values: two-sided about zero where the range is, else of one hue.
std::span<const Colour> ramp_of_values(const ValueRange& range);

/// A value's place in a range, 0 at its minimum, 1 at its maximum.
double place_in(const ValueRange& range, double value);

/// What is asked for, or the scheme's own; not of values, for which a mesh is needed.
ValueRange range_in_force(const ColourOptions& options, const Structure& structure);

}  // namespace meniscus
