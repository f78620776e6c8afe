// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What to say of words on the command line that nothing takes, and what may have been meant.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace meniscus::cli {

/// "--colour: unknown option; did you mean --color?" for the first word that was left over.
/// program   after a parse that has left words over
/// whole     with every subcommand: "--between is an option of meniscus measure" for that of another one
std::string explain_unknown_words(const CLI::App& program, const CLI::App& whole);

/// "--quiet: options come after the subcommand; ..." for a first word that is an option and not one of `whole` itself.
std::string explain_leading_option(const CLI::App& whole, const std::vector<std::string>& words);

/// "unknown subcommand 'x'; ..." for a first word that is none of `names`.
std::string explain_unknown_subcommand(const std::string& word, const std::vector<std::string>& names);

/// Whether a parse has left options over, which say more of a mistake than an INPUT that is missing because of them.
bool has_unknown_options(const CLI::App& program);

/// How many letters have to be put in, left out or exchanged to make one word of the other.
std::size_t letters_apart(const std::string& a, const std::string& b);

}  // namespace meniscus::cli
