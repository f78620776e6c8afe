// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What every surface is held against before it is handed out.
#pragma once

#include <cstddef>
#include <span>

#include "exact/piece_points.h"
#include "grid/block_grid.h"
#include "grid/inside_bits.h"
#include "meniscus/surface.h"
#include "pipeline/reference_values.h"

namespace meniscus {

/// What the volume of a mesh may differ by from the exact one, Å³, beside pieces that the grid does not resolve.
///
/// area   exact, of what is meshed, Å²
double volume_error_bound(const SurfaceOptions& options, double area);

/// How many points are on the wrong side of a level set: by its sign there, or beyond the band by how a ray first
/// crosses the zero set.
std::size_t count_wrong(std::span<const DeepPoint> points, const LevelSet& level_set);

/// The same of the nodes of a grid: by the first node straight above, if there is any.
///
/// Precondition: points are more than a spacing away from the surface.
std::size_t count_wrong(std::span<const DeepPoint> points, const BlockGrid& grid, std::span<const InsideBits> inside);

/// The same of a closed mesh, such as the whole zero set before anything is dropped from it.
std::size_t count_wrong(std::span<const DeepPoint> points, const Mesh& mesh);

/// "pieces": passed if no point is on the wrong side.
Check pieces_check(std::size_t wrong);

/// "sides": the same of points that do not stand for pieces.
Check sides_check(std::size_t wrong);

/// "volume": the difference between the corrected volume of the mesh and the exact one.
Check volume_check(const Surface& surface, const ReferenceValues& reference);

/// The checks that every mesh must pass: "not_empty" (if something must be there), "closed", "manifold", "converged" of
/// a flow, and but for the Gaussian envelope "mean_distance".
std::vector<Check> mesh_checks(const Surface& surface);

}  // namespace meniscus
