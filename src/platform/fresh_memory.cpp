// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "platform/fresh_memory.h"

#include <algorithm>
#include <cstdint>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace meniscus {
namespace {

constexpr std::size_t kPage = 4096;
constexpr std::size_t kHugePage = 512 * kPage;

// Asks for all pages in one call; false where the kernel knows none. One fault each would take a third longer.
bool ask_for([[maybe_unused]] std::byte* begin, [[maybe_unused]] std::size_t size) {
#ifdef MADV_POPULATE_WRITE
    return madvise(begin, size, MADV_POPULATE_WRITE) == 0;
#else
    return false;
#endif
}

void touch(std::byte* begin, std::size_t size) {
    if (ask_for(begin, size)) return;
    volatile std::byte* const memory = begin;
    for (std::size_t at = 0; at < size; at += kPage) memory[at] = std::byte{};
}

// The first place from here on that a size divides.
std::byte* aligned(std::byte* place, std::size_t size) {
    return place + (size - reinterpret_cast<std::uintptr_t>(place) % size) % size;
}

}  // namespace

// Threads that came to the same huge page would each have it cleared: every one is touched by one of them.
void touch_pages(std::byte* begin, std::size_t size) {
    std::byte* const first = aligned(begin, kPage);
    std::byte* const end = begin + size;
    if (end < first + kPage) return;
    const std::size_t whole = static_cast<std::size_t>(end - first) / kPage * kPage;
    std::byte* const next_huge_page = aligned(first + 1, kHugePage);
    const std::size_t before = std::min(whole, static_cast<std::size_t>(next_huge_page - first));
    parallel_for(1 + (whole - before + kHugePage - 1) / kHugePage, 1, [&](std::size_t i) {
        const std::size_t from = i == 0 ? 0 : before + (i - 1) * kHugePage;
        const std::size_t to = std::min(whole, before + i * kHugePage);
        touch(first + from, to - from);
    });
}

}  // namespace meniscus
