// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Van der Waals radii of elements: the fallback for atoms that a set does not know.
#pragma once

#include <optional>
#include <string_view>

namespace meniscus {

enum class RadiusSource {
    Bondi1964,    ///< A. Bondi, J. Phys. Chem. 68, 441-451 (1964), doi 10.1021/j100785a001, and 70, 3006 (1966)
    Alvarez2013,  ///< S. Alvarez, Dalton Trans. 42, 8617-8636 (2013), doi 10.1039/c3dt50599e
};

struct ElementRadius {
    std::string_view symbol;  ///< upper case: "C", "FE"
    double radius = 0.0;      ///< Å
    RadiusSource source = RadiusSource::Bondi1964;
};

/// The radius of an element: Bondi's where he gives one, else Alvarez's; nothing for what is no element here.
/// Deuterium counts as hydrogen. symbol is upper case.
std::optional<ElementRadius> element_radius(std::string_view symbol);

/// True for the symbol of any element up to 118, and D; upper case.
bool is_element(std::string_view symbol);

/// Radius for an atom of which not even the element is known, Å: carbon's, the commonest heavy atom.
inline constexpr double kUnknownElementRadius = 1.70;

}  // namespace meniscus
