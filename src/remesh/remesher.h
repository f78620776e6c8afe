// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Even triangles of a chosen size on a surface that is known better than the mesh knows it.
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "meniscus/mesh.h"
#include "meniscus/remesh.h"

namespace meniscus {

/// What a surface is like at one of its points.
struct SurfacePoint {
    Vec3 position;
    Vec3 normal;             ///< unit vector pointing out
    double curvature = 0.0;  ///< the largest principal curvature without its sign, Å^-1
};

/// Moves points that lie near a surface onto it and fills in the rest. Called from several threads at once; must give
/// the same result for the same point.
using SurfaceProjector = std::function<void(std::span<SurfacePoint>)>;

/// Isotropic remeshing: edges are split, collapsed and flipped, vertices relaxed along the surface and put back on it,
/// and what triangles with small angles are left are mended one by one.
///
/// mesh      closed oriented 2-manifold on the surface; its vertex arrays are not used
/// returns   positions and triangles: a closed oriented 2-manifold of the same topology
/// throws    as HalfEdges; UsageError where folds narrower than an edge crumple a large part of the mesh
/// cost      O(n) in the larger of both numbers of vertices
/// source    Botsch & Kobbelt 2004, A remeshing approach to multiresolution modeling
Mesh remesh(const Mesh& mesh, const RemeshOptions& options, const SurfaceProjector& project);

}  // namespace meniscus
