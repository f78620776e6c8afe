// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "value_options.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "meniscus/errors.h"
#include "parse_options.h"

namespace meniscus::cli {
namespace {

ValueRequest parse_values(const std::vector<std::string>& words) { return request_of(words, add_value_options); }

TEST(ValueOptions, MapsHaveANameAndAFile) {
    const ValueRequest request =
        parse_values({"--sample", "phi=a=b.dx", "--sample", "rho=c.mrc", "--interpolation", "cubic"});
    ASSERT_EQ(request.maps.size(), 2U);
    EXPECT_EQ(request.maps[0].name, "phi");
    EXPECT_EQ(request.maps[0].path, "a=b.dx");
    EXPECT_EQ(request.maps[1].name, "rho");
    EXPECT_EQ(request.sampling.interpolation, Interpolation::Cubic);
    for (const char* wrong : {"pot.dx", "=pot.dx", "phi=", "area=pot.dx", "depth=pot.dx", "a b=pot.dx"})
        EXPECT_THROW(parse_values({"--sample", wrong}), UsageError) << wrong;
}

TEST(ValueOptions, WhatShapesMapsNeedsOne) {
    EXPECT_NO_THROW(check_values(parse_values({"--sample", "phi=a.dx", "--offset", "-1"}), {}));
    EXPECT_THROW(check_values(parse_values({"--offset", "1"}), {}), UsageError);
    EXPECT_THROW(check_values(parse_values({"--interpolation", "cubic"}), {}), UsageError);
}

TEST(ValueOptions, ColoursMustNameValuesThatMayCome) {
    const ColourOptions by_phi{.scheme = ColourScheme::Value, .value = "phi"};
    EXPECT_NO_THROW(check_values(parse_values({"--sample", "phi=a.dx"}), by_phi));
    EXPECT_NO_THROW(check_values(parse_values({"--values", "a.csv"}), by_phi)) << "its columns are not known yet";
    EXPECT_THROW(check_values(parse_values({"--sample", "psi=a.dx"}), by_phi), UsageError);
    EXPECT_THROW(check_values(parse_values({}), by_phi), UsageError);
}

TEST(ValueOptions, TheReportTellsThem) {
    nlohmann::ordered_json options =
        report_values(parse_values({"--sample", "phi=a.dx", "--values", "b.csv", "--offset", "1.5"}));
    EXPECT_EQ(options["sample"]["phi"], "a.dx");
    EXPECT_EQ(options["offset"], 1.5);
    EXPECT_EQ(options["interpolation"], "linear");
    EXPECT_EQ(options["values"][0], "b.csv");
    options = report_values(parse_values({}));
    EXPECT_TRUE(options["offset"].is_null());
    EXPECT_TRUE(options["sample"].empty());
}

}  // namespace
}  // namespace meniscus::cli
