// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "page/packed_text.h"

#include <gtest/gtest.h>

#include "page/decoding.h"

namespace meniscus::page {
namespace {

TEST(PackedText, DeflatedTextInflates) {
    const std::string text(10000, 'x');
    EXPECT_LT(deflated(text).size(), 200U);
    EXPECT_EQ(testing::inflated(deflated(text)), text);
}

TEST(PackedText, Base64IsThatOfTheStandard) {  // RFC 4648, section 10
    EXPECT_EQ(base64(""), "");
    EXPECT_EQ(base64("f"), "Zg==");
    EXPECT_EQ(base64("fo"), "Zm8=");
    EXPECT_EQ(base64("foo"), "Zm9v");
    EXPECT_EQ(base64("foob"), "Zm9vYg==");
    EXPECT_EQ(base64("\xFF\xFE\xFD"), "//79");
}

}  // namespace
}  // namespace meniscus::page
