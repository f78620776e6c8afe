// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"

#include "core/threads/backend.h"
#include "meniscus/threads.h"

namespace meniscus {
namespace {

thread_local int alone = 0;  // limits of one thread that live

}  // namespace

bool is_alone() { return alone > 0; }

void parallel_ranges(std::size_t n, std::size_t grain, void (*run)(const void*, std::size_t, std::size_t),
                     const void* body) {
    is_alone() ? run(body, 0, n) : threads::for_ranges(n, grain, run, body);
}

void run_isolated(void (*run)(const void*), const void* work) { is_alone() ? run(work) : threads::isolated(run, work); }

// A thread library's own limit may take memory from an allocator that is loaded with the first of them: one thread
// alone does without.
struct ThreadLimit::Control {
    explicit Control(int threads) {
        if (threads == 1)
            ++alone;
        else
            limit = std::make_unique<threads::Limit>(threads);
    }
    ~Control() {
        if (limit == nullptr) --alone;
    }
    Control(const Control&) = delete;
    Control& operator=(const Control&) = delete;

    std::unique_ptr<threads::Limit> limit;
};

ThreadLimit::ThreadLimit(int threads) : control_(threads > 0 ? std::make_unique<Control>(threads) : nullptr) {}

ThreadLimit::~ThreadLimit() = default;

void start_threads(void (*meanwhile)(), void (*begin)()) {
    if (!is_alone()) threads::start(meanwhile, begin);
}

}  // namespace meniscus
