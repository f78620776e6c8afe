// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Large arrays whose memory is taken by all threads. The kernel clears a page when it is touched for the first time,
// which costs more than filling it: one thread alone takes memory at 2 GB/s.
#pragma once

#include <cstddef>
#include <vector>

#include "core/parallel.h"

namespace meniscus {

/// As vector.reserve(size), with the pages of what is not used yet touched.
template <class T, class Allocator>
void reserve_touched(std::vector<T, Allocator>& vector, std::size_t size) {
    constexpr std::size_t kPage = 4096;
    constexpr std::size_t kPagesPerChunk = 64;
    vector.reserve(size);
    auto* const begin = reinterpret_cast<volatile std::byte*>(vector.data() + vector.size());
    const std::size_t bytes = (vector.capacity() - vector.size()) * sizeof(T);
    parallel_for(bytes / kPage, kPagesPerChunk, [&](std::size_t page) { begin[page * kPage] = std::byte{}; });
}

/// As vector.resize(size).
template <class T, class Allocator>
void resize_touched(std::vector<T, Allocator>& vector, std::size_t size) {
    reserve_touched(vector, size);
    vector.resize(size);
}

}  // namespace meniscus
