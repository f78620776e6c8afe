// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How an option is described, once for every client: the command line, Python, reports and the manual.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace meniscus {

/// Which numbers an option takes. Only PositiveOrInfinite includes infinity.
enum class NumberRange : std::uint8_t { Any, Positive, NotNegative, Negative, PositiveOrInfinite };

/// Whether a range contains a number.
inline bool contains(NumberRange range, double value) {
    if (range == NumberRange::PositiveOrInfinite) return value > 0.0;
    return std::isfinite(value) && (range != NumberRange::Positive || value > 0.0) &&
           (range != NumberRange::NotNegative || value >= 0.0) && (range != NumberRange::Negative || value < 0.0);
}

/// The range in words, for messages: "a finite number greater than 0".
constexpr const char* words_for(NumberRange range) {
    switch (range) {
        case NumberRange::Positive:
            return "a finite number greater than 0";
        case NumberRange::NotNegative:
            return "a finite number of at least 0";
        case NumberRange::Negative:
            return "a finite number less than 0";
        case NumberRange::PositiveOrInfinite:
            return "a number greater than 0";
        case NumberRange::Any:
            break;
    }
    return "a finite number";
}

/// With which other options an option has an effect.
enum class Effect : std::uint8_t {
    Always,
    WithFlow,         ///< Method::Flow
    WithGaussianMap,  ///< any method but Method::Direct
    WithEdge,         ///< RemeshOptions::edge above 0
};

/// The description of an option.
struct Option {
    const char* name = "";     ///< key in reports, keyword in Python; "min_cavity" is --min-cavity on the command line
    const char* brief = "";    ///< the line of --help; empty for an option that only --help-all shows
    const char* meaning = "";  ///< text for the manual in Markdown, with units
    const char* example = "";  ///< a sensible use on the command line, with the other options that it needs
    const char* symbol = "";   ///< placeholder for the value in help; empty for flags and choices
    NumberRange range = NumberRange::Any;
    Effect effect = Effect::Always;
    const char* standard = "";  ///< the default in words, if the member does not hold it
};

/// A function that names an option and a value in messages, as the users of a client write them.
///
/// option   Option::name: "hetero"
/// value    "ligands", "true"; capitals stand for what the user chooses: "ID"; empty: the option alone
using OptionSpelling = std::string (*)(std::string_view option, std::string_view value);

}  // namespace meniscus
