// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Shapes of the triangles of a mesh, and distances between mesh and exact surface.
#pragma once

#include <array>
#include <cstddef>

#include "meniscus/exact_surface.h"
#include "meniscus/mesh.h"

namespace meniscus {

/// Least, 5th, 50th and 95th percentile, and greatest of a set of numbers.
struct Percentiles {
    double min = 0.0;
    double p5 = 0.0;
    double p50 = 0.0;
    double p95 = 0.0;
    double max = 0.0;
};

/// Mean, 99th percentile and largest of distances between two surfaces, Å, without sign.
struct DistanceSummary {
    double mean = 0.0;
    double p99 = 0.0;
    double max = 0.0;
};

/// Shapes of the triangles of a mesh.
struct MeshQuality {
    std::array<std::size_t, 18> angles{};  ///< numbers of corners with angles of 0 to 10 degrees, 10 to 20, ...
    Percentiles smallest_angles;           ///< smallest angle of each triangle, degrees
    Percentiles edges;                     ///< lengths of edges, Å
    Percentiles aspect_ratios;  ///< circumradius over twice the inradius: 1 for an equilateral triangle, else more
};

/// Surveys the shapes of the triangles of a mesh.
/// cost     O(n), 0.1 µs per triangle, parallel
MeshQuality measure_quality(const Mesh& mesh);

/// Distances between a mesh and the exact SES, both ways.
struct TwoSidedDistance {
    DistanceSummary to_exact;    ///< from points spread evenly over the triangles to the SES
    DistanceSummary from_exact;  ///< from the points of the SES nearest to those points to the mesh
};

/// Measures the distances between a mesh and an exact surface.
/// cost     O(n log n), some 3 µs per triangle, parallel
TwoSidedDistance measure_distance(const Mesh& mesh, const ExactSurface& surface);

}  // namespace meniscus
