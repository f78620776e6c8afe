// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "messages.h"

#include <gtest/gtest.h>

#include <sstream>

namespace meniscus::cli {

TEST(Messages, AreOneLineEach) {
    std::ostringstream out;
    print_error(out, "a\nb.pdb:1:2: two\r\nlines");
    print_warning(out, "tab\there");
    print_note(out, "line\nend");
    EXPECT_EQ(out.str(),
              "meniscus: error: a b.pdb:1:2: two  lines\nmeniscus: warning: tab here\nmeniscus: note: line end\n");
}

TEST(Messages, KeepLettersBeyondAscii) { EXPECT_EQ(one_line("1.4 Å"), "1.4 Å"); }

TEST(Messages, CallTheDashStandardInput) {
    EXPECT_EQ(input_label("-"), "standard input");
    EXPECT_EQ(input_label("dir/1ubq.pdb"), "dir/1ubq.pdb");
}

}  // namespace meniscus::cli
