// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What a thread library has to offer. One of tbb.cpp, standard.cpp and none.cpp is built (CMake's MENISCUS_THREADS).
#pragma once

#include <cstddef>
#include <memory>

namespace meniscus::threads {

/// Calls run(body, begin, end) for ranges that make up [0, n), in any order and at once; none of `grain` or less is
/// divided further. The first exception that is thrown is thrown on once all that has begun has ended.
void for_ranges(std::size_t n, std::size_t grain, void (*run)(const void*, std::size_t, std::size_t), const void* body);

/// Calls run(work). While loops within it wait for other threads, this one takes up nothing that began outside: what is
/// done under a lock may otherwise meet that lock again.
void isolated(void (*run)(const void*), const void* work);

/// Limits for_ranges() of the whole process to so many threads, at least two, while it lives.
class Limit {
public:
    explicit Limit(int threads);
    ~Limit();
    Limit(const Limit&) = delete;
    Limit& operator=(const Limit&) = delete;

private:
    struct Control;
    std::unique_ptr<Control> control_;
};

/// As meniscus::start_threads(), which calls it where there is more than one thread.
void start(void (*meanwhile)(), void (*begin)());

}  // namespace meniscus::threads
