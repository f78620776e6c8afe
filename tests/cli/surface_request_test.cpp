// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "surface_request.h"

#include <gtest/gtest.h>

#include <CLI/Error.hpp>
#include <utility>

#include "meniscus/errors.h"
#include "parse_options.h"

namespace meniscus::cli {

namespace {

SurfaceRequest parse(const std::vector<std::string>& words) { return request_of(words, add_surface_options); }

}  // namespace

TEST(SurfaceRequest, HasTheDefaultsOfTheLibrary) {
    const SurfaceRequest request = parse({"1ubq.pdb"});
    EXPECT_EQ(request.input, "1ubq.pdb");
    EXPECT_EQ(request.surface.probe, SurfaceOptions{}.probe);
    EXPECT_EQ(request.surface.spacing, SurfaceOptions{}.spacing);
    EXPECT_EQ(request.run.threads, 0);
    EXPECT_EQ(request.read.radii, "auto");
    EXPECT_TRUE(request.outputs.empty());
    EXPECT_TRUE(request.report.empty());
}

TEST(SurfaceRequest, TakesValuesOfAllKinds) {
    const SurfaceRequest request = parse({"--probe",
                                          "0",
                                          "--density",
                                          "-.25",
                                          "--spacing=0.25",
                                          "--method",
                                          "flow",
                                          "-o",
                                          "a.ply",
                                          "-o",
                                          "b.stl",
                                          "-",
                                          "--chains",
                                          "A,label:B",
                                          "--hetero",
                                          "ligands",
                                          "--hydrogens",
                                          "keep",
                                          "--waters",
                                          "--memory",
                                          "4G",
                                          "--threads",
                                          "2",
                                          "--progress",
                                          "json",
                                          "--ascii",
                                          "--altloc",
                                          "B",
                                          "--report",
                                          "-",
                                          "--max-steps",
                                          "7"});
    EXPECT_EQ(request.input, "-");
    EXPECT_EQ(request.surface.probe, 0.0);
    EXPECT_EQ(request.surface.density, -0.25);
    EXPECT_EQ(request.surface.spacing, 0.25);
    EXPECT_EQ(request.surface.method, Method::Flow);
    EXPECT_EQ(request.run.memory_limit_mb, 4096u);
    EXPECT_EQ(request.run.threads, 2);
    EXPECT_EQ(request.surface.flow.max_steps, 7);
    EXPECT_EQ(request.outputs, (std::vector<std::string>{"a.ply", "b.stl"}));
    EXPECT_EQ(request.read.chains, (std::vector<std::string>{"A", "label:B"}));
    EXPECT_EQ(request.read.hetero, HeteroPolicy::Ligands);
    EXPECT_EQ(request.read.hydrogens, HydrogenPolicy::Keep);
    EXPECT_EQ(request.read.altloc, "B");
    EXPECT_EQ(request.read.keep_waters, true);
    EXPECT_EQ(request.progress, ProgressMode::Json);
    EXPECT_EQ(request.encoding, Encoding::Text);
    EXPECT_EQ(request.report, "-");
}

TEST(SurfaceRequest, AnExplicitHeteroNoneIsNotTheDefault) {
    EXPECT_EQ(parse({"a.pdb"}).read.hetero, std::nullopt);
    EXPECT_EQ(parse({"a.pdb", "--hetero", "none"}).read.hetero, HeteroPolicy::None);
}

TEST(SurfaceRequest, TellsOneModelFromAll) {
    EXPECT_EQ(parse({"a.pdb", "--model", "3"}).read.model, 3);
    EXPECT_TRUE(parse({"a.pdb", "--model", "all"}).all_models);
    EXPECT_TRUE(parse({"a.pdb", "--model", "join"}).read.join_models);
    EXPECT_FALSE(parse({"a.pdb", "--model", "3"}).read.join_models);
    EXPECT_THROW(parse({"a.pdb", "--model", "0"}), UsageError);
    EXPECT_THROW(parse({"a.pdb", "--model", "ALL"}), UsageError);
}

TEST(SurfaceRequest, NamesTheWordsThatExist) {
    try {
        parse({"a.pdb", "--method", "fast"});
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_STREQ(error.what(), "--method: unknown value 'fast'; choose one of flow, direct, gaussian");
    }
    EXPECT_THROW(parse({"a.pdb", "--flow", "sideways"}), UsageError);
    EXPECT_THROW(parse({"a.pdb", "--hetero", "haem"}), UsageError);
}

TEST(SurfaceRequest, TakesWhatLeavesPiecesOut) {
    const SurfaceRequest request =
        parse({"a.pdb", "--min-cavity", "12.5", "--edge", "1", "--simplify-topology", "--verify"});
    EXPECT_EQ(request.surface.min_cavity, 12.5);
    EXPECT_TRUE(request.surface.remesh.simplify_topology);
    EXPECT_TRUE(request.surface.verify);
    EXPECT_TRUE(parse({"a.pdb", "--vertex-density", "2", "--simplify-topology"}).surface.remesh.simplify_topology);
    EXPECT_THROW(parse({"a.pdb", "--simplify-topology"}), UsageError);
    EXPECT_THROW(parse({"a.pdb", "--min-cavity", "-1"}), UsageError);
    EXPECT_THROW(parse({"a.pdb", "--min-cavity", "nan"}), UsageError);
    EXPECT_EQ(parse({"a.pdb", "--min-cavity", "0"}).surface.min_cavity, 0.0);
}

TEST(SurfaceRequest, MeasuresExactlyUnlessToldNotTo) {
    EXPECT_TRUE(parse({"a.pdb"}).surface.exact);
    EXPECT_FALSE(parse({"a.pdb", "--no-exact", "--report", "a.json"}).surface.exact);
    try {
        parse({"a.pdb", "--no-exact", "--verify"});
        FAIL();
    } catch (const UsageError& error) {
        EXPECT_STREQ(error.what(), "--verify checks the exact numbers, which --no-exact leaves out; give one of them");
    }
}

TEST(SurfaceRequest, AGridThatIsAskedForStays) {
    EXPECT_TRUE(parse({"a.pdb", "--edge", "1"}).surface.remesh.finer_grid);
    EXPECT_FALSE(parse({"a.pdb", "--edge", "1", "--spacing", "0.5"}).surface.remesh.finer_grid);
}

TEST(SurfaceRequest, RefusesValuesThatMakeNoSense) {
    EXPECT_THROW(parse({"a.pdb", "--chains", "A,,B"}), UsageError);
    EXPECT_THROW(parse({"a.pdb", "--altloc", "AB"}), UsageError);
    EXPECT_THROW(parse({"a.pdb", "--spacing", "-inf"}), UsageError);
    EXPECT_THROW(parse({"a.pdb", "--density", "0.5"}), UsageError);
    EXPECT_THROW(parse({"a.pdb", "b.pdb"}), CLI::ParseError);
    EXPECT_THROW(parse({"a.pdb", "--unknown"}), CLI::ParseError);
    EXPECT_THROW(parse({"a.pdb", "--probe", "1", "--probe", "2"}), CLI::ParseError);
    EXPECT_THROW(parse({}), CLI::ParseError);
}

TEST(SurfaceRequest, RefusesWhatWouldDoNothing) {
    for (const char* method : {"direct", "gaussian"})
        for (const auto& [option, value] : {std::pair{"--flow", "anchored"},
                                            {"--anchor", "1"},
                                            {"--solver", "gmres"},
                                            {"--max-steps", "3"},
                                            {"--history", "a.csv"}})
            EXPECT_THROW(parse({"a.pdb", "--method", method, option, value}), UsageError) << method << option;
    EXPECT_THROW(parse({"a.pdb", "--method", "direct", "--density", "-0.5"}), UsageError);
    EXPECT_EQ(parse({"a.pdb", "--method", "gaussian", "--density", "-0.4"}).surface.density, -0.4);
    EXPECT_THROW(parse({"a.pdb", "--surface", "vdw", "--probe", "1.4"}), UsageError);
    EXPECT_EQ(parse({"a.pdb", "--surface", "vdw", "--probe", "0"}).surface.probe, 0.0);
    EXPECT_THROW(parse({"a.pdb", "--corners", "near"}), UsageError);
    EXPECT_EQ(parse({"a.pdb", "--edge", "1", "--corners", "near"}).surface.remesh.corners, Corners::Near);
}

}  // namespace meniscus::cli
