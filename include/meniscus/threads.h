// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How many threads the library may use.
#pragma once

#include <memory>

namespace meniscus {

/// Limits the threads of every call that its own thread makes while it lives. Functions with an option `threads` do so
/// for themselves; the least of several limits holds. Results are the same for any.
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

}  // namespace meniscus
