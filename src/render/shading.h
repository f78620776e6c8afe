// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// From a surface's colour, direction and sky to light, and from light to a pixel.
#pragma once

#include "meniscus/colour.h"
#include "render/view_frame.h"

namespace meniscus {

/// Linear light, not encoded; 1 is white.
struct Light {
    float red = 0.0F;
    float green = 0.0F;
    float blue = 0.0F;

    Light& operator+=(const Light& b) {
        red += b.red;
        green += b.green;
        blue += b.blue;
        return *this;
    }
};

inline Light operator+(Light a, const Light& b) { return a += b; }
inline Light operator*(float s, const Light& a) { return {s * a.red, s * a.green, s * a.blue}; }

/// (1 - share) a + share b.
inline Light mixed(const Light& a, const Light& b, float share) { return (1.0F - share) * a + share * b; }

/// The light that an sRGB colour stands for (IEC 61966-2-1).
Light to_light(const Colour& colour);

/// The nearest sRGB colour; light beyond white becomes white. opacity 0 to 1.
Colour to_colour(const Light& light, float opacity);

/// Lamps fixed to the viewer: the main one above to the left, a weak one to the right.
class Lamps {
public:
    explicit Lamps(const ViewFrame& frame);

    /// What a point sends to the viewer.
    /// albedo     share of the light that it sends back
    /// normal     unit vector, towards the viewer's side
    /// to_viewer  unit vector
    /// sky        share of the sky it sees, 0 to 1
    Light shade(const Light& albedo, const Vec3& normal, const Vec3& to_viewer, float sky) const;

private:
    Vec3 up_;
    Vec3 key_;
    Vec3 fill_;
};

}  // namespace meniscus
