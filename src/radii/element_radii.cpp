// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Table of element radii; every value names its source.
#include "radii/element_radii.h"

#include <algorithm>
#include <array>

namespace meniscus {
namespace {

using enum RadiusSource;

constexpr auto kElementRadii = std::to_array<ElementRadius>({
    // clang-format off
    {"H",  1.20, Bondi1964},   {"D",  1.20, Bondi1964},   {"HE", 1.40, Bondi1964},   {"C",  1.70, Bondi1964},
    {"N",  1.55, Bondi1964},   {"O",  1.52, Bondi1964},   {"F",  1.47, Bondi1964},   {"NE", 1.54, Bondi1964},
    {"SI", 2.10, Bondi1964},   {"P",  1.80, Bondi1964},   {"S",  1.80, Bondi1964},   {"CL", 1.75, Bondi1964},
    {"AR", 1.88, Bondi1964},   {"AS", 1.85, Bondi1964},   {"SE", 1.90, Bondi1964},   {"BR", 1.85, Bondi1964},
    {"KR", 2.02, Bondi1964},   {"TE", 2.06, Bondi1964},   {"I",  1.98, Bondi1964},   {"XE", 2.16, Bondi1964},
    {"LI", 1.82, Bondi1964},   {"NA", 2.27, Bondi1964},   {"MG", 1.73, Bondi1964},   {"K",  2.75, Bondi1964},
    {"NI", 1.63, Bondi1964},   {"CU", 1.40, Bondi1964},   {"ZN", 1.39, Bondi1964},   {"GA", 1.87, Bondi1964},
    {"PD", 1.63, Bondi1964},   {"AG", 1.72, Bondi1964},   {"CD", 1.58, Bondi1964},   {"IN", 1.93, Bondi1964},
    {"SN", 2.17, Bondi1964},   {"PT", 1.72, Bondi1964},   {"AU", 1.66, Bondi1964},   {"HG", 1.55, Bondi1964},
    {"TL", 1.96, Bondi1964},   {"PB", 2.02, Bondi1964},   {"U",  1.86, Bondi1964},
    {"BE", 1.98, Alvarez2013}, {"B",  1.91, Alvarez2013}, {"AL", 2.25, Alvarez2013}, {"CA", 2.62, Alvarez2013},
    {"SC", 2.58, Alvarez2013}, {"TI", 2.46, Alvarez2013}, {"V",  2.42, Alvarez2013}, {"CR", 2.45, Alvarez2013},
    {"MN", 2.45, Alvarez2013}, {"FE", 2.44, Alvarez2013}, {"CO", 2.40, Alvarez2013}, {"GE", 2.29, Alvarez2013},
    {"RB", 3.21, Alvarez2013}, {"SR", 2.84, Alvarez2013}, {"Y",  2.75, Alvarez2013}, {"ZR", 2.52, Alvarez2013},
    {"NB", 2.56, Alvarez2013}, {"MO", 2.45, Alvarez2013}, {"TC", 2.44, Alvarez2013}, {"RU", 2.46, Alvarez2013},
    {"RH", 2.44, Alvarez2013}, {"SB", 2.47, Alvarez2013}, {"CS", 3.48, Alvarez2013}, {"BA", 3.03, Alvarez2013},
    {"LA", 2.98, Alvarez2013}, {"CE", 2.88, Alvarez2013}, {"PR", 2.92, Alvarez2013}, {"ND", 2.95, Alvarez2013},
    {"SM", 2.90, Alvarez2013}, {"EU", 2.87, Alvarez2013}, {"GD", 2.83, Alvarez2013}, {"TB", 2.79, Alvarez2013},
    {"DY", 2.87, Alvarez2013}, {"HO", 2.81, Alvarez2013}, {"ER", 2.83, Alvarez2013}, {"TM", 2.79, Alvarez2013},
    {"YB", 2.80, Alvarez2013}, {"LU", 2.74, Alvarez2013}, {"HF", 2.63, Alvarez2013}, {"TA", 2.53, Alvarez2013},
    {"W",  2.57, Alvarez2013}, {"RE", 2.49, Alvarez2013}, {"OS", 2.48, Alvarez2013}, {"IR", 2.41, Alvarez2013},
    {"BI", 2.54, Alvarez2013}, {"TH", 2.93, Alvarez2013}, {"PA", 2.88, Alvarez2013}, {"NP", 2.82, Alvarez2013},
    {"PU", 2.81, Alvarez2013}, {"AM", 2.83, Alvarez2013}, {"CM", 3.05, Alvarez2013}, {"CF", 3.05, Alvarez2013},
    // clang-format on
});

// Elements for which neither source has a radius.
constexpr auto kOtherElements = std::to_array<std::string_view>({
    "PM", "PO", "AT", "RN", "FR", "RA", "AC", "BK", "ES", "FM", "MD", "NO", "LR", "RF",
    "DB", "SG", "BH", "HS", "MT", "DS", "RG", "CN", "NH", "FL", "MC", "LV", "TS", "OG",
});

}  // namespace

std::optional<ElementRadius> element_radius(std::string_view symbol) {
    const auto found = std::find_if(kElementRadii.begin(), kElementRadii.end(),
                                    [&](const ElementRadius& e) { return e.symbol == symbol; });
    return found == kElementRadii.end() ? std::nullopt : std::optional(*found);
}

bool is_element(std::string_view symbol) {
    return element_radius(symbol).has_value() ||
           std::find(kOtherElements.begin(), kOtherElements.end(), symbol) != kOtherElements.end();
}

}  // namespace meniscus
