// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// All that is measured of a finished surface, in one pass over its triangles.
#pragma once

#include <cstdint>
#include <vector>

#include "measure/corrected.h"
#include "meniscus/mesh.h"

namespace meniscus {

/// What corrected measures take the creases of a surface for.
enum class Creases : std::uint8_t {
    Sharp,    ///< followed, where the mesh has the curvatures to know them by (measure/creases.h)
    Rounded,  ///< smooth, as a level set leaves them
};

struct SurfaceMeasures {
    MeshMeasures mesh;            ///< as measure_mesh
    CorrectedMeasures corrected;  ///< as corrected_measures, by normals, but over creases that are sharp
    std::vector<float> areas;     ///< per vertex: a third of the areas of the triangles around, Å²
};

/// Numbers the pieces in mesh.components anew, in the final order of what they measure (mesh/components.h).
///
/// throws   UsageError for a mesh without normals or components, and as measure_mesh
/// cost     O(n) for n triangles, 4 bytes of scratch memory each beside those of examine_topology
SurfaceMeasures measure_surface(Mesh& mesh, Creases creases);

/// Sum of the areas of the triangles, Å²: positions and triangles are all that is needed.
double flat_area(const Mesh& mesh);

}  // namespace meniscus
