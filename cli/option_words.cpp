// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "option_words.h"

#include <fmt/core.h>

#include <algorithm>

#include "help.h"

namespace meniscus::cli {

std::string flag_of(std::string_view option) {
    std::string flag = "--" + std::string(option);
    std::replace(flag.begin(), flag.end(), '_', '-');
    return flag;
}

OptionHelp help_of(const Option& option) {
    return {flag_of(option.name), described(option.brief, option.meaning), option.symbol, option.standard};
}

std::vector<double> numbers_in(const std::string& option, const std::string& text) {
    std::vector<double> numbers;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        numbers.push_back(parse_number(option, text.substr(begin, end - begin), NumberRange::Any));
        begin = end + 1;
    }
    return numbers;
}

std::optional<Vec3> point_in(const std::string& option, const std::string& text) {
    const bool is_point = std::count(text.begin(), text.end(), ',') == 2 &&
                          text.find_first_not_of("0123456789.,+-eE ") == std::string::npos;
    if (!is_point) return std::nullopt;
    const std::vector<double> numbers = numbers_in(option, text);
    return Vec3{numbers[0], numbers[1], numbers[2]};
}

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

void OptionAdder::operator()(const Option& option, bool& target) const {
    const OptionHelp help = help_of(option);
    command_.add_flag(help.name, target, help.text);
}

void OptionAdder::operator()(const Option& option, double& target) const {
    OptionHelp help = help_of(option);
    if (help.standard.empty() && contains(option.range, target)) help.standard = fmt::format("{}", target);
    add_word(command_, help, [name = help.name, &target, range = option.range](const std::string& text) {
        target = parse_number(name, text, range);
    });
}

void OptionAdder::operator()(const Option& option, int& target) const {
    const OptionHelp help = help_of(option);
    add_word(command_, help,
             [name = help.name, &target](const std::string& text) { target = parse_count(name, text); });
}

void OptionAdder::operator()(const Option& option, std::size_t& target) const {
    const OptionHelp help = help_of(option);
    add_word(command_, help,
             [name = help.name, &target](const std::string& text) { target = parse_memory(name, text); });
}

void OptionAdder::operator()(const Option& option, double& target, double (*of)(double)) const {
    const OptionHelp help = help_of(option);
    add_word(command_, help, [name = help.name, &target, of, range = option.range](const std::string& text) {
        target = of(parse_number(name, text, range));
    });
}

}  // namespace meniscus::cli
