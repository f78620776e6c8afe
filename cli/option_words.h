// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Options whose value is one of a few words, or a number read strictly.
#pragma once

#include <fmt/core.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include "meniscus/errors.h"
#include "numbers.h"

namespace meniscus::cli {

/// Words and what they stand for, the default first.
template <class T, std::size_t N>
using Words = std::array<std::pair<const char*, T>, N>;

template <class T, std::size_t N>
const char* word_for(const Words<T, N>& words, T value) {
    return std::find_if(words.begin(), words.end(), [&](const auto& w) { return w.second == value; })->first;
}

template <class T, std::size_t N>
std::string join(const Words<T, N>& words, const char* separator) {
    std::string list;
    for (const auto& word : words) list.append(list.empty() ? "" : separator).append(word.first);
    return list;
}

/// throws   UsageError for a text that is none of the words
template <class T, std::size_t N>
T parse_word(const char* option, const std::string& text, const Words<T, N>& words) {
    const auto found = std::find_if(words.begin(), words.end(), [&](const auto& w) { return text == w.first; });
    if (found == words.end())
        throw UsageError(fmt::format("{}: unknown value '{}'; one of {}", option, text, join(words, ", ")));
    return found->second;
}

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
