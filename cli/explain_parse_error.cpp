// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "explain_parse_error.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include "command_tree.h"

namespace meniscus::cli {

namespace {

/// The subcommand that was being parsed, with the words that name it.
Command parsed_command(const CLI::App& program) {
    Command command{"meniscus", &program};
    while (!command.app->get_subcommands().empty()) {
        command.app = command.app->get_subcommands().front();
        command.words += " " + command.app->get_name();
    }
    return command;
}

std::string see_help(const Command& command) { return "; see " + command.words + " --help"; }

std::string explain_missing_subcommand(const Command& command) {
    const std::vector<std::string> names = subcommand_names(*command.app);
    return fmt::format("no subcommand; write {} {}{}", command.words, fmt::join(names, "|"), see_help(command));
}

/// The name before what the parser says of it.
std::string first_word(const std::string& text) { return text.substr(0, text.find_first_of(" :")); }

std::string last_word(const std::string& text) { return text.substr(text.rfind(' ') + 1); }

std::string explain_required(const Command& command, const std::string& text) {
    if (text.starts_with("A subcommand")) return explain_missing_subcommand(command);
    return first_word(text) + ": missing" + see_help(command);
}

/// A value too few, or an option too often.
std::string explain_mismatch(const Command& command, const std::string& text) {
    const std::string name = first_word(text);
    const CLI::Option* option = command.app->get_option_no_throw(name);
    if (text.ends_with("missing") && option != nullptr)
        return fmt::format("{0}: a value is missing; write {0} {1}", name, option->get_type_name());
    if (text.find("received") != std::string::npos)
        return fmt::format("{}: given {} times; give it once", name, last_word(text));
    return name + ": has the wrong number of values" + see_help(command);
}

}  // namespace

std::string explain_parse_error(const CLI::App& program, const CLI::ParseError& error) {
    const Command command = parsed_command(program);
    const std::string text = error.what();
    if (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr) return explain_required(command, text);
    if (dynamic_cast<const CLI::ExcludesError*>(&error) != nullptr)
        return fmt::format("{} and {} cannot be combined; give one of them", first_word(text), last_word(text));
    if (dynamic_cast<const CLI::RequiresError*>(&error) != nullptr)
        return fmt::format("{} needs {}; give both", first_word(text), last_word(text));
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr) return explain_mismatch(command, text);
    return text + see_help(command);
}

}  // namespace meniscus::cli
