// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Options whose value is one of a few words, or a number read strictly.
#pragma once

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <string>

#include "meniscus/words.h"
#include "numbers.h"

namespace meniscus::cli {

/// An option whose value is one of `words`, which must outlive the parser.
template <class Target, class T, std::size_t N>
void add_choice(CLI::App& command, const char* name, Target& target, const Words<T, N>& words,
                const std::string& text) {
    const auto choose = [name, &target, &words](const std::string& value) { target = parse_word(name, value, words); };
    command.add_option_function<std::string>(name, choose, text)
        ->type_name(join(words, "|"))
        ->default_str(words.front().first);
}

/// An option whose value is a number; its default is what `target` holds.
inline void add_number(CLI::App& command, const char* name, double& target, Sign sign, const char* symbol,
                       const std::string& text) {
    const auto read = [name, &target, sign](const std::string& value) { target = parse_number(name, value, sign); };
    command.add_option_function<std::string>(name, read, text)
        ->type_name(symbol)
        ->default_str(fmt::format("{}", target));
}

inline CLI::Option* add_count(CLI::App& command, const char* name, int& target, const std::string& text) {
    const auto read = [name, &target](const std::string& value) { target = parse_count(name, value); };
    return command.add_option_function<std::string>(name, read, text)->type_name("N");
}

}  // namespace meniscus::cli
