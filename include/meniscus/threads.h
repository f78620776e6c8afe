// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How many threads the library may use.
#pragma once

#include <memory>

namespace meniscus {

/// Limits the number of threads of calls made while this object lives. Functions with an option `threads` set such a
/// limit themselves; the smallest limit holds. Results do not depend on it.
///
/// A limit of one thread applies to calls from the thread that made the object, a larger one to the whole process.
class ThreadLimit {
public:
    /// threads   0: no limit, all cores; 1: the calling thread does everything itself, and no other thread is started.
    explicit ThreadLimit(int threads);
    ~ThreadLimit();
    ThreadLimit(const ThreadLimit&) = delete;
    ThreadLimit& operator=(const ThreadLimit&) = delete;

private:
    struct Control;
    std::unique_ptr<Control> control_;
};

/// Starts the threads that later calls will use and returns at once, so that the caller can do something else
/// meanwhile, such as reading. Nothing happens under a limit of one thread.
///
/// meanwhile   work for the first thread that begins. It must not throw, must use only objects that live until the
///             process ends, and must return soon after the threads are needed
/// begin       called on each new thread before anything else; must not throw
///
/// Linux may begin a thread on the processor of its parent and leave both there for 30 ms: such a thread is moved to
/// another processor that the process may use (docs/design/performance.md).
///
/// throws   std::bad_alloc, and whatever the thread library throws where no thread can be started
void start_threads(
    void (*meanwhile)() = [] {}, void (*begin)() = [] {});

}  // namespace meniscus
