// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Exact geometry of the solvent-accessible surface, and through it of the solvent-excluded surface.
//
// K, where a probe centre may be, is the complement of the union of the open balls with the atoms' radii
// enlarged by the probe radius. The solvent-accessible surface (SAS) is its boundary: exposed patches of the
// balls' spheres, exposed arcs of the circles where two spheres meet, and vertices (probe positions) where
// three meet. The solvent-excluded surface (SES) is the set of points at distance R, the probe radius, of K.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "meniscus/atoms.h"
#include "meniscus/mesh.h"
#include "meniscus/vec3.h"

namespace meniscus {

/// The point of the SES that is nearest to a query point, seen through its nearest feature of the SAS.
struct NearestFeature {
    double signed_distance = 0.0;  ///< Å, negative inside; see signed_distance()
    PatchKind patch = PatchKind::Contact;
    std::uint32_t atom = 0;           ///< nearest atom of the feature, in the caller's order
    double mean_curvature = 0.0;      ///< of the parallel surface through the point, Å^-1; may be ±inf at cusps
    double gaussian_curvature = 0.0;  ///< of the same surface, Å^-2; may be ±inf at cusps
    Vec3 foot;                        ///< nearest point of K (a probe centre), Å
    Vec3 normal;                      ///< gradient of the signed distance; unit vector, zero where undefined
};

class AccessibleSurface;

/// Signed distance to the solvent-excluded surface, Å, in the order of `points`.
///
/// Negative inside the molecule. Exact inside and on the surface; outside, next to ridges where two probe
/// positions intersect, a lower bound with the right zero set (docs/design/exact-geometry.md).
///
/// throws   std::invalid_argument if a coordinate is not finite
/// cost     O(log n) per point, parallel; 0.1 µs where points lie as close together as those of a grid
std::vector<double> signed_distance(const AccessibleSurface& surface, std::span<const Vec3> points);

/// What AccessibleSurface::nearest finds for each of the points.
///
/// throws   std::invalid_argument if a coordinate is not finite
/// cost     O(log n) per point, parallel; 0.1 µs near the surface where points lie next to those before them
std::vector<NearestFeature> nearest_features(const AccessibleSurface& surface, std::span<const Vec3> points);

/// Where the exposed features are, and the index to find the nearest one.
class AccessibleSurface {
public:
    struct Data;

    /// Builds the SAS of atoms and a probe radius (Å, >= 0) by contour build-up.
    ///
    /// Of atoms with exactly the same centre the largest is kept, which holds the others. Degenerate arrangements (four
    /// spheres through a point, tangent and concentric spheres, lattices) are decided by a perturbation of the radii of
    /// order 1e-10 Å (1e-14 of the largest sphere's, if that is more) that depends only on the atoms themselves, not on
    /// their order. Another seed gives another perturbation: what both give is not an accident of either.
    ///
    /// throws   std::invalid_argument for no atoms, a radius <= 0 or a coordinate that is not finite; LimitError for
    ///          coordinates and radii beyond 1e12 Å; std::runtime_error where no perturbation decides the arrangement
    ///          (never seen)
    /// cost     linear at protein density; parallel over atoms
    AccessibleSurface(const Atoms& atoms, double probe, std::uint64_t seed = 0);
    /// The same atoms and probe radius under the perturbation of another seed. What is exposed is found anew, sooner
    /// than by the constructor: neighbours that buried most are looked at first.
    ///
    /// throws   std::logic_error after forget_contours()
    AccessibleSurface perturbed(std::uint64_t seed) const;
    ~AccessibleSurface();
    AccessibleSurface(AccessibleSurface&&) noexcept;
    AccessibleSurface& operator=(AccessibleSurface&&) noexcept;

    /// Frees a sixth of the memory, which only measure() (measures.h) and perturbed() need: both throw std::logic_error
    /// afterwards. What is nearest to a point is found as before.
    void forget_contours();

    double probe() const;
    std::size_t atom_count() const;  ///< with distinct centres
    std::size_t exposed_atom_count() const;
    std::size_t arc_count() const;     ///< exposed arcs, whole circles included
    std::size_t vertex_count() const;  ///< probe positions that touch three atoms

    /// The nearest feature of any point of space, whose coordinates must be finite.
    NearestFeature nearest(const Vec3& point) const;

    const Data& data() const { return *data_; }

private:
    explicit AccessibleSurface(std::unique_ptr<Data> data);

    std::unique_ptr<Data> data_;
};

}  // namespace meniscus
