// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/shading.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/srgb.h"

namespace meniscus {
namespace {

constexpr Light kGrey{0.5F, 0.5F, 0.5F};
constexpr Vec3 kTowards{0, 0, 1};

TEST(Shading, EveryColourSurvivesTheWayToLightAndBack) {
    for (int i = 0; i < 256; ++i) {
        const Colour c{static_cast<std::uint8_t>(i), static_cast<std::uint8_t>(255 - i), 77, 255};
        EXPECT_EQ(to_colour(to_light(c), 1.0F), c);
    }
}

TEST(Shading, LightBecomesTheNearestByte) {
    const auto expect_nearest = [](float light) {
        const double encoded = srgb_from_linear(std::clamp(static_cast<double>(light), 0.0, 1.0));
        EXPECT_EQ(to_colour({light, light, light}, 1.0F).green, std::lround(255.0 * encoded)) << light;
    };
    for (int i = -100; i <= 70000; ++i) expect_nearest(static_cast<float>(i) / 65536.0F);
    for (int i = 0; i < 255; ++i) {  // about where one byte ends and the next begins
        const auto border = static_cast<float>(linear_from_srgb((i + 0.5) / 255.0));
        for (float light = border * (1.0F - 1e-6F); light < border * (1.0F + 1e-6F);
             light = std::nextafter(light, 2.0F))
            expect_nearest(light);
    }
}

TEST(Shading, LightIsLinear) {
    EXPECT_NEAR(to_light({188, 188, 188, 255}).red, 0.5, 0.01);
    EXPECT_EQ(to_colour({2.0F, -1.0F, 0.0F}, 0.5F), (Colour{255, 0, 0, 128}));
}

TEST(Shading, TheMainLampIsAboveToTheLeft) {
    const Lamps lamps{ViewFrame{}};
    const auto brightness = [&](const Vec3& normal) {
        return lamps.shade(kGrey, normalised(normal), kTowards, 1.0F).green;
    };
    EXPECT_GT(brightness({-1, 1, 2}), brightness({1, 1, 2}));
    EXPECT_GT(brightness({-1, 1, 2}), brightness({-1, -1, 2}));
    EXPECT_GT(brightness({1, -1, 0.2}), 0.0F);
}

TEST(Shading, HollowsAreDarkerAndNothingIsWhiterThanItself) {
    const Lamps lamps{ViewFrame{}};
    const Light open = lamps.shade(kGrey, kTowards, kTowards, 1.0F);
    const Light closed = lamps.shade(kGrey, kTowards, kTowards, 0.0F);
    EXPECT_LT(closed.red, 0.5F * open.red);
    EXPECT_GT(closed.red, 0.0F);
    EXPECT_NEAR(open.red, 0.5, 0.1);
}

TEST(Shading, LampsTurnWithTheViewer) {
    const Lamps lamps(frame_of({.from = {1, 0, 0}, .up = {0, 0, 1}}));
    const Lamps unturned{ViewFrame{}};
    EXPECT_NEAR(lamps.shade(kGrey, {1, 0, 0}, {1, 0, 0}, 0.7F).red, unturned.shade(kGrey, kTowards, kTowards, 0.7F).red,
                1e-6);
}

}  // namespace
}  // namespace meniscus
