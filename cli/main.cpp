// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The program `meniscus`: parses the command line and turns what went wrong into exit codes.
#include <CLI/App.hpp>
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <new>
#include <string>
#include <vector>

#include "explain_parse_error.h"
#include "heap.h"
#include "interrupt.h"
#include "meniscus/errors.h"
#include "messages.h"
#include "program.h"
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
    const bool lacks_something = dynamic_cast<const CLI::RequiredError*>(&error) != nullptr;
    const bool has_words_left = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                                (lacks_something && meniscus::cli::has_unknown_options(program));
    if (!has_words_left) return fail(kUsageError, meniscus::cli::explain_parse_error(program, error));
    Outcome ignored = Outcome::Done;
    const auto whole = meniscus::cli::make_program("", ignored);
    return fail(kUsageError, meniscus::cli::explain_unknown_words(program, *whole));
}

int run(int argc, char** argv) {
    const std::vector<std::string> given(argv + std::min(argc, 1), argv + argc);
    if (meniscus::cli::print_made_page(given)) return kDone;
    std::vector<std::string> words = meniscus::cli::prepare_words(given);
    Outcome outcome = Outcome::Done;
    const auto program = meniscus::cli::make_program(words.empty() ? "" : words.front(), outcome);
    meniscus::cli::check_words(*program, words);
    std::reverse(words.begin(), words.end());  // CLI11 takes them from the back
    try {
        program->parse(words);
    } catch (const CLI::ParseError& error) {
        return report_parse_error(*program, error);
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
