// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the machine can do at best: what the stages of a run are held against in docs/design/performance.md.
//
// usage: limits              everything
//        limits threads      only how much faster two threads compute than one
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <string_view>
#include <thread>
#include <vector>

namespace {

constexpr std::size_t kBytes = std::size_t{256} << 20U;  // far beyond the caches
constexpr int kRepeats = 5;

double seconds(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double least_seconds(const std::function<void()>& work) {
    double least = seconds(work);
    for (int i = 1; i < kRepeats; ++i) least = std::min(least, seconds(work));
    return least;
}

// a = b + s c over arrays that do not fit a cache: three times their size passes through memory.
double stream_bytes_per_second() {
    const std::size_t n = kBytes / sizeof(float);
    std::vector<float> a(n);
    const std::vector<float> b(n, 1.0F);
    const std::vector<float> c(n, 2.0F);
    const double time = least_seconds([&] {
        for (std::size_t i = 0; i < n; ++i) a[i] = b[i] + 3.0F * c[i];
    });
    return 3.0 * static_cast<double>(kBytes) / time;
}

// Memory that nobody has touched yet: the kernel clears every page.
double first_touch_bytes_per_second() {
    const double time = least_seconds([] {
        const auto memory = std::make_unique_for_overwrite<char[]>(kBytes);
        volatile char* page = memory.get();
        for (std::size_t i = 0; i < kBytes; i += 4096) page[i] = 1;
    });
    return static_cast<double>(kBytes) / time;
}

// Work that touches no memory, for the gain of a second thread.
double compute(std::size_t steps) {
    double x = 0.5;
    for (std::size_t i = 0; i < steps; ++i) x = std::sqrt(x + 1.0);
    return x;
}

double gain_of_two_threads() {
    constexpr std::size_t kSteps = 20'000'000;
    volatile double sink = 0.0;
    const double one = least_seconds([&] { sink = compute(kSteps); });
    const double two = least_seconds([&] {
        double other = 0.0;
        std::thread thread([&] { other = compute(kSteps); });
        sink = compute(kSteps);
        thread.join();
        sink = sink + other;
    });
    return 2.0 * one / two;
}

// Square roots of floats and doubles in cache, as the distance to a ball needs one per node.
template <class T>
double nanoseconds_per_root() {
    constexpr std::size_t kNumbers = 4096;
    constexpr int kRounds = 1000;
    std::vector<T> numbers(kNumbers, T(2));
    const double time = least_seconds([&] {
        for (int round = 0; round < kRounds; ++round)
            for (T& x : numbers) x = std::sqrt(x) + T(1);
    });
    return 1e9 * time / (kRounds * static_cast<double>(kNumbers));
}

// Steps of two operations that each wait for the one before: two cycles.
double cycles_per_second() {
    constexpr std::size_t kSteps = 200'000'000;
    volatile std::uint64_t sink = 1;
    const double time = least_seconds([&] {
        std::uint64_t x = sink;
        for (std::size_t i = 0; i < kSteps; ++i) x ^= x << 1U;
        sink = x;
    });
    return 2.0 * static_cast<double>(kSteps) / time;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc > 1 && std::string_view(argv[1]) == "threads") {
        fmt::print("{:.3f}\n", gain_of_two_threads());
        return 0;
    }
    fmt::print("clock                        {:6.2f} GHz\n", 1e-9 * cycles_per_second());
    fmt::print("stream, one thread           {:6.1f} GB/s\n", 1e-9 * stream_bytes_per_second());
    const double touch = first_touch_bytes_per_second();
    fmt::print("first touch                  {:6.1f} GB/s, {:.2f} µs per page of 4 KiB\n", 1e-9 * touch,
               1e6 * 4096.0 / touch);
    fmt::print("square root, double          {:6.2f} ns\n", nanoseconds_per_root<double>());
    fmt::print("square root, float           {:6.2f} ns\n", nanoseconds_per_root<float>());
    fmt::print("gain of two compute threads  {:6.2f}\n", gain_of_two_threads());
}
