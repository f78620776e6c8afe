// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A program started with limits of its own, whose end and messages are waited for with others.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "batch/descriptor.h"

namespace meniscus::cli::batch {

struct ProcessLimits {
    std::size_t memory_mb = 0;  ///< of its address space, in units of 2^20 bytes; 0 for none
    double seconds = 0.0;       ///< of wall clock; 0 for none
};

/// How a process ended.
struct ProcessEnd {
    int exit_code = 0;       ///< if no signal ended it
    int signal = 0;          ///< that ended it, or 0
    bool timed_out = false;  ///< it was ended because it took longer than it may
    double wall_seconds = 0.0;
    double cpu_seconds = 0.0;
    std::string messages;  ///< the last of what it wrote to standard error
};

/// One running program. Its standard input and output are empty; it ends with this process, however that ends, and with
/// its Process.
class Process {
public:
    /// words   the program's path and its arguments
    /// throws  std::system_error when it cannot be started
    Process(const std::vector<std::string>& words, const ProcessLimits& limits);
    ~Process();
    Process(Process&&) noexcept;
    Process& operator=(Process&&) = delete;

    /// Waits until something happens to one of the processes, a signal arrives, or `seconds` have passed.
    static void wait_for_any(const std::vector<Process*>& processes, double seconds);

    /// Takes what it has written; its end, if it has ended. A process beyond its time is ended here.
    std::optional<ProcessEnd> poll();

private:
    using Clock = std::chrono::steady_clock;

    void read_messages();
    double seconds_left() const;

    pid_t id_ = -1;
    Descriptor handle_;  // can be read when the process has ended
    Descriptor errors_;
    ProcessLimits limits_;
    Clock::time_point start_ = Clock::now();
    bool timed_out_ = false;
    std::string messages_;
};

}  // namespace meniscus::cli::batch
