// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The projection of points onto the surface, for those who change the mesh.
#pragma once

#include <cstdint>
#include <span>

#include "geometry/accessible_surface.h"
#include "meniscus/level_set.h"
#include "nearest/local_features.h"
#include "remesh/remesher.h"

namespace meniscus {

/// A point so near to the exact SES lies on it, Å.
inline constexpr double kOnSurface = 1e-9;

/// So many steps along the distance lead there. One is enough but next to ridges, where the distance is a lower bound.
/// All projections take as many: a point that one has left short would be moved by the next one.
inline constexpr int kStepsToSurface = 60;

/// Takes steps to the exact surface until the point lies on it, kStepsToSurface less those taken before at most.
/// Returns what is nearest to where it ends.
///
/// near    gathered round the point: quick as long as it stays there
NearestFeature walk_to_surface(const LocalFeatures& near, Vec3& point, int taken);
/// The same where it is known what is nearest to the point.
NearestFeature walk_from(const LocalFeatures& near, Vec3& point, NearestFeature nearest, int taken);

/// Whether the projector tells curvatures. Those of a level set cost a third of its time.
enum class Curvatures : std::uint8_t { FilledIn, LeftOut };

/// Moves points onto the surface, in parallel.
void put_on_surface(std::span<Vec3> points, const SurfaceProjector& project);

/// Onto the zero set of a level set, or, where that is null, onto the exact SES. Both must outlive the projector.
///
/// spacing  of the grid, Å, that the points come from: curvatures are told up to its inverse
/// cost     0.3 to 0.5 µs per point, if neighbours come together
SurfaceProjector surface_projector(const AccessibleSurface& accessible, const LevelSet* level_set, double spacing,
                                   Curvatures curvatures);

}  // namespace meniscus
