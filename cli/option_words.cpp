// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "option_words.h"

#include <fmt/core.h>

namespace meniscus::cli {

CLI::Option* add_word(CLI::App& command, const char* name, const WordOption& option) {
    CLI::Option* added =
        command.add_option_function<std::string>(name, option.read, option.text)->type_name(option.symbol);
    return option.standard.empty() ? added : added->default_str(option.standard);
}

void add_number(CLI::App& command, const char* name, double& target, Sign sign, const char* symbol,
                const std::string& text) {
    const auto read = [name, &target, sign](const std::string& value) { target = parse_number(name, value, sign); };
    add_word(command, name, {read, text, symbol, fmt::format("{}", target)});
}

std::string first_given(const CLI::App& command, const std::string& group) {
    for (const CLI::Option* option : command.get_options())
        if (option->get_group() == group && option->count() > 0) return option->get_name();
    return {};
}

CLI::Option* add_count(CLI::App& command, const char* name, int& target, const std::string& text) {
    const auto read = [name, &target](const std::string& value) { target = parse_count(name, value); };
    return add_word(command, name, {read, text, "N", ""});
}

}  // namespace meniscus::cli
