// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How help is laid out: --help gives a screen of 80 columns per subcommand, --help-all every option with all it does.
#pragma once

#include <CLI/App.hpp>
#include <CLI/Formatter.hpp>
#include <cstddef>
#include <string>

namespace meniscus::cli {

/// Lays out the help of the program and its subcommands.
///
/// The first line of an option's description is what --help shows, best in 45 characters with the default; --help-all
/// adds the rest as it is ("Length, Å\n of the blade"), or shows what described() has put in its place. An option whose
/// first line is empty is shown by --help-all alone, see rarely().
class HelpFormatter : public CLI::Formatter {
public:
    std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

/// The description of an option that only --help-all shows.
std::string rarely(const std::string& description);

/// The description of an option of which --help says one thing and --help-all another.
///
/// brief     empty for an option that only --help-all shows
/// meaning   with code and links as Markdown has them; shown without
std::string described(const std::string& brief, const std::string& meaning);

/// What an option does, in its first line (of rare ones, their only one), and in full with its default in brackets.
std::string brief_description(const CLI::Option& option);
std::string full_description(const CLI::Option& option);

struct Wrap {
    std::size_t indent = 0;  ///< spaces before every line but the first
    std::size_t used = 0;    ///< characters that the first line has already
    std::size_t width = 80;
};

/// Breaks `text` between words into lines of at most `width` characters of UTF-8, or one longer word.
std::string wrap(const std::string& text, const Wrap& layout);

}  // namespace meniscus::cli
