// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "volume_options.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "meniscus/errors.h"
#include "parse_options.h"

namespace meniscus::cli {

namespace {

VolumeRequest parse_volume(const std::vector<std::string>& words) { return request_of(words, add_volume_options); }

std::vector<Output> plan(const std::vector<std::string>& arguments, const std::vector<std::string>& outputs) {
    return plan_volumes(parse_volume(arguments), plan_outputs(outputs, "a", ""));
}

std::string refusal(const std::vector<std::string>& arguments, const std::vector<std::string>& outputs = {"a.dx"}) {
    try {
        plan(arguments, outputs);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

const std::vector<std::string> kApbs{"--maps", "apbs", "--grid", "9,9,9,0.5,0,0,0"};

}  // namespace

TEST(VolumeOptions, HasTheDefaultsOfTheLibrary) {
    const VolumeRequest request = parse_volume({});
    EXPECT_EQ(request.field.content, VolumeContent::Distance);
    EXPECT_EQ(request.field.inner_dielectric, 2.0);
    EXPECT_EQ(request.field.outer_dielectric, 78.54);
    EXPECT_EQ(request.field.ion_radius, 2.0);
    EXPECT_FALSE(request.grid);
    EXPECT_TRUE(request.given.empty());
}

TEST(VolumeOptions, TheGridIsAFileOrSevenNumbers) {
    EXPECT_EQ(parse_volume({"--grid", "pot.dx"}).grid_file, "pot.dx");
    const VolumeGrid grid = parse_volume({"--grid", "3,5,9,0.5,1,-2,10.25"}).grid.value();
    EXPECT_EQ(grid, (VolumeGrid{{3, 5, 9}, {0.5, -3.0, 8.25}, {0.5, 0.5, 0.5}}));
    for (const char* bad : {"3,5,9,0.5,1,2", "3,5,9,0,1,2,3", "0,5,9,0.5,1,2,3", "3.5,5,9,0.5,1,2,3", "pot"})
        EXPECT_NE(refusal({"--grid", bad}), "") << bad;
}

TEST(VolumeOptions, ReadsFieldsAndTheirNumbers) {
    const VolumeRequest request = parse_volume({"--field", "dielectric", "--eps", "4,80"});
    EXPECT_EQ(request.field.content, VolumeContent::Dielectric);
    EXPECT_EQ(request.field.inner_dielectric, 4.0);
    EXPECT_EQ(request.field.outer_dielectric, 80.0);
    for (const char* bad : {"4", "4,80,1", "0,80", "4,x"}) EXPECT_NE(refusal({"--eps", bad}), "") << bad;
    EXPECT_NE(refusal({"--field", "charge"}), "");
    EXPECT_NE(refusal({"--field", "ions", "--ion-radius", "-1"}), "");
    EXPECT_NE(refusal({"--maps", "delphi"}), "");
}

TEST(VolumeOptions, RefusesWhatHasNoEffect) {
    EXPECT_EQ(refusal({"--field", "mask"}, {"a.ply"}),
              "--field applies to volumes; ask for one with -o FILE.dx, FILE.mrc or FILE.vdb");
    EXPECT_NE(refusal({"--eps", "2,80"}), "");
    EXPECT_NE(refusal({"--ion-radius", "2"}), "");
    EXPECT_NE(refusal({"--maps", "apbs"}), "");  // no grid
    std::vector<std::string> both = kApbs;
    both.insert(both.end(), {"--field", "mask"});
    EXPECT_NE(refusal(both), "");
    EXPECT_EQ(refusal(kApbs, {"a.mrc"}), "a.mrc: APBS reads its maps as .dx; name a file with that suffix");
    EXPECT_EQ(refusal({"--field", "ions", "--ion-radius", "2"}), "");
}

TEST(VolumeOptions, ApbsGetsFourMapsForEachVolume) {
    std::vector<std::string> paths;
    for (const Output& output : plan(kApbs, {"x/a.dx", "b.ply"})) paths.push_back(output.path);
    EXPECT_EQ(paths, (std::vector<std::string>{"x/a_dielx.dx", "x/a_diely.dx", "x/a_dielz.dx", "x/a_kappa.dx", "b.ply",
                                               "b.atoms.csv"}));
}

TEST(VolumeOptions, TheReportHasWhatIsInForce) {
    nlohmann::ordered_json options = report_volumes(parse_volume({"--field", "ions"}), true);
    EXPECT_EQ(options["field"], "ions");
    EXPECT_EQ(options["ion_radius"], 2.0);
    EXPECT_TRUE(options["eps"].is_null());
    EXPECT_TRUE(options["grid"].is_null());
    options = report_volumes(parse_volume(kApbs), true);
    EXPECT_EQ(options["maps"], "apbs");
    EXPECT_EQ(options["grid"], "9,9,9,0.5,0,0,0");
    EXPECT_TRUE(options["field"].is_null());
    options = report_volumes(parse_volume({}), false);
    EXPECT_TRUE(options["field"].is_null());
}

}  // namespace meniscus::cli
