// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/threads.h"

#include <gtest/gtest.h>

#include <mutex>
#include <set>
#include <thread>

#include "core/parallel.h"

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

}  // namespace
}  // namespace meniscus::testing
