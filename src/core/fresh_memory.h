// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Large arrays whose memory is taken by all threads. The kernel clears a page when it is touched for the first time,
// which costs more than filling it: one thread alone takes memory at 2 GB/s.
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "core/parallel.h"

namespace meniscus {

/// As vector.reserve(size), with the pages of what is not used yet touched. Threads that
/// come to the same huge page would each have it cleared: the beginning of each is touched before all the rest.
template <class T, class Allocator>
void reserve_touched(std::vector<T, Allocator>& vector, std::size_t size) {
    constexpr std::size_t kPage = 4096;
    constexpr std::size_t kPagesPerHugePage = 512;
    constexpr std::size_t kPagesPerChunk = 64;
    vector.reserve(size);
    auto* const begin = reinterpret_cast<volatile std::byte*>(vector.data() + vector.size());
    const std::size_t pages = (vector.capacity() - vector.size()) * sizeof(T) / kPage;
    const auto touch = [&](std::size_t page) { begin[page * kPage] = std::byte{}; };
    parallel_for((pages + kPagesPerHugePage - 1) / kPagesPerHugePage, 1,
                 [&](std::size_t huge_page) { touch(huge_page * kPagesPerHugePage); });
    parallel_for(pages, kPagesPerChunk, touch);
}

/// As vector.resize(size).
template <class T, class Allocator>
void resize_touched(std::vector<T, Allocator>& vector, std::size_t size) {
    reserve_touched(vector, size);
    vector.resize(size);
}

/// The same for several at once, which are set to zero side by side.
template <class... Vectors>
void resize_all_touched(std::size_t size, Vectors&... vectors) {
    (reserve_touched(vectors, size), ...);
    const std::array<std::function<void()>, sizeof...(Vectors)> resize{[&] { vectors.resize(size); }...};
    parallel_for(resize.size(), 1, [&](std::size_t i) { resize[i](); });
}

}  // namespace meniscus
