// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "common_request.h"

#include <gtest/gtest.h>

#include <CLI/Error.hpp>

#include "meniscus/errors.h"
#include "option_words.h"
#include "parse_options.h"

namespace meniscus::cli {

namespace {

struct Parsed {
    CommonRequest request;
    double probe = 1.4;
    int threads = 0;
};

Parsed parse(const std::vector<std::string>& words) {
    Parsed parsed;
    parse_options(words, [&](CLI::App& command) {
        add_input(command, parsed.request);
        add_atom_options(command, parsed.request);
        OptionAdder{command}(kProbeOption, parsed.probe);
        add_output_options(command, parsed.request);
        OptionAdder{command}(kThreadsOption, parsed.threads);
        add_progress(command, parsed.request.progress);
    });
    return parsed;
}

}  // namespace

TEST(CommonRequest, FillsWhatItIsGiven) {
    const Parsed parsed = parse({"a.pdb", "--probe", "0.5", "--threads", "3", "-o", "a.x", "-o", "b.y", "--assembly",
                                 "2", "--select", "//A", "--strict-radii", "--progress", "json"});
    EXPECT_EQ(parsed.request.input, "a.pdb");
    EXPECT_EQ(parsed.probe, 0.5);
    EXPECT_EQ(parsed.threads, 3);
    EXPECT_EQ(parsed.request.outputs, (std::vector<std::string>{"a.x", "b.y"}));
    EXPECT_EQ(parsed.request.read.assembly, "2");
    EXPECT_EQ(parsed.request.read.select, "//A");
    EXPECT_TRUE(parsed.request.read.strict_radii);
    EXPECT_EQ(parsed.request.progress, ProgressMode::Json);
}

TEST(CommonRequest, KnowsWhetherWatersAndHeteroAtomsWereAskedFor) {
    EXPECT_EQ(parse({"a.pqr"}).request.read.keep_waters, std::nullopt);
    EXPECT_EQ(parse({"a.pqr"}).request.read.hetero, std::nullopt);
    EXPECT_EQ(parse({"a.pqr", "--waters"}).request.read.keep_waters, true);
    EXPECT_EQ(parse({"a.pqr", "--no-waters"}).request.read.keep_waters, false);
    EXPECT_EQ(parse({"a.pqr", "--hetero", "none"}).request.read.hetero, HeteroPolicy::None);
    EXPECT_THROW(parse({"a.pqr", "--waters", "--no-waters"}), CLI::ParseError);
    EXPECT_EQ(spell_as_option("keep_waters", "true"), "--waters");
    EXPECT_EQ(spell_as_option("keep_waters", "false"), "--no-waters");
}

TEST(CommonRequest, RefusesWhatMakesNoSense) {
    EXPECT_THROW(parse({"a.pdb", "--model", "foo"}), UsageError);
    EXPECT_THROW(parse({"a.pdb", "--probe", "-1"}), UsageError);
    EXPECT_THROW(parse({"a.pdb", "--threads", "0"}), UsageError);
    EXPECT_THROW(parse({"a.pdb", "--hydrogens", "some"}), UsageError);
    EXPECT_THROW(parse({}), CLI::ParseError);
}

TEST(CommonRequest, NegativeNumbersAreJoinedToTheirOption) {
    EXPECT_EQ(join_negative_values({"--density", "-.5", "-o", "-"}),
              (std::vector<std::string>{"--density=-.5", "-o", "-"}));
}

}  // namespace meniscus::cli
