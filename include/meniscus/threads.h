// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How many threads the library may use.
#pragma once

#include <memory>

namespace meniscus {

/// Limits the threads of calls while it lives. Functions with an option `threads` do so for themselves; the least of
/// several limits holds. Results are the same for any.
///
/// A limit of one is that of the calls that its own thread makes; one of several threads is the whole process's, so
/// that calls which other threads make meanwhile have no more either.
class ThreadLimit {
public:
    /// threads   0 sets no limit: all cores. With 1 the calling thread does everything itself, and no other is started.
    explicit ThreadLimit(int threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    struct Control;
    std::unique_ptr<Control> control_;
};

/// Starts the threads that later calls of this one will use, while it does something else first, such as reading; it
/// does not wait for them. Nothing happens under a limit of one thread.
///
/// meanwhile   called by the first that begins, and not waited for: it must use nothing that ends, and return soon
///             after the other threads are needed
/// begin       called by each of them before anything else, and not waited for; neither may throw
///
/// The kernel of Linux may begin a thread on the processor of the one that starts it and leave both there for 30 ms:
/// such a thread is moved to another processor that it may use (docs/design/performance.md).
///
/// throws   std::bad_alloc without memory for them, and what the thread library does where no thread can be started
void start_threads(
    void (*meanwhile)() = [] {}, void (*begin)() = [] {});

}  // namespace meniscus
