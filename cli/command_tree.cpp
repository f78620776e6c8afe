// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "command_tree.h"

#include <algorithm>
#include <string_view>

#include "meniscus/file_words.h"

namespace meniscus::cli {

namespace {

void add_commands(const CLI::App& app, const std::string& words, std::vector<Command>& commands) {
    commands.push_back({words, &app});
    for (const CLI::App* inner : app.get_subcommands({}))
        add_commands(*inner, words + (words.empty() ? "" : " ") + inner->get_name(), commands);
}

/// Symbols such as FILE are in capitals.
bool is_choice(const std::string& word) {
    constexpr std::string_view kOfWords = "abcdefghijklmnopqrstuvwxyz-";
    return !word.empty() && word.find_first_not_of(kOfWords) == std::string::npos;
}

}  // namespace

std::vector<Command> commands_of(const CLI::App& program) {
    std::vector<Command> commands;
    add_commands(program, "", commands);
    return commands;
}

std::vector<std::string> subcommand_names(const CLI::App& command) {
    std::vector<std::string> names;
    for (const CLI::App* inner : command.get_subcommands({})) names.push_back(inner->get_name());
    return names;
}

const CLI::App* find_subcommand(const CLI::App& command, const std::string& name) {
    const std::vector<const CLI::App*> found =
        command.get_subcommands([&](const CLI::App* inner) { return inner->get_name() == name; });
    return found.empty() ? nullptr : found.front();
}

std::vector<const CLI::Option*> options_of(const CLI::App& command) {
    return command.get_options([](const CLI::Option* option) { return option->nonpositional(); });
}

std::vector<std::string> names_of(const CLI::Option& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.get_snames()) names.push_back("-" + name);
    for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
    return names;
}

bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

std::vector<std::string> choices_of(const CLI::Option& option) {
    std::vector<std::string> choices;
    if (option.get_type_name() == "SCHEME")
        for (const auto& word : kColourSchemeWords) choices.emplace_back(word.first);
    for (const std::string& word : CLI::detail::split(option.get_type_name(), '|'))
        if (is_choice(word)) choices.push_back(word);
    return choices;
}

bool takes_file(const CLI::Option& option) {
    const std::string symbol = option.get_type_name();
    return symbol.find("FILE") != std::string::npos || symbol.find("DIR") != std::string::npos || symbol == "SET";
}

}  // namespace meniscus::cli
