// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "completion.h"

#include <fmt/core.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "command_tree.h"
#include "help.h"
#include "meniscus/errors.h"

namespace meniscus::cli {

namespace {

// ---- bash

constexpr const char* kBashStart = R"(# bash completion of meniscus, made by `meniscus --completion bash`
_meniscus() {
    local current=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]} command='' word words=''
    COMPREPLY=()
    # bash parts --option=value into three words
    if [[ $current == '=' ]]; then
        current=''
    elif [[ $before == '=' ]]; then
        before=${COMP_WORDS[COMP_CWORD - 2]}
    fi
    for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
        case "$command $word" in
)";

constexpr const char* kBashEnd = R"(    esac
    if [[ -n $words ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
    fi
}
complete -o bashdefault -o default -F _meniscus meniscus
)";

std::string joined(const std::vector<std::string>& words, const char* separator) {
    return fmt::format("{}", fmt::join(words, separator));
}

/// "surface:--method" and others that stand before a value, as patterns of `case`.
std::string patterns(const std::string& command, const CLI::Option& option) {
    std::vector<std::string> list;
    for (const std::string& name : names_of(option)) list.push_back(fmt::format("'{}:{}'", command, name));
    return joined(list, " | ");
}

std::string bash_values(const Command& command) {
    std::string text;
    for (const CLI::Option* option : options_of(*command.app))
        if (takes_value(*option))
            text += fmt::format("        {}) words='{}' ;;\n", patterns(command.words, *option),
                                joined(choices_of(*option), " "));
    return text;
}

std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : options_of(app))
        for (const std::string& name : names_of(*option)) names.push_back(name);
    return names;
}

/// What may stand where no value is expected: options after a dash, else subcommands, or files.
std::string bash_words(const Command& command) {
    std::vector<std::string> names = subcommand_names(*command.app);
    if (command.words.empty()) names.emplace_back("help");
    return fmt::format(
        "        '{0}:'*)\n            words='{1}'\n            [[ $current == -* ]] && words='{2}'\n            ;;\n",
        command.words, joined(names, " "), joined(option_names(*command.app), " "));
}

std::string bash_script(const CLI::App& program) {
    const std::vector<Command> commands = commands_of(program);
    std::vector<std::string> known{"' help'"};
    for (const Command& command : commands)
        if (!command.words.empty())
            known.push_back(command.words.find(' ') == std::string::npos ? fmt::format("' {}'", command.words)
                                                                         : fmt::format("'{}'", command.words));
    std::string text = kBashStart;
    text += fmt::format("            {}) command=${{command:+$command }}$word ;;\n", joined(known, " | "));
    text += "            *) break ;;\n        esac\n    done\n    case \"$command:$before\" in\n";
    for (const Command& command : commands) text += bash_values(command);
    text += fmt::format("        help:*) words='{}' ;;\n", joined(subcommand_names(program), " "));
    for (const Command& command : commands) text += bash_words(command);
    return text + kBashEnd;
}

// ---- zsh

/// As it may stand between brackets within single quotes.
std::string zsh_text(const std::string& text) {
    std::string escaped;
    for (const char c : text) {
        if (c == '\'') {
            escaped += "'\\\\''";
            continue;
        }
        if (c == '[' || c == ']' || c == ':' || c == '\\') escaped += '\\';
        escaped += c;
    }
    return escaped;
}

std::string zsh_value(const CLI::Option& option) {
    if (!takes_value(option)) return "";
    const std::string symbol = zsh_text(option.get_type_name());
    const std::vector<std::string> choices = choices_of(option);
    if (!choices.empty()) return fmt::format(":{}:({})", symbol, joined(choices, " "));
    return fmt::format(":{}:{}", symbol, takes_file(option) ? "_files" : " ");
}

/// Whether a value may follow after "=", and not only as the next word.
bool may_be_joined(const CLI::Option& option, const std::string& name) {
    return takes_value(option) && name.starts_with("--");
}

std::string zsh_options(const CLI::App& app, const std::string& indent) {
    std::string text;
    for (const CLI::Option* option : options_of(app))
        for (const std::string& name : names_of(*option))
            text += fmt::format(" \\\n{}'*{}{}[{}]{}'", indent, name, may_be_joined(*option, name) ? "=" : "",
                                zsh_text(brief_description(*option)), zsh_value(*option));
    return text;
}

std::string zsh_subcommands(const CLI::App& app) {
    std::string text;
    for (const CLI::App* inner : app.get_subcommands({}))
        text += fmt::format(" '{}:{}'", inner->get_name(), zsh_text(inner->get_description()));
    return text;
}

std::string zsh_function(const std::string& name) {
    std::string function = "_meniscus" + (name.empty() ? "" : "_" + name);
    std::replace(function.begin(), function.end(), ' ', '_');
    return function;
}

/// The arguments of a command that has no subcommands, or the choice among these.
std::string zsh_command(const Command& command) {
    const std::string function = zsh_function(command.words);
    std::string text = function + "() {\n";
    if (subcommand_names(*command.app).empty())
        return text + "    _arguments -S" + zsh_options(*command.app, "        ") +
               " \\\n        '*:file:_files'\n}\n\n";
    const std::string help = command.words.empty() ? " 'help:Help of a subcommand'" : "";
    text += "    local -a commands=(" + zsh_subcommands(*command.app).substr(1) + help + ")\n";
    text += "    local state line\n    _arguments -C" + zsh_options(*command.app, "        ") +
            " \\\n        '1: :->command' '*:: :->arguments'\n";
    text += "    case $state in\n        command) _describe subcommand commands ;;\n        arguments)\n";
    text += "            case $line[1] in\n";
    if (!help.empty()) text += "                help) _describe subcommand commands ;;\n";
    for (const std::string& name : subcommand_names(*command.app))
        text += fmt::format("                {}) {}_{} ;;\n", name, function, name);
    return text + "            esac\n            ;;\n    esac\n}\n\n";
}

std::string zsh_script(const CLI::App& program) {
    std::string text = "#compdef meniscus\n# zsh completion of meniscus, made by `meniscus --completion zsh`\n\n";
    for (const Command& command : commands_of(program)) text += zsh_command(command);
    return text + "_meniscus \"$@\"\n";
}

}  // namespace

std::string completion_script(const CLI::App& program, const std::string& shell) {
    if (shell == "bash") return bash_script(program);
    if (shell == "zsh") return zsh_script(program);
    throw UsageError(fmt::format("--completion: unknown shell '{}'; choose one of bash zsh", shell));
}

}  // namespace meniscus::cli
