// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "progress_report.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

namespace meniscus::cli {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
    std::istringstream in(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

}  // namespace

TEST(ProgressReport, WritesNothingWhenOff) {
    std::ostringstream out;
    {
        ProgressReport progress(ProgressMode::Off, out);
        progress.update("flow", 0.5);
    }
    EXPECT_EQ(out.str(), "");
}

TEST(ProgressReport, WritesOneJsonLinePerUpdate) {
    std::ostringstream out;
    {
        ProgressReport progress(ProgressMode::Json, out);
        progress.update("band", 0.25);
        progress.update("band", 0.25);
        progress.update("flow", 2.0);
        progress.update("mesh", std::numeric_limits<double>::quiet_NaN());
    }
    const std::vector<std::string> lines = lines_of(out.str());
    ASSERT_EQ(lines.size(), 3u);
    const auto first = nlohmann::json::parse(lines[0]);
    EXPECT_EQ(first["stage"], "band");
    EXPECT_EQ(first["fraction"], 0.25);
    EXPECT_GE(first["time_s"], 0.0);
    EXPECT_EQ(nlohmann::json::parse(lines[1])["fraction"], 1.0);
    EXPECT_EQ(nlohmann::json::parse(lines[2])["fraction"], 0.0);
}

TEST(ProgressReport, TellsHowLongItWillTakeOnceItIsKnown) {
    std::ostringstream json;
    ProgressReport lines(ProgressMode::Json, json);
    lines.expect(2.5);
    lines.update("band", 0.25);
    EXPECT_EQ(nlohmann::json::parse(json.str())["expected_s"], 2.5);
    std::ostringstream screen;
    ProgressReport bar(ProgressMode::On, screen);
    bar.expect(12.4);
    bar.update("band", 0.25);
    EXPECT_TRUE(screen.str().ends_with(" 25 %, about 12 s in all")) << screen.str();
}

TEST(ProgressReport, TakesTheBarAwayAtTheEnd) {
    std::ostringstream out;
    {
        ProgressReport progress(ProgressMode::On, out);
        progress.update("flow", 0.5);
        EXPECT_EQ(out.str(), "\rflow      [" + std::string(20, '#') + std::string(20, ' ') + "]  50 %");
    }
    EXPECT_TRUE(out.str().ends_with("\r\033[K"));
}

TEST(ProgressReport, DecidesAutoOnly) {
    EXPECT_EQ(resolve(ProgressMode::Auto, true), ProgressMode::Off);
    EXPECT_EQ(resolve(ProgressMode::On, true), ProgressMode::On);
    EXPECT_EQ(resolve(ProgressMode::Json, false), ProgressMode::Json);
}

}  // namespace meniscus::cli
