// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "heap.h"

#include <cstdlib>  // tells whether this is glibc

// Sanitizers have heaps of their own.
#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define MENISCUS_HEAP_OF_GLIBC
#endif

#ifdef MENISCUS_HEAP_OF_GLIBC
#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <fstream>
#include <limits>
#endif

namespace meniscus::cli {

#ifdef MENISCUS_HEAP_OF_GLIBC
namespace {

constexpr std::size_t kHugePage = std::size_t{1} << 21U;

// A page costs 0.5 to 2 µs where the processor keeps the page tables of virtual machines, too, and 8 to 11 µs where
// their host does.
constexpr double kDearPage = 4e-6;  // seconds

void keep_freed_memory() {
    mallopt(M_MMAP_MAX, 0);
    mallopt(M_TRIM_THRESHOLD, -1);  // never
    mallopt(M_TOP_PAD, 1 << 24);
}

std::size_t page_size() { return static_cast<std::size_t>(sysconf(_SC_PAGESIZE)); }

// What it takes to touch a page for the first time, the least of several: others may have been interrupted.
double seconds_per_page() {
    constexpr std::size_t kPages = 8;
    const std::size_t size = page_size();
    void* const memory = mmap(nullptr, kPages * size, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) return 0.0;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t page = 0; page < kPages; ++page) {
        const auto start = std::chrono::steady_clock::now();
        *static_cast<volatile char*>(static_cast<char*>(memory) + page * size) = 1;
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - start;
        least = std::min(least, time.count());
    }
    munmap(memory, kPages * size);
    return least;
}

// By `ulimit -v`, or by a kernel that promises nobody more than it has.
bool are_addresses_limited() {
    rlimit limit{};
    if (getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur != RLIM_INFINITY) return true;
    constexpr int kNeverOvercommit = 2;
    int policy = kNeverOvercommit;
    return !(std::ifstream("/proc/sys/vm/overcommit_memory") >> policy) || policy == kNeverOvercommit;
}

// Addresses for half of the machine's memory, which nothing is behind until it is used. glibc has no other way to ask
// for huge pages from within (its tunable hugetlb is read before main()).
void reserve_huge_pages() {
    const std::size_t size = page_size() * static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES)) / 2;
    void* const memory = std::malloc(size);
    if (memory == nullptr) return;
    const auto begin = reinterpret_cast<std::uintptr_t>(memory);
    const std::uintptr_t first = (begin + kHugePage - 1) / kHugePage * kHugePage;
    if (first >= begin + size) return std::free(memory);
    madvise(reinterpret_cast<void*>(first), begin + size - first, MADV_HUGEPAGE);
    std::free(memory);
    // What lies before the first huge page is taken away, so that nothing lands there on small ones. Nobody frees it.
    [[maybe_unused]] static void* volatile before;  // volatile: what is never used need not be taken
    before = std::malloc(first - begin);
}

}  // namespace

void prepare_heap() {
    keep_freed_memory();
    if (seconds_per_page() > kDearPage && !are_addresses_limited()) reserve_huge_pages();
}
#else
void prepare_heap() {}
#endif

}  // namespace meniscus::cli
