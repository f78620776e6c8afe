// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Even triangles on a surface, and what the surface under them measures.
#pragma once

#include "measure/corrected.h"
#include "meniscus/mesh.h"
#include "meniscus/remesh.h"
#include "meniscus/surface.h"
#include "remesh/remesher.h"

namespace meniscus {

struct EvenMesh {
    Mesh mesh;
    SimplifiedTopology simplified;
};

/// What is wanted of the corners, but Near only where that can be kept to: not for an envelope, which is nowhere near
/// the exact surface, and not with ridges, whose vertices are to stay there.
Corners corners_of(const SurfaceOptions& options);

/// Makes the triangles of a mesh even, and simplifies the topology if that is asked for.
///
/// A surface with room for few triangles only may be left with bad ones, or with none on a bulge behind a neck that is
/// narrower than an edge. There triangles of somewhat other sizes are tried, too, until all edges, angles and the area
/// are right, and the best are taken.
///
/// cost  as remesh(); up to thirteen times that for surfaces of 5 to 110 edge²
EvenMesh make_even(Mesh zero_set, const RemeshOptions& wanted, const SurfaceProjector& project);

/// Area and volume of the surface under large triangles: the middles of their sides are looked for.
///
/// mesh  with normals
/// edge  Å: as RemeshOptions
CorrectedMeasures corrected_on_surface(const Mesh& mesh, double edge, const SurfaceProjector& project);

}  // namespace meniscus
