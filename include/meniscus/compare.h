// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Distances between two surfaces: meshes of any program, and exact surfaces of atoms.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "meniscus/atoms.h"
#include "meniscus/exact_surface.h"
#include "meniscus/mesh.h"

namespace meniscus {

/// One of two surfaces to compare, with its own measures.
struct ComparedSurface {
    Mesh mesh;                            ///< its triangles provide the points at which distances are measured
    std::optional<ExactSurface> exact{};  ///< if present, points are moved onto this surface, and distances are to it
    double area = 0.0;                    ///< Å²; exact if `exact` is present, else the sum over triangles
    double volume = 0.0;                  ///< Å³; exact if `exact` is present, else the sum over triangles
    std::size_t outer_pieces = 0;         ///< connected pieces whose normals point outwards
    std::size_t cavities = 0;             ///< connected pieces whose normals point inwards
    bool closed = false;                  ///< see MeshMeasures; true if `exact` is present
    bool manifold = false;                ///< see MeshMeasures; true if `exact` is present
    std::size_t merged_vertices = 0;      ///< number of vertices that mesh_to_compare() has merged with others
};

/// Takes a closed mesh as it is. In any other, vertices at the same place are merged, since some programs give every
/// triangle corners of its own; unused vertices and all other vertex arrays are dropped.
///
/// throws   UsageError for coordinates that are not finite or beyond kFarthestCoordinate (mesh.h)
ComparedSurface mesh_to_compare(Mesh mesh);

/// How the exact surface of atoms is made for a comparison.
struct StructureToCompare {
    double probe = 1.4;    ///< Å; 0 gives the van der Waals surface
    double spacing = 0.5;  ///< grid spacing of the mesh whose triangles provide the points, Å
    int threads = 0;       ///< 0: all cores
};

/// The exact SES of atoms, with a mesh by Method::Direct.
/// throws   as compute_surface()
ComparedSurface structure_to_compare(const Atoms& atoms, const StructureToCompare& options = {});

/// The same of an exact surface of any kind; options.probe does not matter.
/// throws   as mesh()
ComparedSurface exact_to_compare(ExactSurface exact, const StructureToCompare& options = {});

/// Distances from points on one surface to another, Å: without sign except signed_mean. Means are weighted by area.
struct OneWayDistance {
    double mean = 0.0;
    double p99 = 0.0;          ///< 99 % of the area is nearer than this
    double max = 0.0;          ///< largest distance of a point or a vertex
    double signed_mean = 0.0;  ///< positive where the points lie outside the other surface
    std::size_t points = 0;    ///< number of points, vertices not counted
};

/// Distances between two surfaces A and B, both ways.
struct Comparison {
    OneWayDistance a_to_b;
    OneWayDistance b_to_a;
    std::vector<float> distances;  ///< signed distance of each vertex of A to B, Å

    double hausdorff() const { return std::max(a_to_b.max, b_to_a.max); }
};

/// How densely two surfaces are compared.
struct CompareOptions {
    double density = 10.0;  ///< at least so many points per Å², > 0; no triangle has fewer than four
    int threads = 0;        ///< 0: all cores; results do not depend on it
};

/// Measures the distances between two surfaces, both ways.
///
/// Every triangle is divided into n² equal triangles, n = max(2, ceil(sqrt(density area))), each with a point at its
/// centroid. Distances to a mesh are exact; their sign follows from the normal at the nearest point (at edges and
/// corners the angle-weighted normal), and so tells outside from inside if that mesh is closed and oriented. Distances
/// to a SES are those of ExactSurface::signed_distance().
///
/// throws   UsageError for a mesh without triangles or area, or options out of range; LimitError for more points than
///          fit into memory
/// cost     some µs per point, parallel
/// source   sign: Bærentzen & Aanæs 2005, IEEE Trans. Vis. Comput. Graph. 11, 243-253
Comparison compare_surfaces(const ComparedSurface& a, const ComparedSurface& b, const CompareOptions& options = {});

}  // namespace meniscus
