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
    const std::string zeros(512, '\0');
    EXPECT_EQ(gunzip(gzipped("one ") + gzipped("two"), "f"), "one two");
    EXPECT_EQ(gunzip(gzipped("one") + zeros, "f"), "one");
    EXPECT_EQ(gunzip(gzipped("one ") + zeros + gzipped("two") + zeros, "f"), "one two");
}

TEST(Gunzip, NothingBehindAMemberIsDroppedSilently) {
    const std::string one = gzipped("one");
    const std::string two = gzipped("two");
    const std::string damaged = "X" + two.substr(1);
    for (const std::string& rest : {damaged, std::string(3, '\0') + damaged, two.substr(0, 1), std::string("\n")}) {
        const std::size_t place = one.size() + rest.find_first_not_of('\0') + 1;
        try {
            gunzip(one + rest, "f");
            ADD_FAILURE() << rest.size();
        } catch (const InputError& error) {
            testing::expect_contains(error.what(),
                                     "f: byte " + std::to_string(place) + ": what follows here is not gzip data");
        }
    }
    // A size of the content that is none: room for it is not even looked for.
    EXPECT_THROW(gunzip(one + std::string(4, '\xff'), "f"), InputError);
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
