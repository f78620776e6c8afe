// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <limits>

#include "meniscus/errors.h"
#include "meniscus/write.h"
#include "support/scratch_folder.h"

namespace meniscus {
namespace {

using testing::read_file;
using testing::ScratchFolder;

// Every kind of cell, and texts that need care.
Table sample_table() {
    Table table;
    table.columns = {"name", "count", "area", "buried", "rsa"};
    table.rows.resize(2);
    table.rows[0].emplace_back(std::string("A,\"1\"\t\\"));
    table.rows[0].emplace_back(std::int64_t{-3});
    table.rows[0].emplace_back(0.1);
    table.rows[0].emplace_back(true);
    table.rows[0].emplace_back(std::monostate());
    table.rows[1].emplace_back(std::string("\xff"));
    table.rows[1].emplace_back(std::int64_t{7});
    table.rows[1].emplace_back(std::numeric_limits<double>::quiet_NaN());
    table.rows[1].emplace_back(false);
    table.rows[1].emplace_back(1.0 / 3.0);
    return table;
}

TEST(WriteTable, CommaSeparated) {
    const ScratchFolder folder;
    write_table(folder / "a.csv", sample_table());
    EXPECT_EQ(read_file(folder / "a.csv"),
              "name,count,area,buried,rsa\n"
              "\"A,\"\"1\"\"\t\\\",-3,0.1,true,\n"
              "\xff,7,,false,0.3333333333333333\n");
}

TEST(WriteTable, JsonHasOneObjectPerRow) {
    const ScratchFolder folder;
    write_table(folder / "a.json", sample_table());
    EXPECT_EQ(read_file(folder / "a.json"),
              "[\n"
              R"({"name": "A,\"1\"\u0009\\", "count": -3, "area": 0.1, "buried": true, "rsa": null},)"
              "\n"
              R"({"name": "?", "count": 7, "area": null, "buried": false, "rsa": 0.3333333333333333})"
              "\n]\n");
}

TEST(WriteTable, TablesWithoutRowsAreValid) {
    const ScratchFolder folder;
    const Table table{{"a", "b"}, {}};
    write_table(folder / "a.csv", table);
    write_table(folder / "a.json", table);
    EXPECT_EQ(read_file(folder / "a.csv"), "a,b\n");
    EXPECT_EQ(read_file(folder / "a.json"), "[\n]\n");
}

TEST(WriteTable, FailureLeavesNoFile) {
    const ScratchFolder folder;
    Table table = sample_table();
    EXPECT_THROW(write_table(folder / "a.txt", table), UsageError);
    EXPECT_THROW(write_table(folder / "none/a.csv", table), OutputError);
    table.rows[0].pop_back();
    EXPECT_THROW(write_table(folder / "a.csv", table), UsageError);
    EXPECT_TRUE(folder.listing().empty());
}

}  // namespace
}  // namespace meniscus
