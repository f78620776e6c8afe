// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "option_words.h"

namespace meniscus::cli {

CLI::Option* add_word(CLI::App& command, const OptionHelp& help, const std::function<void(const std::string&)>& read) {
    return command.add_option_function<std::string>(help.name, read, help.text)
        ->type_name(help.symbol)
        ->default_str(help.standard);
}

std::string first_given(const CLI::App& command, const std::string& group) {
    for (const CLI::Option* option : command.get_options())
        if (option->get_group() == group && option->count() > 0) return option->get_name();
    return {};
}

}  // namespace meniscus::cli
