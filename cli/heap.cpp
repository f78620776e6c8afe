// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "heap.h"

#include <atomic>
#include <condition_variable>
#include <cstdlib>  // tells whether this is glibc
#include <mutex>

#include "meniscus/threads.h"

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
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <limits>
#endif

namespace meniscus::cli {
namespace {

std::mutex mutex;
std::condition_variable has_ended;  // a WarmStart
std::atomic<bool> is_warming = false;

#ifdef MENISCUS_HEAP_OF_GLIBC
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

// Addresses for so much on the heap of this thread, which nothing is behind until it is used. glibc has no other way to
// ask for huge pages from within (its tunable hugetlb is read before main()).
void reserve_huge_pages(std::size_t size) {
    void* const memory = std::malloc(size);
    const std::size_t before = -reinterpret_cast<std::uintptr_t>(memory) % kHugePage;  // the first huge page
    if (memory == nullptr || before >= size) return std::free(memory);
    madvise(static_cast<char*>(memory) + before, size - before, MADV_HUGEPAGE);
    std::free(memory);
    // What lies before the first huge page is taken away for good, so that nothing lands there on small ones.
    static std::atomic<void*> taken;  // the compiler may not leave it out
    taken = std::malloc(before);
}

bool pages_are_dear = false;

std::byte* beginning = nullptr;  // of what had no use when the program began, a whole page

void prepare_heap_of_thread() {
    constexpr std::size_t kMostOfHeap = std::size_t{48} << 20U;  // glibc gives it 64 MiB at first
    if (pages_are_dear) reserve_huge_pages(kMostOfHeap);
}

// What the heap has not grown to yet the kernel refuses: it is waited for, longer and longer, as input may be slow.
void touch_heap() {
#ifdef MADV_POPULATE_WRITE
    constexpr std::size_t kStep = 1 << 17;
    constexpr auto kFirstWait = std::chrono::microseconds(50);
    auto wait = kFirstWait;
    if (pages_are_dear || beginning == nullptr) return;
    for (std::byte* next = beginning; is_warming;) {
        if (madvise(next, kStep, MADV_POPULATE_WRITE) == 0) {
            next += kStep;
            wait = kFirstWait;
        } else if (errno == ENOMEM) {
            std::unique_lock lock(mutex);
            has_ended.wait_for(lock, wait, [] { return !is_warming; });
            wait *= 2;
        } else {
            return;  // not known to this kernel
        }
    }
#endif
}

void prepare() {
    keep_freed_memory();
    beginning = static_cast<std::byte*>(sbrk(0));
    beginning += -reinterpret_cast<std::uintptr_t>(beginning) % page_size();
    pages_are_dear = seconds_per_page() > kDearPage && !are_addresses_limited();
    if (!pages_are_dear) return;
    const std::size_t memory = page_size() * static_cast<std::size_t>(sysconf(_SC_PHYS_PAGES));
    reserve_huge_pages(memory / 2);
}
#else
void prepare() {}
void prepare_heap_of_thread() {}
void touch_heap() {}
#endif

}  // namespace

void prepare_heap() { prepare(); }

WarmStart::WarmStart() {
    is_warming = true;
    start_threads(touch_heap, prepare_heap_of_thread);
}

WarmStart::~WarmStart() {
    {
        const std::lock_guard lock(mutex);
        is_warming = false;
    }
    has_ended.notify_all();
}

}  // namespace meniscus::cli
