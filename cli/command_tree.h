// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Commands and options of the program as it registers them: what completion and manual pages are made of.
#pragma once

#include <CLI/App.hpp>
#include <string>
#include <vector>

namespace meniscus::cli {

/// A subcommand, or a subcommand of one.
struct Command {
    std::string words;  ///< "batch surface"; empty for the program itself
    const CLI::App* app;
};

/// The program itself and all its subcommands, each before its own.
std::vector<Command> commands_of(const CLI::App& program);

/// The names of the subcommands of a command.
std::vector<std::string> subcommand_names(const CLI::App& command);

/// The subcommand of this name; null if there is none.
const CLI::App* find_subcommand(const CLI::App& command, const std::string& name);

/// The options with names, in the order in which they were added.
std::vector<const CLI::Option*> options_of(const CLI::App& command);

/// "-q", "--quiet".
std::vector<std::string> names_of(const CLI::Option& option);

bool takes_value(const CLI::Option& option);

/// The words that an option may be given, as far as it names them: auto, keep, drop.
std::vector<std::string> choices_of(const CLI::Option& option);

/// Whether the value of an option is the name of a file or folder.
bool takes_file(const CLI::Option& option);

}  // namespace meniscus::cli
