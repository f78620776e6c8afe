// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// SIGINT and SIGTERM end the program with 130 and 143 and leave no temporary file behind.
#pragma once

#include <exception>

namespace meniscus::cli {

/// A signal that arrived while files were being written.
struct Interrupted : std::exception {
    explicit Interrupted(int number) : signal(number) {}
    const char* what() const noexcept override { return "interrupted"; }
    int signal;
};

/// From now on SIGINT, SIGTERM and SIGHUP end the program at once with 128 + the signal's number and remove temporary
/// files, except inside a WritingSection, where the first one waits for two seconds. SIGPIPE and SIGXFSZ are ignored: a
/// reader that goes away, or a file larger than it may become, is an output that cannot be written.
void install_signal_handlers();

/// What ends the program where nothing can be caught, in a thread of a loop or while it unwinds, ends it in order: one
/// line on standard error, temporary files removed, exit code 5 for want of memory or threads and 1 otherwise.
///
/// program   its name, for the message; must live as long as the program
void install_last_resort(const char* program);

/// Gives closed standard streams a descriptor that cannot be used, or the next file opened would take the place and
/// receive what is meant for the stream.
void hold_standard_streams();

/// While one lives, a signal waits: files that belong together get their turn to be finished.
class WritingSection {
public:
    WritingSection();
    ~WritingSection();
    WritingSection(const WritingSection&) = delete;
    WritingSection& operator=(const WritingSection&) = delete;
};

/// throws   Interrupted if a signal has arrived in a WritingSection
void throw_if_interrupted();

}  // namespace meniscus::cli
