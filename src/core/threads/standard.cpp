// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Threads of the standard library. Whoever has a loop works on it until nothing of it is left, and idle threads join
// in: nobody waits for work that no thread has begun, so that loops within loops cannot block each other.
#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <exception>
#include <list>
#include <mutex>
#include <set>
#include <system_error>
#include <thread>
#include <utility>

#include "core/threads/backend.h"

namespace meniscus::threads {
namespace {

// A loop in progress, whose ranges whoever is free takes in turn.
class Loop {
public:
    Loop(std::size_t n, std::size_t grain, void (*run)(const void*, std::size_t, std::size_t), const void* body)
        : n_(n), grain_(grain), run_(run), body_(body) {}

    bool has_more() const { return next_.load(std::memory_order_relaxed) < n_; }

    void work() {
        for (std::size_t begin = 0; (begin = next_.fetch_add(grain_, std::memory_order_relaxed)) < n_;) {
            try {
                run_(body_, begin, std::min(begin + grain_, n_));
            } catch (...) {
                next_ = n_;
                const std::scoped_lock lock(mutex_);
                if (!failure_) failure_ = std::current_exception();
            }
        }
    }

    void rethrow() const {
        if (failure_) std::rethrow_exception(failure_);
    }

    int helpers = 0;  // at work on it; of the crew's mutex

private:
    std::size_t n_;
    std::size_t grain_;
    void (*run_)(const void*, std::size_t, std::size_t);
    const void* body_;
    std::atomic<std::size_t> next_{0};
    std::mutex mutex_;
    std::exception_ptr failure_;
};

// All threads but the callers'.
class Crew {
public:
    void run(Loop& loop) {
        {
            const std::scoped_lock lock(mutex_);
            hire(0, [] {});
            loops_.push_back(&loop);
        }
        wake_.notify_all();
        loop.work();
        std::unique_lock lock(mutex_);
        loops_.remove(&loop);
        done_.wait(lock, [&] { return loop.helpers == 0; });
        loop.rethrow();
    }

    /// Starts the threads before there is work. Each calls begin() first, and one of them meanwhile().
    void start(void (*meanwhile)(), void (*begin)()) {
        const std::scoped_lock lock(mutex_);
        meanwhile_ = meanwhile;
        hire(1, begin);
        wake_.notify_one();
    }

    void limit(int threads) {
        const std::scoped_lock lock(mutex_);
        limits_.insert(threads);
    }
    void lift(int threads) {
        const std::scoped_lock lock(mutex_);
        limits_.erase(limits_.find(threads));
    }

private:
    int most_helpers() const {
        const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
        return (limits_.empty() ? cores : std::min(cores, *limits_.begin())) - 1;
    }

    void hire(int at_least, void (*begin)()) {
        const auto work = [this, begin] {
            begin();
            serve();
        };
        try {
            for (const int wanted = std::max(at_least, most_helpers()); hired_ < wanted; ++hired_)
                std::thread(work).detach();
        } catch (const std::system_error&) {  // the system has no more: those that are there do it
        }
    }

    [[noreturn]] void serve() {
        std::unique_lock lock(mutex_);
        for (;;) {
            Loop* loop = nullptr;
            wake_.wait(lock, [&] { return meanwhile_ != nullptr || (loop = find_work()) != nullptr; });
            if (loop == nullptr) {
                void (*const meanwhile)() = std::exchange(meanwhile_, nullptr);
                lock.unlock();
                meanwhile();
                lock.lock();
                continue;
            }
            ++loop->helpers;
            ++busy_;
            lock.unlock();
            loop->work();
            lock.lock();
            --busy_;
            --loop->helpers;
            done_.notify_all();
        }
    }

    Loop* find_work() const {
        if (busy_ >= most_helpers()) return nullptr;
        const auto found =
            std::find_if(loops_.begin(), loops_.end(), [](const Loop* loop) { return loop->has_more(); });
        return found == loops_.end() ? nullptr : *found;
    }

    std::mutex mutex_;
    std::condition_variable wake_;
    std::condition_variable done_;
    std::list<Loop*> loops_;
    std::multiset<int> limits_;
    void (*meanwhile_)() = nullptr;
    int hired_ = 0;
    int busy_ = 0;  // helpers at work
};

// Never destroyed: its threads may still look for work when the program ends.
Crew& crew() {
    static auto& all = *new Crew;
    return all;
}

}  // namespace

void for_ranges(std::size_t n, std::size_t grain, void (*run)(const void*, std::size_t, std::size_t),
                const void* body) {
    if (n <= grain) return run(body, 0, n);
    Loop loop(n, grain, run, body);
    crew().run(loop);
}

void isolated(void (*run)(const void*), const void* work) { run(work); }

struct Limit::Control {
    int threads;
};

Limit::Limit(int threads) : control_(new Control{threads}) { crew().limit(threads); }
Limit::~Limit() { crew().lift(control_->threads); }

void start(void (*meanwhile)(), void (*begin)()) { crew().start(meanwhile, begin); }

}  // namespace meniscus::threads
