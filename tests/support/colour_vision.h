// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How far apart two colours look, to people who see all colours and to those who do not.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <span>

#include "core/srgb.h"
#include "meniscus/colour.h"
#include "meniscus/vec3.h"

namespace meniscus::testing {

/// Linear red, green and blue as seen without one kind of cones.
/// source   Machado, Oliveira & Fernandes, IEEE TVCG 15, 2009, 1291-1298, severity 1
struct Vision {
    const char* name;
    std::array<Vec3, 3> rows;
};
inline constexpr std::array kVisions{
    Vision{"usual", {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
    Vision{"protanopia",
           {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}}},
    Vision{"deuteranopia",
           {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}}},
    Vision{"tritanopia",
           {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}},
};

/// CIE L*a*b* under D65.
struct Lab {
    double l = 0.0;
    double a = 0.0;
    double b = 0.0;
};

inline Lab seen(const Colour& colour, const Vision& vision) {
    const Vec3 linear{linear_from_srgb(colour.red / 255.0), linear_from_srgb(colour.green / 255.0),
                      linear_from_srgb(colour.blue / 255.0)};
    const auto channel = [&](std::size_t i) { return std::clamp(dot(vision.rows[i], linear), 0.0, 1.0); };
    const Vec3 light{channel(0), channel(1), channel(2)};
    const auto f = [&](const Vec3& row, double white) {
        const double t = dot(row, light) / white;
        return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
    };
    const double x = f({0.4124564, 0.3575761, 0.1804375}, 0.95047);
    const double y = f({0.2126729, 0.7151522, 0.0721750}, 1.0);
    const double z = f({0.0193339, 0.1191920, 0.9503041}, 1.08883);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

/// CIEDE2000 (Sharma, Wu & Dalal, Color Res. Appl. 30, 2005, 21-30); 1 is just noticeable side by side.
inline double difference(const Lab& p, const Lab& q) {
    constexpr double kDegree = std::numbers::pi / 180.0;
    const auto seventh = [](double c) { return std::sqrt(std::pow(c, 7) / (std::pow(c, 7) + std::pow(25.0, 7))); };
    const double g = 0.5 * (1.0 - seventh(0.5 * (std::hypot(p.a, p.b) + std::hypot(q.a, q.b))));
    const double c1 = std::hypot((1.0 + g) * p.a, p.b);
    const double c2 = std::hypot((1.0 + g) * q.a, q.b);
    const auto hue = [g](const Lab& c) { return std::atan2(c.b, (1.0 + g) * c.a) / kDegree; };
    const double turn = c1 * c2 == 0.0 ? 0.0 : std::remainder(hue(q) - hue(p), 360.0);
    const double dh = 2.0 * std::sqrt(c1 * c2) * std::sin(0.5 * turn * kDegree);
    double h = hue(p) + 0.5 * turn;
    if (c1 * c2 == 0.0) h = c1 == 0.0 ? hue(q) : hue(p);
    if (h < 0.0) h += 360.0;
    const double l = 0.5 * (p.l + q.l) - 50.0;
    const double c = 0.5 * (c1 + c2);
    const double t = 1.0 - 0.17 * std::cos((h - 30.0) * kDegree) + 0.24 * std::cos(2.0 * h * kDegree) +
                     0.32 * std::cos((3.0 * h + 6.0) * kDegree) - 0.20 * std::cos((4.0 * h - 63.0) * kDegree);
    const double in_l = (q.l - p.l) / (1.0 + 0.015 * l * l / std::sqrt(20.0 + l * l));
    const double in_c = (c2 - c1) / (1.0 + 0.045 * c);
    const double in_h = dh / (1.0 + 0.015 * c * t);
    const double rotation = 60.0 * std::exp(-std::pow((h - 275.0) / 25.0, 2));
    const double mixed = -2.0 * seventh(c) * std::sin(rotation * kDegree);
    return std::sqrt(in_l * in_l + in_c * in_c + in_h * in_h + mixed * in_c * in_h);
}

/// Of the two most alike, in the eyes of those who can tell them apart least.
inline double smallest_difference(std::span<const Colour> colours) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Vision& vision : kVisions)
        for (std::size_t i = 0; i < colours.size(); ++i)
            for (std::size_t j = 0; j < i; ++j)
                smallest = std::min(smallest, difference(seen(colours[i], vision), seen(colours[j], vision)));
    return smallest;
}

}  // namespace meniscus::testing
