// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "core/workspaces.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstddef>
#include <memory>
#include <stdexcept>
#include <vector>

#include "core/parallel.h"

namespace meniscus::testing {
namespace {

TEST(Workspaces, AreHandedOnWithWhatIsInThem) {
    int made = 0;
    Workspaces workspaces([&made] { return std::make_unique<int>(100 * ++made); });
    for (int task = 0; task < 3; ++task) workspaces.with_one([](int& workspace) { ++workspace; });
    workspaces.with_one([](const int& workspace) { EXPECT_EQ(workspace, 103); });
    EXPECT_EQ(made, 1);
}

TEST(Workspaces, TasksWithinEachOtherHaveDifferentOnes) {
    Workspaces workspaces([] { return std::make_unique<int>(); });
    workspaces.with_one(
        [&](const int& outer) { workspaces.with_one([&](const int& inner) { EXPECT_NE(&outer, &inner); }); });
}

TEST(Workspaces, AreNotHandedOnByATaskThatFailed) {
    int made = 0;
    Workspaces workspaces([&made] { return std::make_unique<int>(++made); });
    EXPECT_THROW(workspaces.with_one([](int&) { throw std::runtime_error("failed"); }), std::runtime_error);
    workspaces.with_one([](const int& workspace) { EXPECT_EQ(workspace, 2); });
}

TEST(Workspaces, NoneIsUsedByTwoThreadsAtOnce) {
    struct Counter {
        std::atomic<int> users = 0;
        int tasks = 0;
    };
    std::atomic<int> made = 0;
    Workspaces workspaces([&made] {
        ++made;
        return std::make_unique<Counter>();
    });
    parallel_for(1000, 1, [&](std::size_t) {
        workspaces.with_one([](Counter& counter) {
            EXPECT_EQ(++counter.users, 1);
            ++counter.tasks;
            --counter.users;
        });
    });
    int tasks = 0;
    // All workspaces that were made are free now: taken one within the other, each is seen once.
    const auto count = [&](const auto& self, int left) -> void {
        if (left == 0) return;
        workspaces.with_one([&](const Counter& counter) {
            tasks += counter.tasks;
            self(self, left - 1);
        });
    };
    count(count, made);
    EXPECT_EQ(tasks, 1000);
}

TEST(Workspaces, AreAtHandInEveryChunk) {
    constexpr std::size_t kItems = 1003;
    const auto make = [] { return std::make_unique<std::vector<std::size_t>>(); };
    std::vector<int> visits(kItems);
    parallel_chunks_with(kItems, 10, make,
                         [&](std::size_t begin, std::size_t end, std::vector<std::size_t>& workspace) {
                             workspace.push_back(begin);
                             for (std::size_t i = begin; i < end; ++i) ++visits[i];
                         });
    EXPECT_EQ(visits, std::vector<int>(kItems, 1));
    const auto list = parallel_list_with<std::size_t>(
        kItems, 10, make,
        [](std::size_t begin, std::size_t end, std::vector<std::size_t>& workspace, std::vector<std::size_t>& found) {
            workspace.clear();
            for (std::size_t i = begin; i < end; ++i)
                if (i % 7 == 0) workspace.push_back(i);
            found.insert(found.end(), workspace.begin(), workspace.end());
        });
    ASSERT_EQ(list.size(), 144U);
    for (std::size_t i = 0; i < list.size(); ++i) EXPECT_EQ(list[i], 7 * i);
}

}  // namespace
}  // namespace meniscus::testing
