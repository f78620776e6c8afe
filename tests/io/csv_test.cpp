// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/csv.h"

#include <gtest/gtest.h>

#include "support/scratch_folder.h"

namespace meniscus {
namespace {

std::string written(std::string_view text) {
    const testing::ScratchFolder folder;
    const std::string path = folder / "field.csv";
    AtomicFile file(path);
    write_csv_field(file, text);
    file.commit();
    return testing::read_file(path);
}

TEST(Csv, FieldsAreQuotedOnlyWhereTheyMustBe) {
    EXPECT_EQ(written("CA"), "CA");
    EXPECT_EQ(written(""), "");
    EXPECT_EQ(written("O5'"), "O5'");
    EXPECT_EQ(written("a,b"), "\"a,b\"");
    EXPECT_EQ(written("a\"b"), "\"a\"\"b\"");
    EXPECT_EQ(written("a\nb"), "\"a\nb\"");
}

}  // namespace
}  // namespace meniscus
