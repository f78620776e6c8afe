// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/csv.h"

#include <gtest/gtest.h>

#include "io/text_buffer.h"

namespace meniscus {
namespace {

std::string written(std::string_view field) {
    TextBuffer text;
    write_csv_field(text, field);
    return std::string(text.text());
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
