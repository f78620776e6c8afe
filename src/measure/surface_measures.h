// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// All that is measured of a finished surface.
#pragma once

#include <cstdint>
#include <vector>

#include "measure/corrected.h"
#include "measure/triangle_survey.h"
#include "meniscus/mesh.h"

namespace meniscus {

/// What corrected measures take the creases of a surface for.
enum class Creases : std::uint8_t {
    Sharp,    ///< followed, where the mesh has the curvatures to know them by (measure/creases.h)
    Rounded,  ///< smooth, as a level set leaves them
};

/// Whether the triangles round every vertex are looked at (measure/topology.h).
enum class Stars : std::uint8_t {
    Examined,
    Trusted,  ///< the mesh is a manifold by the way it was made: only whether it is closed is looked at
};

struct SurfaceMeasures {
    MeshMeasures mesh;            ///< as measure_mesh
    CorrectedMeasures corrected;  ///< as corrected_measures, by normals, but over creases that are sharp
    std::vector<float> areas;     ///< per vertex: a third of the areas of the triangles around, Å²
};

/// The pass over the triangles of a surface with normals and components, for measure_surface.
///
/// throws   UsageError for a mesh without normals or components, and as measure_mesh
TriangleSurvey survey_surface(const Mesh& mesh, Creases creases, const TriangleLook& look = {});

/// Numbers the pieces in mesh.components anew, in the final order of what they measure (mesh/components.h).
///
/// survey   of the mesh as it is, with parts
/// throws   as measure_mesh
/// cost     O(n) for n triangles, beside examine_topology
SurfaceMeasures measure_surface(Mesh& mesh, const TriangleSurvey& survey, Stars stars);

/// Sum of the areas of the triangles, Å²: positions and triangles are all that is needed.
double flat_area(const Mesh& mesh);

/// Length of the longest edge, Å; 0 of a mesh without triangles.
double longest_edge_of(const Mesh& mesh);

}  // namespace meniscus
