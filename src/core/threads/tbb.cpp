// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Threads by oneTBB.
#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>
#include <tbb/task_scheduler_observer.h>

#include <atomic>
#include <utility>

#include "core/threads/backend.h"

#ifdef __linux__
#include <sched.h>
#endif

namespace meniscus::threads {
namespace {

#ifdef __linux__
int this_processor() { return sched_getcpu(); }

// Moves this thread to another of the processors it may use, if there is one. Which it may use stays as it was.
void leave(int processor) {
    cpu_set_t allowed;
    if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;
    cpu_set_t others = allowed;
    CPU_CLR(static_cast<std::size_t>(processor), &others);
    if (CPU_COUNT(&others) == 0 || sched_setaffinity(0, sizeof others, &others) != 0) return;
    sched_setaffinity(0, sizeof allowed, &allowed);
}
#else
int this_processor() { return -1; }
void leave(int /*processor*/) {}
#endif

// Sees threads begin, tells so, and sends those elsewhere that share the processor of the one that started them.
class Beginnings : public tbb::task_scheduler_observer {
public:
    explicit Beginnings(int processor) : processor_(processor) {}

    void tell(void (*begin)()) { begin_ = begin; }

    void on_scheduler_entry(bool is_worker) override {
        thread_local bool is_new = true;  // later both may long have moved
        if (!is_worker || !std::exchange(is_new, false)) return;
        if (processor_ >= 0 && this_processor() == processor_) leave(processor_);
        begin_.load()();
    }

private:
    int processor_;
    std::atomic<void (*)()> begin_;
};

}  // namespace

void for_ranges(std::size_t n, std::size_t grain, void (*run)(const void*, std::size_t, std::size_t),
                const void* body) {
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain),
                      [&](const auto& range) { run(body, range.begin(), range.end()); });
}

void isolated(void (*run)(const void*), const void* work) {
    tbb::this_task_arena::isolate([&] { run(work); });
}

struct Limit::Control {
    tbb::global_control limit;
};

Limit::Limit(int threads)
    : control_(new Control{{tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads)}}) {}

Limit::~Limit() = default;

void start(void (*meanwhile)(), void (*begin)()) {
    // Never destroyed: threads may begin after this call, and the library's destructor fails if observe() ran out of
    // memory.
    static auto& beginnings = *new Beginnings(this_processor());
    beginnings.tell(begin);
    beginnings.observe(true);
    tbb::this_task_arena::enqueue(meanwhile);
}

}  // namespace meniscus::threads
