// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "picture_options.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "common_request.h"
#include "meniscus/errors.h"
#include "parse_options.h"

namespace meniscus::cli {

namespace {

PictureRequest parse_picture(const std::vector<std::string>& words) { return request_of(words, add_picture_options); }

std::string refusal(const std::vector<std::string>& arguments) {
    try {
        parse_picture(arguments);
    } catch (const UsageError& error) {
        return error.what();
    }
    return "";
}

}  // namespace

TEST(PictureOptions, HasTheDefaultsOfTheLibrary) {
    const PictureRequest request = parse_picture({});
    EXPECT_EQ(request.colours, ColourOptions{});
    EXPECT_EQ(request.picture, PictureOptions{});
    EXPECT_EQ(request.drawn_by, "");
}

TEST(PictureOptions, TakesValuesOfAllKinds) {
    const PictureRequest request = parse_picture({"--color", "curvature:-0.5:.25", "--size", "320x200", "--background",
                                                  "#0a0BfF", "--perspective", "--outline", "--depth-cue", "0.5"});
    EXPECT_EQ(request.colours.scheme, ColourScheme::Curvature);
    EXPECT_EQ(request.colours.range, (ValueRange{-0.5, 0.25}));
    EXPECT_EQ(request.picture.width, 320);
    EXPECT_EQ(request.picture.height, 200);
    EXPECT_EQ(request.picture.background, (Colour{10, 11, 255, 255}));
    EXPECT_EQ(request.picture.projection, Projection::Perspective);
    EXPECT_TRUE(request.picture.outline);
    EXPECT_EQ(request.picture.depth_cue, 0.5);
    EXPECT_NE(request.drawn_by, "");
    EXPECT_EQ(parse_picture({"--color", "patch"}).drawn_by, "");
    EXPECT_EQ(parse_picture({"--background", "transparent"}).picture.background, kTransparent);
    EXPECT_EQ(parse_picture({"--background", "navy"}).picture.background, (Colour{0, 0, 128}));
}

TEST(PictureOptions, LigandsAreDrawnOrNot) {
    EXPECT_TRUE(parse_picture({}).ligands);
    EXPECT_TRUE(parse_picture({"--draw", "ligands"}).ligands);
    const PictureRequest none = parse_picture({"--draw", "none"});
    EXPECT_FALSE(none.ligands);
    EXPECT_EQ(none.shown_by, "--draw");
    EXPECT_EQ(none.drawn_by, "") << "pages and GLB heed it, too";
    EXPECT_EQ(report_picture(none, {}, {}, false)["draw"], "none");
    EXPECT_EQ(refusal({"--draw", "waters"}), "--draw: unknown value 'waters'; choose one of ligands, none");
}

TEST(PictureOptions, OneColourIsANameOrSixDigits) {
    for (const char* text : {"tomato", "#ff6347"}) {
        const PictureRequest request = parse_picture({"--color", text});
        EXPECT_EQ(request.colours.scheme, ColourScheme::Single);
        EXPECT_EQ(request.colours.colour, (Colour{255, 99, 71}));
        nlohmann::ordered_json options = report_picture(request, {}, {}, false);
        EXPECT_EQ(options["color"], "#ff6347");
    }
    EXPECT_EQ(parse_picture({"--color", "gold:0:1"}).colours.value, "gold");
    EXPECT_EQ(refusal({"--color", "#ff634"}),
              "--color: '#ff634' is not a colour; write six hexadecimal digits, as in '#ff6347'");
}

TEST(PictureOptions, ViewsAreWordsOrDirections) {
    EXPECT_FALSE(parse_picture({"--view", "auto"}).picture.viewpoint.has_value());
    EXPECT_EQ(parse_picture({"--view", "left"}).picture.viewpoint->from, (Vec3{-1, 0, 0}));
    const Viewpoint given = parse_picture({"--view", "-1,.5,2e1:0,0,-1"}).picture.viewpoint.value();
    EXPECT_EQ(given.from, (Vec3{-1, 0.5, 20}));
    EXPECT_EQ(given.up, (Vec3{0, 0, -1}));
    EXPECT_EQ(parse_picture({"--view", "1,2,3"}).picture.viewpoint->up, (Vec3{0, 1, 0}));
    EXPECT_EQ(parse_picture({"--view", "0,3,0"}).picture.viewpoint->up,
              parse_picture({"--view", "top"}).picture.viewpoint->up);
    EXPECT_EQ(parse_picture({"--view", "0,-3,0"}).picture.viewpoint->up,
              parse_picture({"--view", "bottom"}).picture.viewpoint->up);
}

TEST(PictureOptions, CutsAreWordsDepthsOrPlanes) {
    EXPECT_EQ(parse_picture({"--cut", "auto"}).picture.cut, Cut{});
    EXPECT_EQ(parse_picture({"--cut", "cavity:3"}).picture.cut, (Cut{.through = Cut::Through::Cavity, .cavity = 3}));
    EXPECT_EQ(parse_picture({"--cut", "12.5"}).picture.cut, (Cut{.through = Cut::Through::Depth, .depth = 12.5}));
    const Cut point{.through = Cut::Through::Point, .point = {-1, 2, 3}};
    EXPECT_EQ(parse_picture({"--cut", "-1,2,3"}).picture.cut, point);
    Cut plane = point;
    plane.normal = Vec3{0, -1, 0};
    const PictureRequest request = parse_picture({"--cut", "-1,2,3:0,-1,0"});
    EXPECT_EQ(request.picture.cut, plane);
    EXPECT_EQ(request.drawn_by, "--cut");
    nlohmann::ordered_json options = report_picture(request, {}, {}, true);
    EXPECT_EQ(options["cut"], "-1,2,3:0,-1,0");
    for (const auto& none : {parse_picture({}), parse_picture({"--cut", "none"})}) {
        EXPECT_FALSE(none.picture.cut);
        options = report_picture(none, {}, {}, true);
        EXPECT_TRUE(options["cut"].is_null());
    }
}

TEST(PictureOptions, WhatMakesNoSenseIsRefusedWithItsOption) {
    for (const char* text :
         {"", "2fancy", "patch:1:2", "depth:2:1", "depth:1", "depth:1:2:3", "depth:a:b", "depth:0:inf"})
        EXPECT_TRUE(refusal({"--color", text}).starts_with("--color: ")) << text;
    for (const char* text : {"", "sideways", "1,2", "1,2,3,4", "0,0,0", "0,0,1:0,0,2", "0,0,1:", "nan,0,1", "1,2,x"})
        EXPECT_TRUE(refusal({"--view", text}).starts_with("--view: ")) << text;
    for (const char* text : {"", "100", "100x", "x100", "0x5", "-1x5", "1.5x2", "16385x1", "2x3x4", "100X100"})
        EXPECT_TRUE(refusal({"--size", text}).starts_with("--size: ")) << text;
    for (const char* text : {"", "reddish", "#12", "#12345g", "#1234567", "123456"})
        EXPECT_TRUE(refusal({"--background", text}).starts_with("--background: ")) << text;
    for (const char* text : {"", "middle", "cavity", "cavity:", "cavity:0", "cavity:x", "-1", "nan", "1,2", "1,2,3,4",
                             "1,2,3:", "1,2,3:0,0,0", "1,2,x"})
        EXPECT_TRUE(refusal({"--cut", text}).starts_with("--cut: ")) << text;
    for (const char* text : {"", "-0.1", "1.01", "nan"})
        EXPECT_TRUE(refusal({"--depth-cue", text}).starts_with("--depth-cue: ")) << text;
}

TEST(PictureOptions, ALegendNeedsRoom) {
    EXPECT_TRUE(parse_picture({"--legend"}).legend);
    EXPECT_NO_THROW(check_picture(parse_picture({"--legend", "--size", "320x240"})));
    EXPECT_NO_THROW(check_picture(parse_picture({"--size", "64x48"})));
    EXPECT_THROW(check_picture(parse_picture({"--legend", "--size", "319x240"})), UsageError);
    EXPECT_THROW(check_picture(parse_picture({"--legend", "--size", "320x239"})), UsageError);
}

TEST(PictureOptions, TheReportHasWhatIsInForce) {
    nlohmann::ordered_json options = report_picture(parse_picture({"--view", "top", "--size", "3x4"}), {}, {}, true);
    EXPECT_EQ(options["color"], "single");
    EXPECT_TRUE(options["color_range"].is_null());
    EXPECT_EQ(options["view"], "top");
    EXPECT_EQ(options["size"], (nlohmann::ordered_json{3, 4}));
    EXPECT_EQ(options["background"], "#ffffff");
    options = report_picture(parse_picture({"--color", "curvature"}), {}, {}, false);
    EXPECT_EQ(options["color_range"], (nlohmann::ordered_json{-0.7, 0.7}));
    EXPECT_TRUE(options["size"].is_null());
}

}  // namespace meniscus::cli
