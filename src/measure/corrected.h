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

/// The same with the middles left where corners and normals tell (arc_middle), which costs no projection: order h⁴
/// too, but with a larger factor, and of no use next to creases.
/// throws   UsageError if the mesh has no normals
CorrectedMeasures corrected_measures(const Mesh& mesh);

/// Middle of the arc over an edge a-b of a surface with unit normals there.
///
/// On a circle of radius r the normals make an angle θ with each other and the arc's middle lies r (1 - cos(θ/2)) above
/// the chord's, along the mean normal. With e = b - a and n the difference of the normals that is, to order θ⁶,
/// (n · e) / 16 (1 + 3 |n|² / 16) times the sum of the normals: n · e = |e|² / r is positive where the surface bends
/// away from its normals (a sphere with outward normals) and negative where it bends towards them. On other surfaces
/// the error is of order |e|⁴, on opposite normals there is no mean and the middle is the chord's.
inline Vec3 arc_middle(const Vec3& a, const Vec3& normal_a, const Vec3& b, const Vec3& normal_b) {
    const Vec3 turn = normal_b - normal_a;
    const double lift = dot(turn, b - a) / 16.0 * (1.0 + 3.0 / 16.0 * squared_norm(turn));
    return 0.5 * (a + b) + lift * (normal_a + normal_b);
}

}  // namespace meniscus
