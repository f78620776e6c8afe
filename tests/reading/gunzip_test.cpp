// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "reading/gunzip.h"

#include "structure/fragments.h"

namespace meniscus::reading {
namespace {

using meniscus::testing::gzipped;

TEST(Gunzip, GivesBackTheContent) {
    std::string text;
    for (int i = 0; i < 100000; ++i) text += std::to_string(i);
    EXPECT_TRUE(is_gzip(gzipped(text)));
    EXPECT_EQ(gunzip(gzipped(text), "f"), text);
    EXPECT_EQ(gunzip(gzipped(""), "f"), "");
}

TEST(Gunzip, ReadsAllMembersAndIgnoresPadding) {
    EXPECT_EQ(gunzip(gzipped("one ") + gzipped("two"), "f"), "one two");
    EXPECT_EQ(gunzip(gzipped("one") + std::string(512, '\0'), "f"), "one");
    // A size of the content that is none: room for it is not even looked for.
    EXPECT_LT(gunzip(gzipped("one") + std::string(4, '\xff'), "f").capacity(), 1000U);
}

TEST(Gunzip, CutOrDamagedDataAreErrors) {
    const std::string whole = gzipped("some text that is long enough to be cut in half somewhere");
    EXPECT_THROW(gunzip(whole.substr(0, whole.size() / 2), "f"), InputError);
    EXPECT_THROW(gunzip(whole.substr(0, 2), "f"), InputError);
    EXPECT_THROW(gunzip(whole.substr(0, whole.size() - 1), "f"), InputError);
    std::string damaged = whole;
    damaged[damaged.size() - 6] = static_cast<char>(~damaged[damaged.size() - 6]);
    EXPECT_THROW(gunzip(damaged, "f"), InputError);
}

}  // namespace
}  // namespace meniscus::reading
