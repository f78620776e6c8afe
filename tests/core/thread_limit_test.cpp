// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/threads.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <future>
#include <iterator>
#include <mutex>
#include <set>
#include <thread>

#include "core/parallel.h"

#ifdef __linux__
#include <sched.h>
#endif

namespace meniscus::testing {
namespace {

std::set<std::thread::id> threads_of_a_loop() {
    std::mutex mutex;
    std::set<std::thread::id> threads;
    parallel_for(1000, 1, [&](std::size_t) {
        const std::lock_guard lock(mutex);
        threads.insert(std::this_thread::get_id());
    });
    parallel_both([] {},
                  [&] {
                      const std::lock_guard lock(mutex);
                      threads.insert(std::this_thread::get_id());
                  });
    return threads;
}

TEST(ThreadLimit, OneThreadDoesEverythingItself) {
    const ThreadLimit limit(1);
    EXPECT_EQ(threads_of_a_loop(), std::set{std::this_thread::get_id()});
}

TEST(ThreadLimit, LastsAsLongAsItLivesAndTheLeastOneHolds) {
    EXPECT_FALSE(is_alone());
    {
        const ThreadLimit one(1);
        EXPECT_TRUE(is_alone());
        {
            const ThreadLimit none(0);
            const ThreadLimit four(4);
            const ThreadLimit again(1);
            EXPECT_TRUE(is_alone());
        }
        EXPECT_TRUE(is_alone());
    }
    EXPECT_FALSE(is_alone());
}

TEST(ThreadLimit, IsThatOfItsOwnThread) {
    const ThreadLimit one(1);
    bool other_is_alone = true;
    std::thread([&] { other_is_alone = is_alone(); }).join();
    EXPECT_FALSE(other_is_alone);
}

#ifdef __linux__
std::ptrdiff_t count_threads() {
    return std::distance(std::filesystem::directory_iterator("/proc/self/task"), std::filesystem::directory_iterator());
}

// How many processors the threads of a loop may use, each number once.
std::set<int> processors_of_a_loop() {
    std::mutex mutex;
    std::set<int> counts;
    parallel_for(1000, 1, [&](std::size_t) {
        cpu_set_t allowed;
        if (sched_getaffinity(0, sizeof allowed, &allowed) != 0) return;
        const std::lock_guard lock(mutex);
        counts.insert(CPU_COUNT(&allowed));
    });
    return counts;
}

#ifdef MENISCUS_TEST_WITHOUT_THREADS
constexpr bool kHasNoThreads = true;
#else
constexpr bool kHasNoThreads = false;
#endif

TEST(StartThreads, NoneUnderALimitOfOne) {
    const ThreadLimit limit(1);
    const auto before = count_threads();
    start_threads([] { ADD_FAILURE() << "called without a thread"; });
    EXPECT_EQ(count_threads(), before);
}

TEST(StartThreads, OneOfThemDoesWhatItIsGiven) {
    if (kHasNoThreads) GTEST_SKIP() << "core was built without threads";
    static std::promise<std::thread::id> done_by;
    auto found = done_by.get_future();
    start_threads([] { done_by.set_value(std::this_thread::get_id()); });
    ASSERT_EQ(found.wait_for(std::chrono::minutes(1)), std::future_status::ready);
    EXPECT_NE(found.get(), std::this_thread::get_id());
}

#ifndef __SANITIZE_THREAD__
TEST(StartThreads, EachTellsFirstThatItBegins) {
    if (kHasNoThreads) GTEST_SKIP() << "core was built without threads";
    if (count_threads() > 1) GTEST_SKIP() << "they have begun in other tests";
    static std::mutex mutex;
    static std::set<std::thread::id> begun;
    static std::promise<bool> has_begun;
    auto found = has_begun.get_future();
    const auto begin = [] {
        const std::lock_guard lock(mutex);
        begun.insert(std::this_thread::get_id());
    };
    const auto meanwhile = [] {
        const std::lock_guard lock(mutex);
        has_begun.set_value(begun.contains(std::this_thread::get_id()));
    };
    start_threads(meanwhile, begin);
    ASSERT_EQ(found.wait_for(std::chrono::minutes(1)), std::future_status::ready);
    EXPECT_TRUE(found.get());
    const std::lock_guard lock(mutex);
    EXPECT_FALSE(begun.contains(std::this_thread::get_id()));
}
#endif

TEST(StartThreads, LeavesThemAllProcessors) {
    cpu_set_t allowed;
    ASSERT_EQ(sched_getaffinity(0, sizeof allowed, &allowed), 0);
    for (int i = 0; i < 3; ++i) start_threads();
    for (int i = 0; i < 20; ++i) EXPECT_EQ(processors_of_a_loop(), std::set{CPU_COUNT(&allowed)});
}
#endif

}  // namespace
}  // namespace meniscus::testing
