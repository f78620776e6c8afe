// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The whole command line: every subcommand with its options.
#pragma once

#include <CLI/App.hpp>
#include <memory>
#include <string>
#include <vector>

#include "structure_run.h"

namespace meniscus::cli {

/// The parser of the program, which sets `outcome` when it has run a subcommand.
///
/// first_word   of the command line: where it names a subcommand, only that one is there, because the options of all
///              take longer to make than to parse
std::unique_ptr<CLI::App> make_program(const std::string& first_word, Outcome& outcome);

/// The words of a command line as the parser takes them: "help surface" and "--help surface" as "surface --help",
/// negative numbers joined with their options.
std::vector<std::string> prepare_words(const std::vector<std::string>& words);

/// Refuses what the parser would have no clear message for: a first word that names no subcommand, an option before the
/// subcommand, a value for an option that takes none. throws   UsageError
void check_words(const CLI::App& program, const std::vector<std::string>& words);

/// What help does not list, for shells, packages and the manual: "--completion bash|zsh", "--man [SUBCOMMAND]" and
/// "--describe results", the JSON schemas of reports.
/// Whether the words ask for that; then it has been printed.
/// throws   UsageError for another shell or subcommand
bool print_made_page(const std::vector<std::string>& words);

}  // namespace meniscus::cli
