// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Which way a picture looks: the directions that are right, up and towards the viewer.
#pragma once

#include <span>

#include "meniscus/picture.h"

namespace meniscus {

/// Unit vectors, right-handed.
struct ViewFrame {
    Vec3 right{1.0, 0.0, 0.0};
    Vec3 up{0.0, 1.0, 0.0};
    Vec3 towards{0.0, 0.0, 1.0};
};

/// throws   UsageError for vectors that are zero, parallel or not finite
ViewFrame frame_of(const Viewpoint& viewpoint);

/// The longest principal axis to the right, the second up; up and towards the viewer is where the points reach farther
/// (third moment). Turns with the points; coordinate axes where the points have no longest axis.
/// cost     O(n)
ViewFrame principal_frame(std::span<const Vec3> points);

}  // namespace meniscus
