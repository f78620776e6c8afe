// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// From an extracted zero set to a labelled mesh whose vertices lie on the surface, and how far that is from the exact
// one.
#pragma once

#include "geometry/accessible_surface.h"
#include "measure/triangle_survey.h"
#include "meniscus/level_set.h"
#include "meniscus/mesh.h"
#include "meniscus/mesh_quality.h"
#include "meniscus/surface.h"

namespace meniscus {

struct SurfaceMesh {
    Mesh mesh;
    TriangleSurvey survey;  ///< of the mesh as it is
    DistanceSummary distance;
};

struct MeshingOptions {
    double spacing = 0.0;         ///< of the grid that the zero set was extracted from, Å
    double edge = 0.0;            ///< that triangles were made even with, Å; 0: they are those of the grid
    Pieces pieces = Pieces::All;  ///< what is kept of the zero set
};

/// zero_set    as extract_zero_set gives it; the few bad triangles that are left on the surface are mended
/// level_set   whose zero set it is: vertices are projected onto that; null: onto the exact SES
/// returns     all vertex arrays but the areas; measure_surface gives those and the pieces their final order
SurfaceMesh mesh_surface(const AccessibleSurface& accessible, Mesh zero_set, const LevelSet* level_set,
                         const MeshingOptions& options);

/// The survey that measures of a mesh are made of, for one whose vertices lie on the zero set of a level set, or near
/// it.
TriangleSurvey survey_of(const Mesh& mesh, const LevelSet* level_set);

/// How far the vertices of a mesh are from the exact SES.
DistanceSummary distance_of_vertices(const AccessibleSurface& accessible, const Mesh& mesh);

}  // namespace meniscus
