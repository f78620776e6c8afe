// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure_request.h"

#include <gtest/gtest.h>

#include <CLI/Error.hpp>

#include "meniscus/errors.h"
#include "parse_options.h"

namespace meniscus::cli {

namespace {

MeasureRequest parse_measure(const std::vector<std::string>& words) { return request_of(words, add_measure_options); }

}  // namespace

TEST(MeasureRequest, HasTheDefaultsOfTheLibrary) {
    const MeasureRequest request = parse_measure({"1ubq.pdb"});
    EXPECT_EQ(request.input, "1ubq.pdb");
    EXPECT_EQ(request.measure.probe, MeasureOptions{}.probe);
    EXPECT_TRUE(request.per.empty());
    EXPECT_TRUE(request.values.empty());
    EXPECT_TRUE(request.between.empty());
    EXPECT_NO_THROW(check_request(request));
}

TEST(MeasureRequest, SharesTheOptionsOfReading) {
    const MeasureRequest request = parse_measure({"-", "--probe", "0", "--chains", "A,B", "--waters", "--model", "all",
                                                  "--radii", "bondi", "--threads", "2", "--report", "-", "--quiet"});
    EXPECT_EQ(request.measure.probe, 0.0);
    EXPECT_EQ(request.measure.threads, 2);
    EXPECT_EQ(request.read.chains, (std::vector<std::string>{"A", "B"}));
    EXPECT_EQ(request.read.keep_waters, true);
    EXPECT_TRUE(request.all_models);
    EXPECT_EQ(request.read.radii, "bondi");
    EXPECT_TRUE(request.quiet);
    EXPECT_THROW(parse_measure({"a.pdb", "--spacing", "0.5"}), CLI::ParseError);
}

TEST(MeasureRequest, TakesWordsInOrder) {
    const MeasureRequest request = parse_measure({"a.pdb", "-o", "a.csv", "--per", "atom", "-o", "b.json", "--per",
                                                  "cavity", "-o", "c.pdb", "--value", "depth"});
    EXPECT_EQ(request.per, (std::vector<RowsPer>{RowsPer::Atom, RowsPer::Cavity}));
    EXPECT_EQ(request.values, (std::vector<AtomValue>{AtomValue::Depth}));
    EXPECT_EQ(request.outputs, (std::vector<std::string>{"a.csv", "b.json", "c.pdb"}));
    EXPECT_NO_THROW(check_request(request));
    EXPECT_THROW(parse_measure({"a.pdb", "--per", "molecule"}), UsageError);
    EXPECT_THROW(parse_measure({"a.pdb", "--value", "charge"}), UsageError);
}

TEST(MeasureRequest, TheLastWordHoldsForAllThatFollow) {
    const std::vector<RowsPer> asked{RowsPer::Atom, RowsPer::Chain};
    EXPECT_EQ(choice_at({}, 3, RowsPer::Residue), RowsPer::Residue);
    EXPECT_EQ(choice_at(asked, 0, RowsPer::Residue), RowsPer::Atom);
    EXPECT_EQ(choice_at(asked, 1, RowsPer::Residue), RowsPer::Chain);
    EXPECT_EQ(choice_at(asked, 5, RowsPer::Residue), RowsPer::Chain);
}

TEST(MeasureRequest, RefusesCombinationsThatMakeNoSense) {
    EXPECT_THROW(check_request(parse_measure({"a.pdb", "--per", "atom"})), UsageError);
    EXPECT_THROW(check_request(parse_measure({"a.pdb", "-o", "a.csv", "--value", "sas"})), UsageError);
    EXPECT_THROW(check_request(parse_measure({"a.pdb", "-o", "a.ply"})), UsageError);
    EXPECT_THROW(check_request(parse_measure({"a.pdb", "-o", "a.csv", "--per", "cavity", "--between", "A:B"})),
                 UsageError);
    EXPECT_THROW(check_request(parse_measure({"a.pdb", "--between", "all", "--between", "A:B"})), UsageError);
    EXPECT_NO_THROW(check_request(parse_measure({"a.pdb", "--between", "C:B", "--between", "A:B"})));
}

TEST(MeasureRequest, BetweenIsAPairOfGroupsOrAll) {
    EXPECT_FALSE(parse_between("all"));
    const ChainPair pair = parse_between("A,C:B-2").value();
    EXPECT_EQ(pair.a, (std::vector<std::string>{"A", "C"}));
    EXPECT_EQ(pair.b, (std::vector<std::string>{"B-2"}));
    for (const char* text : {"", "A", ":", "A:", ":B", "A,:B", "A:B:C"})
        EXPECT_THROW(parse_between(text), UsageError) << text;
}

}  // namespace meniscus::cli
