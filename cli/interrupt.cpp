// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "interrupt.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>

#include "messages.h"
#include "platform/files/atomic_file.h"

namespace meniscus::cli {

namespace {

volatile std::sig_atomic_t writing = 0;
volatile std::sig_atomic_t pending = 0;

constexpr unsigned kSecondsToFinish = 2;  // what is being written; whoever reads a pipe may not take it at all

/// Outside a WritingSection no files belong together, so the end can come at once, however long the computation would
/// still run. A second signal does not wait.
extern "C" void on_signal(int number) {
    if (writing != 0 && pending == 0) {
        pending = number;
        alarm(kSecondsToFinish);
        return;
    }
    remove_temporary_files();
    if (isatty(STDERR_FILENO) == 1 && write(STDERR_FILENO, "\n", 1) < 0) _exit(1);
    _exit(128 + (number == SIGALRM ? pending : number));
}

const char* program_name = "meniscus";

/// Without memory: nothing is allocated here.
void say(const char* text) {
    if (write(STDERR_FILENO, text, std::strlen(text)) < 0) return;
}

[[noreturn]] void end_with(int code, const char* text) {
    remove_temporary_files();
    say(program_name);
    say(": error: ");
    say(text);
    say("\n");
    _exit(code);
}

[[noreturn]] void end_in_order() {
    try {
        if (const std::exception_ptr thrown = std::current_exception()) std::rethrow_exception(thrown);
    } catch (const std::bad_alloc&) {
        end_with(5, "out of memory; keep fewer atoms or, for a surface, raise --spacing");
    } catch (const std::exception& error) {
        if (is_out_of_threads(error)) end_with(5, kOutOfThreads);
        end_with(1, error.what());
    } catch (...) {
        end_with(1, "ended by an unknown error");
    }
    end_with(1, "ended by an error");
}

}  // namespace

void install_last_resort(const char* program) {
    program_name = program;
    std::set_terminate(end_in_order);
}

void install_signal_handlers() {
    struct sigaction action = {};
    action.sa_handler = on_signal;
    sigemptyset(&action.sa_mask);
    for (const int number : {SIGINT, SIGTERM, SIGALRM}) sigaction(number, &action, nullptr);
    struct sigaction inherited = {};
    sigaction(SIGHUP, nullptr, &inherited);
    if (inherited.sa_handler != SIG_IGN) sigaction(SIGHUP, &action, nullptr);  // nohup
    action.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &action, nullptr);
    sigaction(SIGXFSZ, &action, nullptr);
}

void hold_standard_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO})
        if (fcntl(stream, F_GETFD) < 0 && errno == EBADF)  // the lowest one free is this one
            open("/dev/null", stream == STDIN_FILENO ? O_WRONLY : O_RDONLY);
}

WritingSection::WritingSection() { writing = 1; }

WritingSection::~WritingSection() { writing = 0; }

void throw_if_interrupted() {
    if (pending != 0) throw Interrupted(pending);
}

}  // namespace meniscus::cli
