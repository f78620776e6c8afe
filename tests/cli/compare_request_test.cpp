// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "compare_request.h"

#include <gtest/gtest.h>

#include <CLI/Error.hpp>
#include <utility>

#include "meniscus/errors.h"
#include "parse_options.h"

namespace meniscus::cli {

namespace {

CompareRequest parse_compare(const std::vector<std::string>& words) {
    const CompareRequest request = request_of(words, add_compare_options);
    check_request(request);
    return request;
}

}  // namespace

TEST(CompareRequest, HasTheDefaultsOfTheLibrary) {
    const CompareRequest request = parse_compare({"a.ply", "1ubq.pdb"});
    EXPECT_EQ(request.input, "a.ply");
    EXPECT_EQ(request.second, "1ubq.pdb");
    EXPECT_EQ(request.structure.probe, StructureToCompare{}.probe);
    EXPECT_EQ(request.compare.density, CompareOptions{}.density);
    EXPECT_FALSE(request.range);
}

TEST(CompareRequest, TakesItsOwnOptionsAndThoseOfReading) {
    const CompareRequest request = parse_compare({"a.ply", "b.pdb", "--range", "-1:0.5", "--points", "3", "--probe",
                                                  "1.5", "--chains", "A", "-o", "d.glb", "--threads", "2"});
    EXPECT_EQ(request.range, (ValueRange{-1.0, 0.5}));
    EXPECT_EQ(request.compare.density, 3.0);
    EXPECT_EQ(request.structure.probe, 1.5);
    EXPECT_EQ(request.compare.threads, 2);
    EXPECT_EQ(request.outputs, std::vector<std::string>{"d.glb"});
}

TEST(CompareRequest, RefusesWhatMakesNoSense) {
    EXPECT_THROW(parse_compare({"a.ply"}), CLI::ParseError);
    EXPECT_THROW(parse_compare({"-", "-"}), UsageError);
    EXPECT_THROW(parse_compare({"a.ply", "b.pdb", "--model", "all"}), UsageError);
    for (const char* range : {"1", "1:1", "2:1", "a:b", ":", "0:inf"})
        EXPECT_THROW(parse_compare({"a.ply", "b.ply", "--range", range}), UsageError) << range;
    for (const char* file : {"d.off", "d.stl", "d.obj", "d.png", "d.html", "d", "d.xyzr"})
        EXPECT_THROW(parse_compare({"a.ply", "b.ply", "-o", file}), UsageError) << file;
    EXPECT_THROW(parse_compare({"a.ply", "b.ply", "--points", "0"}), UsageError);
}

TEST(CompareRequest, RefusesWhatWouldDoNothing) {
    for (const auto& [option, value] :
         {std::pair{"--probe", "1.5"}, {"--spacing", "0.5"}, {"--chains", "A"}, {"--radii", "bondi"}}) {
        EXPECT_THROW(parse_compare({"a.ply", "b.obj", option, value}), UsageError) << option;
        EXPECT_NO_THROW(parse_compare({"a.ply", "b.pdb", option, value})) << option;
        EXPECT_NO_THROW(parse_compare({"a.pdb", "b.ply", option, value})) << option;
    }
    EXPECT_THROW(parse_compare({"a.ply", "b.pdb", "--range", "-1:1"}), UsageError);
}

}  // namespace meniscus::cli
