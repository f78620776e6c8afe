// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Options whose value is a word or a number, read strictly.
#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "meniscus/describe_options.h"
#include "meniscus/vec3.h"
#include "meniscus/words.h"
#include "reading/option_numbers.h"

namespace meniscus::cli {

/// An option as help shows it.
struct OptionHelp {
    std::string name;        ///< "--probe"
    std::string text;        ///< what the option does
    std::string symbol{};    ///< what stands for its value
    std::string standard{};  ///< the value that holds without the option; empty if help does not show one
};

/// "--min-cavity" for "min_cavity".
std::string flag_of(std::string_view option);

OptionHelp help_of(const Option& option);

/// The numbers of a list with commas between them.
/// throws   UsageError for what is no number, and no list
std::vector<double> numbers_in(const std::string& option, const std::string& text);

/// The point "X,Y,Z"; nothing where the text is not made like three numbers and may be a selection.
/// throws   as numbers_in()
std::optional<Vec3> point_in(const std::string& option, const std::string& text);

/// An option whose value is one word, which `read` may refuse with UsageError.
CLI::Option* add_word(CLI::App& command, const OptionHelp& help, const std::function<void(const std::string&)>& read);

/// An option whose value is one of `words`, which must outlive the parser; by default the first. take(value) is called.
template <class T, std::size_t N, class Take>
void add_choice(CLI::App& command, OptionHelp help, const Words<T, N>& words, Take take) {
    help.symbol = join(words, "|");
    if (help.standard.empty()) help.standard = words.front().first;
    add_word(command, help,
             [name = help.name, &words, take](const std::string& text) { take(parse_word(name, text, words)); });
}

/// The same; the value goes to `target`.
template <class Target, class T, std::size_t N>
void add_choice(CLI::App& command, const OptionHelp& help, Target& target, const Words<T, N>& words) {
    add_choice(command, help, words, [&target](T value) { target = value; });
}

/// The same as an option that may be given several times, each time with one word.
template <class T, std::size_t N>
void add_choices(CLI::App& command, const OptionHelp& help, std::vector<T>& target, const Words<T, N>& words) {
    const auto choose = [name = help.name, &target, &words](const std::vector<std::string>& texts) {
        for (const std::string& text : texts) target.push_back(parse_word(name, text, words));
    };
    command.add_option_function<std::vector<std::string>>(help.name, choose, help.text)
        ->type_name(join(words, "|"))
        ->allow_extra_args(false)
        ->default_str(words.front().first);
}

/// An option whose value is a whole number, from 1 on.
template <class Target>
void add_count(CLI::App& command, OptionHelp help, Target& target) {
    help.symbol = "N";
    add_word(command, help, [name = help.name, &target](const std::string& text) { target = parse_count(name, text); });
}

/// Gives a command the options that a description of describe_options.h visits. What the options fill must outlive the
/// parser.
class OptionAdder {
public:
    explicit OptionAdder(CLI::App& command) : command_(command) {}

    void operator()(const Option& option, bool& target) const;
    void operator()(const Option& option, double& target) const;
    void operator()(const Option& option, int& target) const;          ///< from 1 on
    void operator()(const Option& option, std::size_t& target) const;  ///< an amount of memory
    void operator()(const Option& option, double& target, double (*of)(double)) const;
    void operator()(const Option& option, FlowOptions& flow, const Words<FlowName, 3>& words) const {
        add_choice(command_, help_of(option), words, [&flow](FlowName name) { flow = flow_of(name); });
    }
    template <class T, std::size_t N>
    void operator()(const Option& option, T& target, const Words<T, N>& words) const {
        add_choice(command_, help_of(option), target, words);
    }

private:
    CLI::App& command_;
};

/// The first option of a group of help that was given; empty if none was.
std::string first_given(const CLI::App& command, const std::string& group);

}  // namespace meniscus::cli
