// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Curvature-corrected area and volume: what the smooth surface under a mesh measures.
#pragma once

#include <functional>
#include <span>

#include "meniscus/mesh.h"

namespace meniscus {

/// Area (Å²) and signed volume (Å³) of the surface that a mesh samples.
struct CorrectedMeasures {
    double area = 0.0;
    double volume = 0.0;
};

/// What the sums over triangles and over the four parts of each tend to: the error of the parts is a fourth of that of
/// the whole ones.
CorrectedMeasures extrapolate(const CorrectedMeasures& whole, const CorrectedMeasures& parts);
/// The parts' measure of which extrapolate makes `wanted`, be it an area or a volume.
inline double parts_of(double whole, double wanted) { return 0.75 * wanted + 0.25 * whole; }

/// Moves points that lie near the surface onto it, and tells its unit normals there. Called for batches, from several
/// threads at once; must give the same result for the same point.
using Projector = std::function<void(std::span<Vec3> points, std::span<Vec3> normals)>;

/// Area and volume by projected subdivisions of every triangle and Richardson extrapolation from the last one.
///
/// Flat triangles with corners on a smooth surface miss it by a chord error of order h² for edges of length h.
/// Splitting each into four at the projected middles of its sides divides that error by four, so that
/// subdivided + (subdivided - plain) / 3 is left with an error of order h⁴. Across a crease of the surface the order is
/// that of the plain sum: there more divisions help. A middle is looked for from where the normals tell it to be.
///
/// divisions  from 1
/// throws     UsageError if the mesh has no normals
/// cost       O(4^divisions n) for n triangles; a middle is projected once or, where batches meet, twice
CorrectedMeasures corrected_measures(const Mesh& mesh, const Projector& project, int divisions = 1);

/// The same with the middles left where corners and normals tell (simd/tangent_planes.inc), which costs no projection:
/// order h⁴ too, but with a larger factor, and of no use next to creases.
///
/// throws   UsageError if the mesh has no normals
CorrectedMeasures corrected_measures(const Mesh& mesh);

}  // namespace meniscus
