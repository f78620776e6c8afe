// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the triangles of a mesh are like, and how far the mesh is from the exact surface.
#pragma once

#include <array>
#include <cstddef>

#include "meniscus/exact_surface.h"
#include "meniscus/mesh.h"

namespace meniscus {

/// Values that so many parts of all are below.
struct Percentiles {
    double min = 0.0;
    double p5 = 0.0;
    double p50 = 0.0;
    double p95 = 0.0;
    double max = 0.0;
};

/// Distances between two surfaces, Å, absolute values.
struct DistanceSummary {
    double mean = 0.0;
    double p99 = 0.0;
    double max = 0.0;
};

struct MeshQuality {
    std::array<std::size_t, 18> angles{};  ///< corners with angles from 0 to 10 degrees, 10 to 20, ...
    Percentiles smallest_angles;           ///< of the triangles, degrees
    Percentiles edges;                     ///< lengths, Å
    Percentiles aspect_ratios;  ///< circumradius over twice the inradius: 1 for an equilateral triangle, else more
};

/// cost     O(n), 0.1 µs per triangle, parallel
MeshQuality measure_quality(const Mesh& mesh);

/// Distances between a mesh and the exact SES, both ways, by points spread evenly over the triangles.
struct TwoSidedDistance {
    DistanceSummary to_exact;    ///< from these points to the SES
    DistanceSummary from_exact;  ///< from the points of the SES nearest to them to the mesh
};

/// cost     O(n log n), some 3 µs per triangle, parallel
TwoSidedDistance measure_distance(const Mesh& mesh, const ExactSurface& surface);

}  // namespace meniscus
