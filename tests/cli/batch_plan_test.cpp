// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "batch/plan.h"

#include <fmt/core.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "batch/records.h"
#include "meniscus/errors.h"

namespace meniscus::cli::batch::testing {
namespace {

std::vector<Input> inputs_of_sizes(const std::vector<std::uint64_t>& sizes) {
    std::vector<Input> inputs;
    for (std::size_t i = 0; i < sizes.size(); ++i)
        inputs.push_back({fmt::format("{:04}.pdb", i), "", std::nullopt, sizes[i]});
    return inputs;
}

std::uint64_t weight_of(const std::vector<Task>& tasks) {
    return std::accumulate(tasks.begin(), tasks.end(), std::uint64_t{0},
                           [](std::uint64_t sum, const Task& task) { return sum + task.weight; });
}

TEST(BatchNames, EndAsStructuresDo) {
    for (const char* name : {"a.pdb", "a.ENT", "b/a.cif.gz", "a.mmcif", "a.bcif", "a.bcif.gz", "a.gro", "a.pdbqt",
                             "a.pqr", "a.xyzr", "a.xyzrn", "a.pdb.GZ", "a.pdb1", "a.PDB12.gz"})
        EXPECT_TRUE(names_structure(name)) << name;
    for (const char* name : {"a.txt", "pdb", ".pdb", "a.gz", "a.pdb.bz2", "a.pdbx", ""})
        EXPECT_FALSE(names_structure(name)) << name;
    EXPECT_EQ(without_suffix("b/1abc.cif.gz"), "b/1abc");
    EXPECT_EQ(without_suffix("1.abc"), "1.abc");
}

TEST(BatchShard, IsReadStrictly) {
    EXPECT_EQ(parse_shard("0/1"), (Shard{0, 1}));
    EXPECT_EQ(parse_shard("11/12"), (Shard{11, 12}));
    for (const char* text : {"", "1", "1/1", "4/4", "-1/4", "0/0", "a/b", "1/2/3", "0x1/4", " 0/4", "1/4 "})
        EXPECT_THROW(parse_shard(text), UsageError) << text;
}

TEST(BatchPlan, ShardsAreDisjointCompleteAndBalanced) {
    std::mt19937 numbers(7);
    for (const std::size_t count : {1U, 5U, 200U, 1000U}) {
        std::vector<std::uint64_t> sizes(count);
        for (std::uint64_t& size : sizes)
            size = static_cast<std::uint64_t>(std::lognormal_distribution<>(12.0, 1.5)(numbers));
        const std::vector<Input> inputs = inputs_of_sizes(sizes);
        const std::uint64_t all = weight_of(plan(inputs, {}));
        const std::uint64_t largest = plan(inputs, {}).front().weight;
        for (const int shards : {1, 2, 7, 64}) {
            std::set<std::string> seen;
            for (int i = 0; i < shards; ++i) {
                const std::vector<Task> tasks = plan(inputs, {i, shards});
                EXPECT_TRUE(std::is_sorted(tasks.begin(), tasks.end(),
                                           [](const Task& a, const Task& b) { return a.weight > b.weight; }));
                for (const Task& task : tasks) EXPECT_TRUE(seen.insert(task.input.name).second);
                // Graham's bound for largest first: 4/3 of the best, which is at least the mean and at least the
                // largest.
                EXPECT_LE(3 * weight_of(tasks),
                          4 * std::max(largest, all / static_cast<std::uint64_t>(shards)) + 4 * largest);
            }
            EXPECT_EQ(seen.size(), count);
        }
    }
}

TEST(BatchPlan, StemsAreNeverShared) {
    std::vector<Input> inputs = inputs_of_sizes({1, 2, 3});
    inputs[0].name = "a/1.cif";
    inputs[1].name = "a/1.pdb.gz";
    inputs[2].name = "b/1.pdb";
    std::set<std::string> stems;
    for (const Task& task : plan(inputs, {})) stems.insert(task.stem);
    EXPECT_EQ(stems, (std::set<std::string>{"a/1.cif", "a/1.pdb.gz", "b/1"}));
}

TEST(BatchPlan, TheFingerprintKnowsNamesAndSizes) {
    const std::vector<Input> inputs = inputs_of_sizes({1, 2, 3});
    EXPECT_EQ(fingerprint(inputs), fingerprint(inputs));
    for (const auto& change : {inputs_of_sizes({1, 2, 4}), inputs_of_sizes({1, 2}), inputs_of_sizes({2, 1, 3})})
        EXPECT_NE(fingerprint(change), fingerprint(inputs));
}

TEST(BatchPlaces, AreBesideOrWithinTheOutputs) {
    const Places folder("out", {1, 4});
    EXPECT_EQ(folder.outputs(), "out");
    EXPECT_EQ(folder.results(), "out/results.jsonl");
    EXPECT_EQ(folder.log(), "out/.batch/shard-1-of-4.log");
    const Places archive("x/out.tar", {1, 4});
    EXPECT_EQ(archive.outputs(), "x/out-1-of-4.tar");
    EXPECT_EQ(archive.results(), "x/out.jsonl");
    EXPECT_EQ(archive.state(), "x/out.batch");
    EXPECT_EQ(Places("out.tar", {0, 1}).outputs(), "out.tar");
}

}  // namespace
}  // namespace meniscus::cli::batch::testing
