// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "core/parallel.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <mutex>
#include <set>
#include <stdexcept>
#include <thread>

#include "meniscus/threads.h"

namespace meniscus::testing {
namespace {

using Chunks = std::set<std::pair<std::size_t, std::size_t>>;

Chunks chunks_with(int threads, std::size_t n, std::size_t chunk) {
    const ThreadLimit limit(threads);
    std::mutex mutex;
    Chunks chunks;
    parallel_chunks(n, chunk, [&](std::size_t begin, std::size_t end) {
        const std::lock_guard lock(mutex);
        chunks.emplace(begin, end);
    });
    return chunks;
}

double harmonic_sum(int threads, std::size_t n) {
    const ThreadLimit limit(threads);
    return parallel_sum<double>(n, 1000, [](std::size_t begin, std::size_t end) {
        double sum = 0.0;
        for (std::size_t i = begin; i < end; ++i) sum += std::sin(double(i)) / double(i + 1);
        return sum;
    });
}

TEST(Parallel, VisitsEveryIndexOnce) {
    for (const std::size_t n : {0U, 1U, 7U, 10000U})
        for (const std::size_t grain : {1U, 3U, 512U}) {
            std::vector<std::atomic<int>> visits(n);
            parallel_for(n, grain, [&](std::size_t i) { ++visits[i]; });
            for (const auto& v : visits) EXPECT_EQ(v.load(), 1);
        }
}

TEST(Parallel, ChunksCoverTheRangeAndDoNotDependOnTheThreads) {
    const Chunks one = chunks_with(1, 1003, 100);
    EXPECT_EQ(one, chunks_with(2, 1003, 100));
    EXPECT_EQ(one.size(), 11U);
    std::size_t covered = 0;
    for (const auto& [begin, end] : one) {
        EXPECT_EQ(begin, covered);
        covered = end;
    }
    EXPECT_EQ(covered, 1003U);
}

TEST(Parallel, SumsHaveTheSameBitsForAnyNumberOfThreads) {
    const double one = harmonic_sum(1, 1'000'001);
    for (int repeat = 0; repeat < 5; ++repeat) EXPECT_EQ(one, harmonic_sum(2, 1'000'001));
    EXPECT_EQ(one, harmonic_sum(0, 1'000'001));
    EXPECT_EQ(harmonic_sum(2, 0), 0.0);
}

TEST(Parallel, OneThreadMeansTheCallingThread) {
    const ThreadLimit limit(1);
    std::atomic<int> elsewhere = 0;
    const auto caller = std::this_thread::get_id();
    parallel_for(1000, 1, [&](std::size_t) { elsewhere += std::this_thread::get_id() == caller ? 0 : 1; });
    EXPECT_EQ(elsewhere.load(), 0);
}

TEST(Parallel, ExceptionsReachTheCaller) {
    EXPECT_THROW(parallel_for(100, 1,
                              [](std::size_t i) {
                                  if (i == 50) throw std::runtime_error("body");
                              }),
                 std::runtime_error);
}

TEST(Isolated, DoesItsWorkWithinLoopsAndPassesOnWhatItThrows) {
    std::atomic<int> done = 0;
    std::mutex mutex;
    parallel_for(50, 1, [&](std::size_t) {
        const std::lock_guard lock(mutex);
        isolated([&] { parallel_for(100, 1, [&](std::size_t) { ++done; }); });
    });
    EXPECT_EQ(done, 5000);
    EXPECT_THROW(isolated([] { throw std::runtime_error("no"); }), std::runtime_error);
}

}  // namespace
}  // namespace meniscus::testing
