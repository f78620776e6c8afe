// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Loops and sums whose results do not depend on the threads. This file, thread_limit.cpp and start_threads.cpp
// alone name the thread library.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include "meniscus/threads.h"

#if defined(__SANITIZE_THREAD__)
#include "core/plain_threads.h"
#endif

namespace meniscus {

/// Whether a ThreadLimit of this thread allows no other. It then does everything itself: the thread library would load
/// three more and start a second thread before its first loop, which takes longer than many a small surface.
bool is_alone();

/// Limits what else runs on the thread library to one thread while it lives.
class LibraryOnOneThread {
    tbb::global_control control_{tbb::global_control::max_allowed_parallelism, 1};
};

/// Calls body(i) for i in [0, n), in any order, in chunks of at least `grain`.
template <class Body>
void parallel_for(std::size_t n, std::size_t grain, const Body& body) {
    if (is_alone()) {
        for (std::size_t i = 0; i < n; ++i) body(i);
        return;
    }
#if defined(__SANITIZE_THREAD__)
    plain::for_each(n, grain, body);
#else
    tbb::parallel_for(tbb::blocked_range<std::size_t>(0, n, grain), [&](const auto& range) {
        for (std::size_t i = range.begin(); i != range.end(); ++i) body(i);
    });
#endif
}

/// Calls body(begin, end) for fixed chunks of [0, n): the same chunks for any number of threads.
template <class Body>
void parallel_chunks(std::size_t n, std::size_t chunk, const Body& body) {
    parallel_for((n + chunk - 1) / chunk, 1, [&](std::size_t c) { body(c * chunk, std::min(n, (c + 1) * chunk)); });
}

/// Calls both, in any order or at once.
template <class First, class Second>
void parallel_both(const First& first, const Second& second) {
    if (is_alone()) {
        first();
        second();
        return;
    }
#if defined(__SANITIZE_THREAD__)
    plain::invoke(first, second);
#else
    tbb::parallel_invoke(first, second);
#endif
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
template <class Item, class Test>
bool parallel_any_of(const std::vector<Item>& items, const Test& test) {
    constexpr std::size_t kChunk = std::size_t{1} << 14U;  // items that take next to nothing
    return parallel_sum<std::size_t>(items.size(), kChunk, [&](std::size_t begin, std::size_t end) {
               const auto at = [&](std::size_t i) { return items.begin() + static_cast<std::ptrdiff_t>(i); };
               return std::any_of(at(begin), at(end), test) ? std::size_t{1} : std::size_t{0};
           }) > 0;
}

}  // namespace meniscus
