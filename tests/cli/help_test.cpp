// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "help.h"

#include <gtest/gtest.h>

namespace meniscus::cli {

namespace {

/// The help of a program with a subcommand "cut" that has a usual and a rare option.
struct Program {
    CLI::App app{"Cuts things", "tool"};
    std::string value;

    Program() {
        app.formatter(std::make_shared<HelpFormatter>());
        app.set_help_all_flag("--help-all", "Everything");
        CLI::App* cut = app.add_subcommand("cut", "Cuts one thing");
        cut->footer("Examples");
        cut->add_option("INPUT", value, "what is cut");
        cut->option_defaults()->group("Knife");
        cut->add_option("--length", value, "Length, Å\n of the blade")->type_name("L")->default_str("2");
        cut->add_option("--edge", value, rarely("How sharp"))->type_name("E");
    }

    std::string help(CLI::AppFormatMode mode) const { return app.get_subcommand("cut")->help("tool", mode); }
};

}  // namespace

TEST(Help, ShowsFirstLinesWithDefaultsInAColumnOfTheirOwn) {
    const std::string text = Program().help(CLI::AppFormatMode::Normal);
    EXPECT_EQ(text.substr(0, text.find("  --help-all")),
              "Usage: tool cut INPUT [options]\n"
              "Cuts one thing\n"
              "INPUT: what is cut\n\n"
              "Knife:\n"
              "  --length L                       Length, Å [2]\n");
    EXPECT_NE(text.find("  --help-all "), std::string::npos);
    EXPECT_TRUE(text.ends_with("\nExamples\n")) << text;
}

TEST(Help, FullHelpHasRareOptionsAndAllThatIsSaid) {
    const std::string text = Program().help(CLI::AppFormatMode::All);
    EXPECT_NE(text.find("  --length L                       Length, Å of the blade [2]\n"), std::string::npos) << text;
    EXPECT_NE(text.find("  --edge E                         How sharp\n"), std::string::npos) << text;
}

TEST(Help, OfTheWholeProgramListsSubcommandsAndInFullTheirOptions) {
    const Program program;
    const std::string brief = program.app.help("", CLI::AppFormatMode::Normal);
    EXPECT_TRUE(brief.starts_with("Usage: tool SUBCOMMAND [options]\n")) << brief;
    EXPECT_NE(brief.find("  cut                              Cuts one thing\n"), std::string::npos) << brief;
    EXPECT_EQ(brief.find("--edge"), std::string::npos);
    EXPECT_NE(program.app.help("", CLI::AppFormatMode::All).find("--edge"), std::string::npos);
}

TEST(Help, WrapsByCharactersNotBytes) {
    EXPECT_EQ(wrap("ÅÅÅ ÅÅÅ b", {.indent = 2, .width = 7}), "ÅÅÅ ÅÅÅ\n  b");
    EXPECT_EQ(wrap("a b", {.indent = 4, .used = 6, .width = 7}), "a\n    b");
    EXPECT_EQ(wrap("toolongaword", {.width = 4}), "toolongaword");
    EXPECT_EQ(wrap("", {}), "");
}

}  // namespace meniscus::cli
