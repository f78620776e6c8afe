// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The program `meniscus`: parses the command line and turns what went wrong into exit codes.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include "batch/command.h"
#include "compare_command.h"
#include "heap.h"
#include "help.h"
#include "interrupt.h"
#include "measure_command.h"
#include "meniscus/errors.h"
#include "meniscus/version.h"
#include "messages.h"
#include "surface_command.h"
#include "unknown_words.h"

namespace {

using meniscus::cli::Outcome;

constexpr int kDone = 0;
constexpr int kOtherError = 1;
constexpr int kUsageError = 2;
constexpr int kInputError = 3;
constexpr int kOutputError = 4;
constexpr int kLimitError = 5;
constexpr int kChecksFailed = 6;
constexpr int kSignalBase = 128;

constexpr const char* kFooter =
    "Examples:\n"
    "  meniscus surface 1abc.pdb -o 1abc.ply     the surface as a mesh\n"
    "  meniscus surface 1abc.pdb -o 1abc.png     as a picture\n"
    "  meniscus measure 1abc.pdb                 areas, volumes and cavities\n"
    "  meniscus compare other.obj 1abc.pdb       a mesh and the exact surface\n"
    "  meniscus batch measure structures --out results   every file of a folder\n"
    "Help of a subcommand: meniscus surface --help; of every option: --help-all.\n\n"
    "Exit codes: 0 done; 2 wrong usage; 3 input cannot be read or is not valid;\n"
    "4 output cannot be written; 5 would exceed the memory or size limit;\n"
    "6 computed, but a result failed its own checks, or inputs of a batch failed;\n"
    "1 anything else.";

int fail(int code, const std::string& what) {
    meniscus::cli::print_error(std::cerr, what);
    return code;
}

/// Prints help or the version, or says what is wrong with the command line.
int report_parse_error(const CLI::App& program, const CLI::ParseError& error) {
    if (error.get_exit_code() == static_cast<int>(CLI::ExitCodes::Success)) {
        program.exit(error, std::cout, std::cerr);
        std::cout.flush();
        return std::cout ? kDone : fail(kOutputError, "standard output: cannot be written");
    }
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
        return fail(kUsageError, meniscus::cli::explain_unknown_words(program));
    return fail(kUsageError, std::string(error.what()) + "; see meniscus --help or meniscus SUBCOMMAND --help");
}

/// The one that the first word names, else all of them: their options take longer to make than to parse.
void add_subcommands(CLI::App& program, const std::string& first_word, Outcome& outcome) {
    struct Subcommand {
        std::string_view name;
        void (*add)(CLI::App&, Outcome&);
    };
    constexpr std::array kAll{Subcommand{"surface", meniscus::cli::add_surface_command},
                              Subcommand{"measure", meniscus::cli::add_measure_command},
                              Subcommand{"compare", meniscus::cli::add_compare_command},
                              Subcommand{"batch", meniscus::cli::add_batch_command}};
    const auto is_meant = [&](const Subcommand& command) { return command.name == first_word; };
    const bool adds_one = std::any_of(kAll.begin(), kAll.end(), is_meant);
    for (const Subcommand& command : kAll)
        if (!adds_one || is_meant(command)) command.add(program, outcome);
}

/// A first word that names no subcommand gets a clearer message than CLI11's.
void check_subcommand(const CLI::App& program, const std::vector<std::string>& arguments) {
    if (arguments.empty() || arguments.front().starts_with("-")) return;
    const auto is_meant = [&](const CLI::App* command) { return command->check_name(arguments.front()); };
    if (program.get_subcommands(is_meant).empty())
        throw meniscus::UsageError(meniscus::cli::explain_unknown_subcommand(arguments.front()));
}

int run(int argc, char** argv) {
    CLI::App program("Solvent-excluded surfaces of proteins and other molecules", "meniscus");
    program.formatter(std::make_shared<meniscus::cli::HelpFormatter>());
    program.set_help_flag("-h,--help", "This help, on one screen");
    program.set_help_all_flag("--help-all", "Every option in full");
    program.set_version_flag("--version", std::string("meniscus ") + meniscus::kVersion, "The version");
    program.require_subcommand(1);
    program.footer(kFooter);
    Outcome outcome = Outcome::Done;
    std::vector<std::string> arguments =
        meniscus::cli::join_negative_values(std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
    add_subcommands(program, arguments.empty() ? "" : arguments.front(), outcome);
    check_subcommand(program, arguments);
    std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
    try {
        program.parse(arguments);
    } catch (const CLI::ParseError& error) {
        return report_parse_error(program, error);
    }
    return outcome == Outcome::Done ? kDone : kChecksFailed;
}

/// The exit code.
int run_or_fail(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const meniscus::cli::Interrupted& interrupted) {
        return kSignalBase + interrupted.signal;
    } catch (const meniscus::UsageError& error) {
        return fail(kUsageError, error.what());
    } catch (const meniscus::InputError& error) {
        return fail(kInputError, error.what());
    } catch (const meniscus::OutputError& error) {
        return fail(kOutputError, error.what());
    } catch (const std::length_error& error) {
        return fail(kLimitError, error.what());
    } catch (const std::bad_alloc&) {
        return fail(kLimitError, "out of memory; keep fewer atoms or, for a surface, raise --spacing");
    } catch (const std::exception& error) {
        if (meniscus::cli::is_out_of_threads(error)) return fail(kLimitError, meniscus::cli::kOutOfThreads);
        return fail(kOtherError, error.what());
    }
}

/// Ends the program without taking apart what libraries hold, threads among it: the kernel takes it back all the same.
[[noreturn]] void leave(int code) {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    std::exit(code);  // they report at the end
#endif
    std::cout.flush();
    std::fflush(nullptr);
    std::_Exit(code);
}

}  // namespace

int main(int argc, char** argv) {
    meniscus::cli::prepare_heap();
    meniscus::cli::hold_standard_streams();
    meniscus::cli::install_signal_handlers();
    meniscus::cli::install_last_resort("meniscus");
    leave(run_or_fail(argc, argv));
}
