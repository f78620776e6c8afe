// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Options whose value is one of a few words, or a number read strictly.
#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <string>

#include "meniscus/words.h"
#include "numbers.h"

namespace meniscus::cli {

/// What there is to say of an option that takes a word.
struct WordOption {
    std::function<void(const std::string&)> read;  ///< called with the word
    std::string text;                              ///< what it does
    std::string symbol;                            ///< what stands for the word in help
    std::string standard;                          ///< the word that holds without it; empty if it is not told
};

/// An option whose value is one word, which `option.read` may refuse with UsageError.
CLI::Option* add_word(CLI::App& command, const char* name, const WordOption& option);

/// An option whose value is one of `words`, which must outlive the parser.
template <class Target, class T, std::size_t N>
void add_choice(CLI::App& command, const char* name, Target& target, const Words<T, N>& words,
                const std::string& text) {
    const auto choose = [name, &target, &words](const std::string& value) { target = parse_word(name, value, words); };
    add_word(command, name, {choose, text, join(words, "|"), std::string(words.front().first)});
}

/// An option whose value is a number; its default is what `target` holds.
void add_number(CLI::App& command, const char* name, double& target, Sign sign, const char* symbol,
                const std::string& text);

/// The first option of a group of help that was given; empty if none was.
std::string first_given(const CLI::App& command, const std::string& group);

/// An option whose value is a whole number, from 1 on.
CLI::Option* add_count(CLI::App& command, const char* name, int& target, const std::string& text);

}  // namespace meniscus::cli
