// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "unknown_words.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace meniscus::cli {

namespace {

/// What is said of a command line that has a word too many.
std::string explained(std::vector<std::string> arguments) {
    CLI::App program("", "tool");
    CLI::App* command = program.add_subcommand("cut");
    std::string value;
    command->add_option("INPUT", value);
    command->add_option("--color,--threads", value);
    command->add_flag("--keep-ridges");
    std::reverse(arguments.begin(), arguments.end());
    EXPECT_THROW(program.parse(arguments), CLI::ExtrasError);
    CLI::App whole("", "tool");
    whole.add_subcommand("cut")->add_flag("--keep-ridges");
    whole.add_subcommand("weigh")->add_flag("--between");
    whole.add_subcommand("many")->add_subcommand("weigh")->add_flag("--between");
    return explain_unknown_words(program, whole);
}

}  // namespace

TEST(UnknownWords, NamesTheOptionThatMayHaveBeenMeant) {
    EXPECT_EQ(explained({"cut", "a.pdb", "--colour", "patch"}), "--colour: unknown option; did you mean --color?");
    EXPECT_EQ(explained({"cut", "a.pdb", "--treads=2"}), "--treads: unknown option; did you mean --threads?");
    EXPECT_EQ(explained({"cut", "a.pdb", "--keep"}), "--keep: unknown option; did you mean --keep-ridges?");
    EXPECT_EQ(explained({"cut", "a.pdb", "--bogus"}), "--bogus: unknown option; see meniscus cut --help");
}

TEST(UnknownWords, SaysWhoseOptionItIs) {
    EXPECT_EQ(explained({"cut", "a.pdb", "--between=A:B"}),
              "--between is an option of meniscus weigh and many, not of meniscus cut");
}

TEST(UnknownWords, SaysHowOutputsAreNamed) {
    EXPECT_EQ(explained({"cut", "a.pdb", "b.ply"}),
              "b.ply: unexpected; there is only one INPUT, and outputs are named with -o");
}

TEST(UnknownWords, AFileIsNoSubcommand) {
    EXPECT_EQ(explain_unknown_subcommand(".", {"cut"}),
              "unknown subcommand '.'; for its surface write meniscus surface .");
}

TEST(UnknownWords, NamesTheSubcommandThatMayHaveBeenMeant) {
    const std::vector<std::string> names{"surface", "measure"};
    EXPECT_EQ(explain_unknown_subcommand("mesure", names),
              "unknown subcommand 'mesure'; did you mean meniscus measure?");
    EXPECT_EQ(explain_unknown_subcommand("Surface", names),
              "unknown subcommand 'Surface'; did you mean meniscus surface?");
    EXPECT_EQ(explain_unknown_subcommand("sell", names), "unknown subcommand 'sell'; see meniscus --help");
}

TEST(UnknownWords, LettersApart) {
    EXPECT_EQ(letters_apart("color", "colour"), 1u);
    EXPECT_EQ(letters_apart("", "abc"), 3u);
    EXPECT_EQ(letters_apart("kitten", "sitting"), 3u);
    EXPECT_EQ(letters_apart("same", "same"), 0u);
}

}  // namespace meniscus::cli
