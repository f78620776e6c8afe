// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"

#if defined(__SANITIZE_THREAD__)
#include <atomic>
#include <future>
#else
#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#endif

namespace meniscus {
namespace {

#if defined(__SANITIZE_THREAD__)
// The thread sanitizer does not see how a TBB that was built without it hands work from one thread to another, and
// would take all of that for races: here threads are those of the standard library.
template <class First, class Second>
void invoke(const First& first, const Second& second) {
    auto other = std::async(std::launch::async, second);
    first();
    other.get();
}

// On two threads, which take chunks of `grain` in turn.
template <class Run>
void for_ranges(std::size_t n, std::size_t grain, const Run& run) {
    std::atomic<std::size_t> next{0};
    const auto work = [&] {
        for (std::size_t begin = 0; (begin = next.fetch_add(grain, std::memory_order_relaxed)) < n;)
            run(begin, std::min(begin + grain, n));
    };
    n > grain ? invoke(work, work) : work();
}
#else
template <class First, class Second>
void invoke(const First& first, const Second& second) {
    tbb::parallel_invoke(first, second);
}

template <class Run>
void for_ranges(std::size_t n, std::size_t grain, const Run& run) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain),
                      [&](const auto& range) { run(range.begin(), range.end()); });
}
#endif

}  // namespace

void parallel_ranges(std::size_t n, std::size_t grain, void (*run)(const void*, std::size_t, std::size_t),
                     const void* body) {
    if (is_alone()) {
        run(body, 0, n);
    } else {
        for_ranges(n, grain, [&](std::size_t begin, std::size_t end) { run(body, begin, end); });
    }
}

void parallel_both(void (*run_first)(const void*), const void* first, void (*run_second)(const void*),
                   const void* second) {
    if (is_alone()) {
        run_first(first);
        run_second(second);
    } else {
        invoke([&] { run_first(first); }, [&] { run_second(second); });
    }
}

}  // namespace meniscus
