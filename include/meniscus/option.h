// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How an option is described, once for all who offer it: the command line, Python, reports and the manual.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace meniscus {

/// Which numbers an option takes. All are finite, but for PositiveOrInfinite.
enum class NumberRange : std::uint8_t { Any, Positive, NotNegative, Negative, PositiveOrInfinite };

inline bool contains(NumberRange range, double value) {
    if (range == NumberRange::PositiveOrInfinite) return value > 0.0;
    return std::isfinite(value) && (range != NumberRange::Positive || value > 0.0) &&
           (range != NumberRange::NotNegative || value >= 0.0) && (range != NumberRange::Negative || value < 0.0);
}

/// "a finite number greater than 0", for messages.
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

/// What an option has an effect with.
enum class Effect : std::uint8_t {
    Always,
    WithFlow,         ///< Method::Flow
    WithGaussianMap,  ///< any method but Method::Direct
    WithEdge,         ///< even triangles
};

struct Option {
    const char* name;     ///< key of reports, keyword of Python; the command line puts "--" before it, "-" for "_"
    const char* brief;    ///< what a screen of help says; empty for what is rarely needed
    const char* meaning;  ///< what the manual says, with units; code in backticks, links as Markdown has them
    const char* example;  ///< a value that makes sense, and other options that it needs, as the command line has them
    const char* symbol = "";  ///< what stands for the value in help; flags and choices need none
    NumberRange range = NumberRange::Any;
    Effect effect = Effect::Always;
    const char* standard = "";  ///< the value in words that holds without the option, if the member does not tell
};

/// How messages name an option with a value for it: each client gives its users its own words.
///
/// option   the name of an option: "hetero"
/// value    "ligands", "true"; a word in capitals stands for what the user chooses: "ID"; empty: the option alone
using OptionSpelling = std::string (*)(std::string_view option, std::string_view value);

}  // namespace meniscus
