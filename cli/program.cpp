// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "program.h"

#include <fmt/core.h>
#include <CLI/Config.hpp>  // defines what App.hpp only declares; the program needs that once

#include <algorithm>
#include <array>
#include <string_view>

#include "batch/command.h"
#include "command_tree.h"
#include "compare_command.h"
#include "compare_report.h"
#include "completion.h"
#include "described_options.h"
#include "help.h"
#include "json_schema.h"
#include "man_page.h"
#include "measure_command.h"
#include "meniscus/errors.h"
#include "meniscus/version.h"
#include "pockets_command.h"
#include "report.h"
#include "surface_command.h"
#include "unknown_words.h"

namespace meniscus::cli {

namespace {

constexpr const char* kFooter =
    "Examples:\n"
    "  meniscus surface 1abc.pdb -o 1abc.ply     the surface as a mesh\n"
    "  meniscus surface 1abc.pdb -o 1abc.png     as a picture\n"
    "  meniscus measure 1abc.pdb                 areas, volumes and cavities\n"
    "  meniscus pockets 1abc.pdb                 pockets, best first\n"
    "  meniscus compare other.obj 1abc.pdb       a mesh and the exact surface\n"
    "  meniscus batch measure structures --out results   every file of a folder\n"
    "Help of a subcommand: meniscus help surface; of every option: --help-all.\n\n"
    "Exit codes: 0 done; 2 wrong usage; 3 input cannot be read or is not valid;\n"
    "4 output cannot be written; 5 would exceed the memory or size limit;\n"
    "6 computed, but a result failed its own checks, or inputs of a batch failed;\n"
    "1 anything else.";

struct Subcommand {
    std::string_view name;
    void (*add)(CLI::App&, Outcome&);
};

constexpr std::array kSubcommands{Subcommand{"surface", add_surface_command},
                                  Subcommand{"measure", add_measure_command},
                                  Subcommand{"pockets", add_pockets_command},
                                  Subcommand{"compare", add_compare_command}, Subcommand{"batch", add_batch_command}};

void add_subcommands(CLI::App& program, const std::string& first_word, Outcome& outcome) {
    const auto is_meant = [&](const Subcommand& command) { return command.name == first_word; };
    const bool adds_one = std::any_of(kSubcommands.begin(), kSubcommands.end(), is_meant);
    for (const Subcommand& command : kSubcommands)
        if (!adds_one || is_meant(command)) command.add(program, outcome);
}

std::vector<std::string> names_of_subcommands() {
    std::vector<std::string> names(kSubcommands.size());
    std::transform(kSubcommands.begin(), kSubcommands.end(), names.begin(),
                   [](const Subcommand& command) { return std::string(command.name); });
    return names;
}

/// The JSON schemas of reports, or what is to be known of the options that are described for all clients.
std::string description_of(const std::string& what) {
    if (what == "options") return described_options().dump() + "\n";
    if (what != "results") throw UsageError("--describe: unknown value '" + what + "'; choose one of options, results");
    return ordered_json{{"report", report_schema()}, {"compare", compare_schema()}, {"pockets", pockets_schema()}}
               .dump() +
           "\n";
}

bool is_truth(const std::string& value) { return value == "true" || value == "false"; }

/// "--waters=5", which would count as five times --waters, and "-o=x.ply", which would name a file "=x.ply".
void check_signs(const CLI::App& command, const std::vector<std::string>& words) {
    for (const std::string& word : words) {
        if (word.starts_with("-o=")) throw UsageError(fmt::format("{}: write -o {}", word, word.substr(3)));
        const std::size_t sign = word.find('=');
        if (!word.starts_with("--") || sign == std::string::npos || is_truth(word.substr(sign + 1))) continue;
        const std::string name = word.substr(0, sign);
        const CLI::Option* option = command.get_option_no_throw(name);
        if (option != nullptr && !takes_value(*option))
            throw UsageError(fmt::format("{} takes no value; leave {} out", name, word.substr(sign)));
    }
}

/// "help surface", "--help surface" and "surface help" as "surface --help".
std::vector<std::string> help_words(std::vector<std::string> words) {
    const auto asks = [](const std::string& word) {
        return word == "help" || word == "-h" || word.starts_with("--help");
    };
    constexpr std::size_t kMostWords = 3;  // "batch help measure"
    const auto asking = std::find_if(words.begin(), words.end(), asks);
    if (asking == words.end() || (asking != words.begin() && words.size() > kMostWords)) return words;
    std::rotate(asking, asking + 1, words.end());
    if (words.empty() || words.back() != "help") return words;
    words.pop_back();
    if (words.empty() || !words.back().starts_with("--help")) words.emplace_back("--help");
    return words;
}

/// Options of the program itself come first; those of subcommands after their names.
void check_leading_option(const CLI::App& program, const std::vector<std::string>& words) {
    const std::string name = words.front().substr(0, words.front().find('='));
    if (program.get_option_no_throw(name) == nullptr) throw UsageError(explain_leading_option(program, words));
}

}  // namespace

std::unique_ptr<CLI::App> make_program(const std::string& first_word, Outcome& outcome) {
    auto program = std::make_unique<CLI::App>("Solvent-excluded surfaces of proteins and other molecules", "meniscus");
    program->formatter(std::make_shared<HelpFormatter>());
    program->set_help_flag("-h,--help", "This help, on one screen");
    program->set_help_all_flag("--help-all", "Every option in full");
    program->set_version_flag("-V,--version", std::string("meniscus ") + kVersion, "The version");
    program->require_subcommand(1);
    program->footer(kFooter);
    add_subcommands(*program, first_word, outcome);
    return program;
}

std::vector<std::string> prepare_words(const std::vector<std::string>& words) {
    return join_negative_values(help_words(words));
}

void check_words(const CLI::App& program, const std::vector<std::string>& words) {
    if (words.empty()) return;
    if (words.front().starts_with("-")) return check_leading_option(program, words);
    const CLI::App* command = &program;
    for (const std::string& word : words) {
        const CLI::App* inner = find_subcommand(*command, word);
        if (inner == nullptr) break;
        command = inner;
    }
    if (command == &program) throw UsageError(explain_unknown_subcommand(words.front(), names_of_subcommands()));
    check_signs(*command, words);
}

bool print_made_page(const std::vector<std::string>& words) {
    constexpr std::array kPages{"--completion", "--man", "--describe"};
    if (words.empty() || std::find(kPages.begin(), kPages.end(), words.front()) == kPages.end()) return false;
    Outcome ignored = Outcome::Done;
    const auto program = make_program("", ignored);
    if (words.size() > 2) throw UsageError(words[2] + ": unexpected; " + words[0] + " takes one word");
    const std::string what = words.size() > 1 ? words[1] : "";
    if (words.front() == "--describe") {
        print(description_of(what));
        return true;
    }
    print(words.front() == "--man" ? man_page(*program, what) : completion_script(*program, what));
    return true;
}

}  // namespace meniscus::cli
