// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What parallel.h and start_threads() do, on the threads of the standard library, for builds with the thread sanitizer:
// it does not see how a TBB that was built without it hands work from one thread to another, and would take all of that
// for races.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <future>
#include <thread>

namespace meniscus::plain {

/// Calls both at once.
template <class First, class Second>
void invoke(const First& first, const Second& second) {
    auto other = std::async(std::launch::async, second);
    first();
    other.get();
}

/// Calls it on a thread that nobody waits for.
inline void enqueue(void (*task)()) { std::thread(task).detach(); }

/// Calls body(i) for i in [0, n) on two threads, which take chunks of `grain` in turn.
template <class Body>
void for_each(std::size_t n, std::size_t grain, const Body& body) {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t begin = 0; (begin = next.fetch_add(grain, std::memory_order_relaxed)) < n;)
            for (std::size_t i = begin; i < std::min(begin + grain, n); ++i) body(i);
    };
    n > grain ? invoke(work, work) : work();
}

}  // namespace meniscus::plain
