// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How far two surfaces are from each other: meshes of any program, and the exact surfaces of atoms.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "meniscus/atoms.h"
#include "meniscus/exact_surface.h"
#include "meniscus/mesh.h"

namespace meniscus {

/// One of two surfaces to compare, with what it measures by itself.
struct ComparedSurface {
    Mesh mesh;                            ///< points are taken from its triangles
    std::optional<ExactSurface> exact{};  ///< of atoms: points are moved onto the SES, and distances are to it
    double area = 0.0;                    ///< Å²; of atoms exact, else the sum over triangles
    double volume = 0.0;                  ///< Å³; the same
    std::size_t outer_pieces = 0;         ///< connected pieces whose normals point outwards
    std::size_t cavities = 0;             ///< and those whose normals point inwards
    bool closed = false;                  ///< see MeshMeasures; true of atoms, as is manifold
    bool manifold = false;
    std::size_t merged_vertices = 0;  ///< see mesh_to_compare()
};

/// A mesh as it is; or, if it is not closed, with vertices at the same place made one and unused ones dropped, as
/// programs write them that give every triangle corners of its own. Then other vertex arrays are dropped, too.
///
/// throws   UsageError for coordinates that are not finite or beyond kFarthestCoordinate (mesh.h)
ComparedSurface mesh_to_compare(Mesh mesh);

struct StructureToCompare {
    double probe = 1.4;    ///< Å; 0 gives the van der Waals surface
    double spacing = 0.5;  ///< of the grid of the mesh that points are taken from, Å
    int threads = 0;       ///< 0: all cores
};

/// The exact SES of atoms, with the mesh that Method::Direct makes of it.
/// throws   as compute_surface()
ComparedSurface structure_to_compare(const Atoms& atoms, const StructureToCompare& options = {});

/// Distances from one surface to another, Å; absolute values but for signed_mean. Means are weighted by area.
struct OneWayDistance {
    double mean = 0.0;
    double p99 = 0.0;          ///< 99 % of the area are nearer
    double max = 0.0;          ///< vertices included
    double signed_mean = 0.0;  ///< positive where the points lie outside the other surface
    std::size_t points = 0;    ///< without the vertices
};

struct Comparison {
    OneWayDistance a_to_b;
    OneWayDistance b_to_a;
    std::vector<float> distances;  ///< signed, of A's vertices to B, Å

    double hausdorff() const { return std::max(a_to_b.max, b_to_a.max); }
};

struct CompareOptions {
    double density = 10.0;  ///< points per Å² at least; no triangle has fewer than four
    int threads = 0;        ///< 0: all cores; results do not depend on it
};

/// Distances between two surfaces, both ways.
///
/// Every triangle is divided into n² equal ones, n = max(2, ceil(sqrt(density area))), whose centroids stand for them.
/// Distances to a mesh are exact; their sign is that of the nearest point's normal (at edges and corners the normal
/// weighted by angles), so it means outside and inside where the other mesh is closed and oriented. Distances to a SES
/// are those of signed_distance().
///
/// throws   UsageError for a mesh without triangles or area, or options out of range; LimitError for more points than
///          fit into memory
/// cost     some µs per point, parallel
/// source   sign: Bærentzen & Aanæs 2005, IEEE Trans. Vis. Comput. Graph. 11, 243-253
Comparison compare_surfaces(const ComparedSurface& a, const ComparedSurface& b, const CompareOptions& options = {});

}  // namespace meniscus
