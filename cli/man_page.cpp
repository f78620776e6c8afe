// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "man_page.h"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <sstream>

#include "command_tree.h"
#include "help.h"
#include "meniscus/errors.h"
#include "meniscus/version.h"

namespace meniscus::cli {

namespace {

/// The character of UTF-8 that starts at `place`, which moves behind it.
std::uint32_t next_character(const std::string& text, std::size_t& place) {
    const auto first = static_cast<unsigned char>(text[place++]);
    if (first < 0x80) return first;
    const int more = first >= 0xF0 ? 3 : first >= 0xE0 ? 2 : 1;
    std::uint32_t code = first & (0x3FU >> more);
    for (int i = 0; i < more && place < text.size(); ++i)
        code = code << 6U | (static_cast<unsigned char>(text[place++]) & 0x3FU);
    return code;
}

/// Text as troff takes it, in ASCII: what has a meaning of its own is escaped.
std::string escaped(const std::string& text) {
    std::string result;
    for (std::size_t place = 0; place < text.size();) {
        const std::uint32_t code = next_character(text, place);
        if (code >= 0x80)
            result += fmt::format("\\[u{:04X}]", code);
        else if (code == '\\')
            result += "\\e";
        else if (code == '-')
            result += "\\-";
        else
            result += static_cast<char>(code);
    }
    const bool looks_like_request = result.starts_with('.') || result.starts_with('\'');
    return looks_like_request ? "\\&" + result : result;
}

std::string upper_case(std::string text) {
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; });
    return text;
}

std::string section(const std::string& title) { return ".SH \"" + escaped(upper_case(title)) + "\"\n"; }

/// Lines as they stand.
std::string verbatim(const std::string& text) {
    std::string result = ".nf\n";
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) result += line.empty() ? ".sp\n" : escaped(line) + "\n";
    return result + ".fi\n";
}

std::string option_entry_of_page(const CLI::Option& option) {
    std::string names;
    for (const std::string& name : names_of(option))
        names += (names.empty() ? "" : ", ") + ("\\fB" + escaped(name) + "\\fR");
    if (takes_value(option)) names += " \\fI" + escaped(option.get_type_name()) + "\\fR";
    return ".TP\n" + names + "\n" + escaped(full_description(option)) + "\n";
}

std::string options_by_group(const CLI::App& app) {
    std::string text;
    for (const std::string& group : app.get_groups()) {
        std::string entries;
        for (const CLI::Option* option : options_of(app))
            if (option->get_group() == group) entries += option_entry_of_page(*option);
        if (!entries.empty()) text += section(group) + entries;
    }
    return text;
}

std::string synopsis(const Command& command) {
    std::string line = "\\fBmeniscus" + (command.words.empty() ? "" : " " + escaped(command.words)) + "\\fR";
    if (!subcommand_names(*command.app).empty()) line += " \\fISUBCOMMAND\\fR";
    for (const CLI::Option* option : command.app->get_options([](const CLI::Option* o) { return o->get_positional(); }))
        line += " \\fI" + escaped(option->get_name(true, false)) + "\\fR";
    return line + " [options]\n";
}

std::string described_arguments(const CLI::App& app) {
    std::string text;
    for (const CLI::Option* option : app.get_options([](const CLI::Option* o) { return o->get_positional(); }))
        text +=
            ".TP\n\\fI" + escaped(option->get_name(true, false)) + "\\fR\n" + escaped(option->get_description()) + "\n";
    return text;
}

std::string subcommand_entries(const Command& command) {
    std::string text;
    for (const CLI::App* inner : command.app->get_subcommands({}))
        text += ".TP\n\\fB" + escaped(inner->get_name()) + "\\fR\n" + escaped(inner->get_description()) + "\n";
    return text.empty() ? "" : section("Subcommands") + text;
}

std::string see_also(const CLI::App& program, const std::string& subcommand) {
    std::string list = subcommand.empty() ? "" : "\\fBmeniscus\\fR(1)";
    for (const std::string& name : subcommand_names(program))
        if (name != subcommand) list += (list.empty() ? "" : ", ") + ("\\fBmeniscus\\-" + name + "\\fR(1)");
    return section("See also") + list + "\n";
}

std::string body(const Command& command) {
    std::string text = section("Synopsis") + synopsis(command) + section("Description") +
                       escaped(command.app->get_description()) + ".\n" + described_arguments(*command.app);
    text += subcommand_entries(command) + options_by_group(*command.app);
    const std::string footer = command.app->get_footer();
    return footer.empty() ? text : text + section("Examples and notes") + verbatim(footer);
}

/// The sections of a subcommand's own subcommands follow it.
std::string with_inner(const CLI::App& program, const std::string& subcommand) {
    std::string text;
    for (const Command& command : commands_of(program)) {
        const bool is_inner = command.words.starts_with(subcommand + " ");
        if (command.words == subcommand || (!subcommand.empty() && is_inner)) text += body(command);
    }
    return text;
}

}  // namespace

std::string man_page(const CLI::App& program, const std::string& subcommand) {
    const CLI::App* app = subcommand.empty() ? &program : find_subcommand(program, subcommand);
    if (app == nullptr) throw UsageError("--man: unknown subcommand '" + subcommand + "'");
    const std::string name = "meniscus" + (subcommand.empty() ? "" : "-" + subcommand);
    return fmt::format(".TH {} 1 \"\" \"Meniscus {}\" \"User commands\"\n", escaped(upper_case(name)), kVersion) +
           section("Name") + escaped(name) + " \\- " + escaped(app->get_description()) + "\n" +
           with_inner(program, subcommand) + see_also(program, subcommand);
}

}  // namespace meniscus::cli
