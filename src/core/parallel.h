// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Loops and sums whose results do not depend on the threads.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace meniscus {

/// Whether a ThreadLimit of this thread allows no other. It then does everything itself: the thread library would load
/// three more and start a second thread before its first loop, which takes longer than many a small surface.
bool is_alone();

/// Calls run(body, begin, end) for ranges that make up [0, n), in any order; none of `grain` or less is divided
/// further.
void parallel_ranges(std::size_t n, std::size_t grain, void (*run)(const void*, std::size_t, std::size_t),
                     const void* body);

/// Calls run(work) as threads::isolated() does.
void run_isolated(void (*run)(const void*), const void* work);

/// Calls work(), which may have loops, under a lock: this thread takes up nothing meanwhile that may want the lock,
/// too.
template <class Work>
void isolated(const Work& work) {
    run_isolated([](const void* any) { (*static_cast<const Work*>(any))(); }, &work);
}

/// Calls body(i) for i in [0, n), in any order, in ranges of which none of `grain` or less is divided further.
template <class Body>
void parallel_for(std::size_t n, std::size_t grain, const Body& body) {
    const auto run = [](const void* any, std::size_t begin, std::size_t end) {
        const auto& each = *static_cast<const Body*>(any);
        for (std::size_t i = begin; i < end; ++i) each(i);
    };
    parallel_ranges(n, grain, run, &body);
}

/// Calls body(begin, end) for fixed chunks of [0, n): the same chunks for any number of threads.
template <class Body>
void parallel_chunks(std::size_t n, std::size_t chunk, const Body& body) {
    parallel_for((n + chunk - 1) / chunk, 1, [&](std::size_t c) { body(c * chunk, std::min(n, (c + 1) * chunk)); });
}

/// Calls both, in any order or at once. The calling thread begins with the second: freed memory stays with the thread
/// that had it, and the other way round the flow of 1AON had a peak 13 % higher.
template <class First, class Second>
void parallel_both(const First& first, const Second& second) {
    parallel_for(2, 1, [&](std::size_t which) { which == 0 ? second() : first(); });
}

/// Sum of term(begin, end) over fixed chunks, added in their order: the same bits for any number of threads.
template <class T, class Term>
T parallel_sum(std::size_t n, std::size_t chunk, const Term& term) {
    std::vector<T> partial((n + chunk - 1) / chunk);
    parallel_chunks(n, chunk, [&](std::size_t begin, std::size_t end) { partial[begin / chunk] = term(begin, end); });
    T sum{};
    for (const T& p : partial) sum += p;
    return sum;
}

/// Whether test(item) holds for any of the items, which it is called for in any order, but not for all if so.
template <class Items, class Test>
bool parallel_any_of(const Items& items, const Test& test) {
    constexpr std::size_t kChunk = std::size_t{1} << 14U;  // items that take next to nothing
    return parallel_sum<std::size_t>(items.size(), kChunk, [&](std::size_t begin, std::size_t end) {
               const auto at = [&](std::size_t i) { return items.begin() + static_cast<std::ptrdiff_t>(i); };
               return std::any_of(at(begin), at(end), test) ? std::size_t{1} : std::size_t{0};
           }) > 0;
}

}  // namespace meniscus
