// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "help.h"

#include <algorithm>
#include <sstream>
#include <vector>

namespace meniscus::cli {

namespace {

constexpr std::size_t kTextColumn = 35;  // where what an option does begins
constexpr char kInFull = '\f';           // after it stands what --help-all shows instead of what stands before it

/// Characters of UTF-8: bytes that do not continue one.
std::size_t columns(const std::string& text) {
    return static_cast<std::size_t>(
        std::count_if(text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
}

bool in_full(CLI::AppFormatMode mode) { return mode == CLI::AppFormatMode::All; }

bool asks_for_help(const CLI::App& app, const CLI::Option& option) {
    return &option == app.get_help_ptr() || &option == app.get_help_all_ptr();
}

bool is_shown(const CLI::Option& option, CLI::AppFormatMode mode) {
    const std::string& text = option.get_description();
    return option.nonpositional() && (in_full(mode) || !(text.starts_with('\n') || text.starts_with(kInFull)));
}

/// What an option does and, in brackets, its default.
std::string describe(const CLI::Option& option, CLI::AppFormatMode mode) {
    std::string text = option.get_description();
    const std::size_t meaning = text.find(kInFull);
    if (!in_full(mode)) text.erase(std::min({text.find('\n'), meaning, text.size()}));
    if (in_full(mode) && meaning != std::string::npos) text.erase(0, meaning + 1);
    text.erase(std::remove(text.begin(), text.end(), '\n'), text.end());
    return option.get_default_str().empty() ? text : text + " [" + option.get_default_str() + "]";
}

/// "  --name VALUE" and what it does, from a column of its own.
std::string entry(const std::string& left, const std::string& text) {
    std::string line = "  " + left;
    if (columns(line) + 2 > kTextColumn) line += '\n';
    const std::size_t last = line.ends_with('\n') ? 0 : columns(line);
    line.append(kTextColumn - last, ' ');
    return line + wrap(text, {.indent = kTextColumn, .used = kTextColumn}) + "\n";
}

std::string option_entry(const CLI::Option& option, CLI::AppFormatMode mode) {
    std::string left = option.get_name(false, true);
    if (const std::size_t comma = left.find(','); comma != std::string::npos) left.insert(comma + 1, " ");
    if (option.get_type_size() != 0 && !option.get_type_name().empty()) left += " " + option.get_type_name();
    return entry(left, describe(option, mode));
}

/// The options by group, as they were added. Full help separates groups by an empty line.
std::string option_entries(const CLI::App& app, CLI::AppFormatMode mode) {
    std::string text;
    for (const std::string& group : app.get_groups()) {
        const auto options = app.get_options([&](const CLI::Option* option) {
            return option->get_group() == group && is_shown(*option, mode) && !asks_for_help(app, *option);
        });
        if (options.empty()) continue;
        if (in_full(mode)) text += '\n';
        text += group + ":\n";
        for (const CLI::Option* option : options) text += option_entry(*option, mode);
    }
    if (in_full(mode)) return text;
    return text + option_entry(*app.get_help_all_ptr(), mode);
}

std::string usage(const CLI::App& app, const std::string& name) {
    std::string line = "Usage: " + name;
    if (!app.get_subcommands({}).empty()) line += " SUBCOMMAND";
    for (const CLI::Option* option : app.get_options([](const CLI::Option* o) { return o->get_positional(); }))
        line += " " + option->get_name(true, false);
    return line + " [options]\n";
}

std::string positionals(const CLI::App& app) {
    std::string text;
    for (const CLI::Option* option : app.get_options([](const CLI::Option* o) { return o->get_positional(); })) {
        const std::string name = option->get_name(true, false) + ": ";
        text += name + wrap(option->get_description(), {.used = columns(name)}) + "\n";
    }
    return text;
}

/// Text without the marks of code and links; links in parentheses of their own, which only lead elsewhere, go.
std::string without_markdown(const std::string& markdown) {
    std::string text;
    for (std::size_t i = 0; i < markdown.size(); ++i) {
        const std::size_t middle = markdown[i] == '[' ? markdown.find("](", i) : std::string::npos;
        if (middle != std::string::npos) {
            const std::size_t end = markdown.find(')', middle);
            if (text.ends_with(" (") && markdown.compare(end, 2, "))") == 0) {
                text.resize(text.size() - 2);
                i = end + 1;
            } else {
                text += without_markdown(markdown.substr(i + 1, middle - i - 1));
                i = end;
            }
        } else if (markdown[i] != '`' && markdown[i] != '\\') {
            text += markdown[i];
        }
    }
    return text;
}

}  // namespace

std::string brief_description(const CLI::Option& option) {
    const std::string& text = option.get_description();
    const std::size_t start = text.find_first_not_of("\n\f");
    return start == std::string::npos ? "" : text.substr(start, text.find_first_of("\n\f", start) - start);
}

std::string full_description(const CLI::Option& option) { return describe(option, CLI::AppFormatMode::All); }

std::string rarely(const std::string& description) {
    const std::size_t meaning = description.find(kInFull);
    return meaning == std::string::npos ? "\n" + description : description.substr(meaning);
}

std::string described(const std::string& brief, const std::string& meaning) {
    return brief + kInFull + without_markdown(meaning);
}

std::string wrap(const std::string& text, const Wrap& layout) {
    std::istringstream words(text);
    std::string wrapped;
    std::size_t used = layout.used;
    bool starts_line = true;
    for (std::string word; words >> word;) {
        if (!starts_line && used + 1 + columns(word) > layout.width) {
            wrapped += '\n' + std::string(layout.indent, ' ');
            used = layout.indent;
            starts_line = true;
        }
        wrapped.append(starts_line ? 0 : 1, ' ').append(word);
        used += columns(word) + (starts_line ? 0 : 1);
        starts_line = false;
    }
    return wrapped;
}

std::string HelpFormatter::make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const {
    const std::string whole = name.empty() ? app->get_name() : name;
    std::string text = usage(*app, whole) + wrap(app->get_description(), {}) + "\n" + positionals(*app);
    const auto subcommands = app->get_subcommands({});
    if (!subcommands.empty()) text += "\nSubcommands:\n";
    for (const CLI::App* command : subcommands) text += entry(command->get_name(), command->get_description());
    if (!in_full(mode)) text += '\n';
    text += option_entries(*app, mode) + "\n" + make_footer(app);
    if (in_full(mode))
        for (const CLI::App* command : subcommands)
            text += "\n\n" + make_help(command, whole + " " + command->get_name(), mode);
    return text;
}

}  // namespace meniscus::cli
