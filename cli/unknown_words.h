// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What to say of words on the command line that nothing takes, and what may have been meant.
#pragma once

#include <CLI/App.hpp>
#include <string>

namespace meniscus::cli {

/// "--colour: unknown option; did you mean --color?" for the first word that was left over.
/// program   after a parse that failed with CLI::ExtrasError
std::string explain_unknown_words(const CLI::App& program);

/// "unknown subcommand 'x'; ..." for a first word that names none.
std::string explain_unknown_subcommand(const std::string& word);

/// How many letters have to be put in, left out or exchanged to make one word of the other.
std::size_t letters_apart(const std::string& a, const std::string& b);

}  // namespace meniscus::cli
