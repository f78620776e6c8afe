// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Large arrays whose memory is taken by all threads. The kernel clears a page when it is touched for the first time,
// which costs more than filling it: one thread alone takes memory at 2 GB/s.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <vector>

#include "core/parallel.h"

namespace meniscus {

/// Touches the whole pages of memory that holds nothing yet: what they hold afterwards is not said.
void touch_pages(std::byte* begin, std::size_t size);

/// Room for a few more than so many: a handful that is added later would else move all of them, into twice the room.
constexpr std::size_t with_spare(std::size_t size) { return size + size / 1024 + 64; }

/// As vector.reserve(size), with the pages touched of what is not used yet among the first `likely` of that room.
template <class T, class Allocator>
void reserve_touched(std::vector<T, Allocator>& vector, std::size_t size, std::size_t likely) {
    vector.reserve(size);
    likely = std::min(likely, vector.capacity());
    if (likely <= vector.size()) return;
    touch_pages(reinterpret_cast<std::byte*>(vector.data() + vector.size()), (likely - vector.size()) * sizeof(T));
}

/// The same of all that there is room for.
template <class T, class Allocator>
void reserve_touched(std::vector<T, Allocator>& vector, std::size_t size) {
    reserve_touched(vector, size, std::max(size, vector.capacity()));
}

/// As vector.resize(size), with room to spare.
template <class T, class Allocator>
void resize_touched(std::vector<T, Allocator>& vector, std::size_t size) {
    reserve_touched(vector, with_spare(size));
    vector.resize(size);
}

/// The same for several at once, which are set to zero side by side.
template <class... Vectors>
void resize_all_touched(std::size_t size, Vectors&... vectors) {
    (reserve_touched(vectors, with_spare(size)), ...);
    const std::array<std::function<void()>, sizeof...(Vectors)> resize{[&] { vectors.resize(size); }...};
    parallel_for(resize.size(), 1, [&](std::size_t i) { resize[i](); });
}

}  // namespace meniscus
