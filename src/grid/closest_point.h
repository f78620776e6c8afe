// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The point of a spline's zero set that is closest to a given point; see LevelSet::closest_point.
#pragma once

#include "grid/spline_cursor.h"
#include "meniscus/vec3.h"

namespace meniscus {

/// Starts at `point` and, where that fails, around it. NaN where nothing is found.
Vec3 closest_point(SplineCursor& cursor, const Vec3& point, double spacing);

/// Starts at `start` only.
Vec3 closest_point_from(SplineCursor& cursor, const Vec3& point, const Vec3& start, double spacing);

}  // namespace meniscus
