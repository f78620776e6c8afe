// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "unknown_words.h"

#include <fmt/core.h>

#include <algorithm>
#include <filesystem>
#include <numeric>
#include <utility>
#include <vector>

#include "command_tree.h"
#include "meniscus/structure.h"

namespace meniscus::cli {

namespace {

constexpr std::size_t kMostLettersApart = 2;  // "--colour" for "--color", "--treads" for "--threads"

/// The option of a subcommand whose name is nearest to `word`, or empty if none is near.
std::string nearest_option(const CLI::App& command, const std::string& word) {
    std::string nearest;
    std::size_t least = kMostLettersApart + 1;
    for (const CLI::Option* option : command.get_options()) {
        for (const std::string& name : option->get_lnames()) {
            const std::string whole = "--" + name;
            const std::size_t apart = whole.starts_with(word) && word.size() > 3 ? 1 : letters_apart(whole, word);
            if (apart < least) nearest = whole;
            least = std::min(least, apart);
        }
    }
    return nearest;
}

/// Whether a command, or one of its subcommands, has an option of this name.
bool has_option(const CLI::App& command, const std::string& name) {
    const std::vector<const CLI::App*> inner = command.get_subcommands({});
    return command.get_option_no_throw(name) != nullptr ||
           std::any_of(inner.begin(), inner.end(), [&](const CLI::App* app) { return has_option(*app, name); });
}

/// "meniscus measure", or several subcommands that have an option of this name; empty if none has.
std::string owners_of(const CLI::App& whole, const std::string& name) {
    std::string owners;
    for (const CLI::App* command : whole.get_subcommands({}))
        if (has_option(*command, name)) owners += (owners.empty() ? "meniscus " : " and ") + command->get_name();
    return owners;
}

std::string stands_too_early(const std::string& name, const std::string& command) {
    return fmt::format("{1}: options come after the subcommand; write {0} {1} ...", command, name);
}

std::string nearest_name(const std::vector<std::string>& names, const std::string& word) {
    const auto apart = [&](const std::string& name) { return letters_apart(name, word); };
    const auto nearest =
        std::min_element(names.begin(), names.end(), [&](const auto& a, const auto& b) { return apart(a) < apart(b); });
    return nearest != names.end() && word.size() > 3 && apart(*nearest) <= kMostLettersApart ? *nearest : "";
}

}  // namespace

bool has_unknown_options(const CLI::App& program) {
    const std::vector<std::string> words = program.remaining(true);
    return std::any_of(words.begin(), words.end(), [](const auto& word) { return word.starts_with('-'); });
}

std::string explain_unknown_words(const CLI::App& program, const CLI::App& whole) {
    const std::vector<std::string> words = program.remaining(true);
    const auto option = std::find_if(words.begin(), words.end(), [](const auto& w) { return w.starts_with('-'); });
    const CLI::App* command = &program;
    std::string help;
    while (!command->get_subcommands().empty()) {
        command = command->get_subcommands().front();
        help += " " + command->get_name();
    }
    if (option == words.end())
        return fmt::format("{}: unexpected; there is only one INPUT, and outputs are named with -o", words.front());
    const std::string name = option->substr(0, option->find('='));
    if (command->get_option_no_throw(name) != nullptr) return stands_too_early(name, "meniscus" + help);
    if (whole.get_option_no_throw(name) != nullptr)
        return fmt::format("{0} is an option of meniscus itself; write meniscus {0}", name);
    if (const std::string owners = owners_of(whole, name); !owners.empty())
        return fmt::format("{} is an option of {}, not of meniscus{}", name, owners, help);
    const std::string meant = nearest_option(*command, name);
    if (!meant.empty()) return fmt::format("{}: unknown option; did you mean {}?", name, meant);
    return fmt::format("{}: unknown option; see meniscus{} --help", name, help);
}

std::string explain_leading_option(const CLI::App& whole, const std::vector<std::string>& words) {
    const std::string name = words.front().substr(0, words.front().find('='));
    const auto is_subcommand = [&](const std::string& word) { return find_subcommand(whole, word) != nullptr; };
    const auto subcommand = std::find_if(words.begin(), words.end(), is_subcommand);
    if (subcommand != words.end() && has_option(*find_subcommand(whole, *subcommand), name))
        return stands_too_early(name, "meniscus " + *subcommand);
    if (name == "-v") return "-v: unknown option; did you mean -V?";
    const std::string meant = nearest_option(whole, name);
    if (!meant.empty()) return fmt::format("{}: unknown option; did you mean {}?", name, meant);
    return fmt::format("{}: unknown option before any subcommand; see meniscus --help", name);
}

std::string explain_unknown_subcommand(const std::string& word, const std::vector<std::string>& names) {
    if (std::string hint = explain_identifier(word); !hint.empty()) return hint;
    std::error_code error;
    if (std::filesystem::exists(word, error))
        return fmt::format("unknown subcommand '{0}'; for its surface write meniscus surface {0}", word);
    const std::string meant = nearest_name(names, CLI::detail::to_lower(word));
    if (!meant.empty()) return fmt::format("unknown subcommand '{}'; did you mean meniscus {}?", word, meant);
    return fmt::format("unknown subcommand '{}'; see meniscus --help", word);
}

std::size_t letters_apart(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t exchanged = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({exchanged, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

}  // namespace meniscus::cli
