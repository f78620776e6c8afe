// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "interrupt.h"

#include <unistd.h>

#include <csignal>

namespace meniscus::cli {

namespace {

volatile std::sig_atomic_t writing = 0;
volatile std::sig_atomic_t pending = 0;

/// Outside a WritingSection nothing is open that would have to be removed, so the end can come at once, however
/// long the computation would still run. A second signal does not wait.
extern "C" void on_signal(int number) {
    if (writing == 0 || pending != 0) {
        if (isatty(STDERR_FILENO) == 1 && write(STDERR_FILENO, "\n", 1) < 0) _exit(1);
        _exit(128 + number);
    }
    pending = number;
}

}  // namespace

void install_signal_handlers() {
    struct sigaction action = {};
    action.sa_handler = on_signal;
    sigemptyset(&action.sa_mask);
    sigaction(SIGINT, &action, nullptr);
    sigaction(SIGTERM, &action, nullptr);
    action.sa_handler = SIG_IGN;
    sigaction(SIGPIPE, &action, nullptr);
}

WritingSection::WritingSection() { writing = 1; }

WritingSection::~WritingSection() { writing = 0; }

void throw_if_interrupted() {
    if (pending != 0) throw Interrupted(pending);
}

}  // namespace meniscus::cli
