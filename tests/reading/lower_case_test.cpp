// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "reading/lower_case.h"

#include <gtest/gtest.h>

namespace meniscus {
namespace {

TEST(LowerCase, ChangesTheLettersOfAsciiAlone) {
    EXPECT_EQ(lower_case(""), "");
    EXPECT_EQ(lower_case("A.b[Z]@09_ÄÉ"), "a.b[z]@09_ÄÉ");
}

}  // namespace
}  // namespace meniscus
