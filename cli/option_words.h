// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Options whose value is a word or a number, read strictly.
#pragma once

#include <fmt/core.h>

#include <CLI/App.hpp>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

#include "meniscus/words.h"
#include "numbers.h"

namespace meniscus::cli {

/// An option as help shows it.
struct OptionHelp {
    std::string name;        ///< "--probe"
    std::string text;        ///< what the option does
    std::string symbol{};    ///< what stands for its value
    std::string standard{};  ///< the value that holds without the option; empty if help does not show one
};

/// An option whose value is one word, which `read` may refuse with UsageError.
CLI::Option* add_word(CLI::App& command, const OptionHelp& help, const std::function<void(const std::string&)>& read);

/// An option whose value is one of `words`, which must outlive the parser; by default the first.
template <class Target, class T, std::size_t N>
void add_choice(CLI::App& command, OptionHelp help, Target& target, const Words<T, N>& words) {
    help.symbol = join(words, "|");
    if (help.standard.empty()) help.standard = words.front().first;
    add_word(command, help,
             [name = help.name, &target, &words](const std::string& text) { target = parse_word(name, text, words); });
}

/// The same as an option that may be given several times, each time with one word.
template <class T, std::size_t N>
void add_choices(CLI::App& command, const OptionHelp& help, std::vector<T>& target, const Words<T, N>& words) {
    const auto choose = [name = help.name, &target, &words](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) target.push_back(parse_word(name, text, words));
    };
    command.add_option_function<std::vector<std::string>>(help.name, choose, help.text)
        ->type_name(join(words, "|"))
        ->allow_extra_args(false)
        ->default_str(words.front().first);
}

/// An option whose value is a number; by default what `target`, a double or an optional one, holds.
template <class Target>
void add_number(CLI::App& command, OptionHelp help, Target& target, Sign sign) {
    if constexpr (std::is_same_v<Target, double>) help.standard = fmt::format("{}", target);
    add_word(command, help,
             [name = help.name, &target, sign](const std::string& text) { target = parse_number(name, text, sign); });
}

/// An option whose value is a whole number, from 1 on.
template <class Target>
void add_count(CLI::App& command, OptionHelp help, Target& target) {
    help.symbol = "N";
    add_word(command, help, [name = help.name, &target](const std::string& text) { target = parse_count(name, text); });
}

/// The first option of a group of help that was given; empty if none was.
std::string first_given(const CLI::App& command, const std::string& group);

}  // namespace meniscus::cli
