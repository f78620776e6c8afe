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
#include "meniscus/nearest_feature.h"
#include "meniscus/vec3.h"

namespace meniscus {

class AccessibleSurface;

/// How many accessible surfaces this process has built from atoms so far, for tests.
std::size_t accessible_surfaces_built();

/// As ExactSurface::signed_distance(). Implemented in nearest/.
std::vector<double> signed_distance(const AccessibleSurface& surface, std::span<const Vec3> points);

/// What AccessibleSurface::nearest finds for each of the points. Implemented in nearest/.
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
    /// throws   UsageError for a probe radius that is negative or not finite; std::invalid_argument for no atoms, a
    ///          radius <= 0 or a coordinate that is not finite; LimitError for coordinates and radii beyond 1e12 Å;
    ///          std::runtime_error where no perturbation decides the arrangement (never seen)
    /// cost     linear at protein density; parallel over atoms
    AccessibleSurface(const Atoms& atoms, double probe, std::uint64_t seed = 0);
    /// The same atoms and probe radius under the perturbation of another seed. This takes less time than the
    /// constructor, because neighbours that buried most of an atom are looked at first.
    AccessibleSurface perturbed(std::uint64_t seed) const;
    ~AccessibleSurface();
    AccessibleSurface(AccessibleSurface&&) noexcept;
    AccessibleSurface& operator=(AccessibleSurface&&) noexcept;

    double probe() const;
    std::size_t atom_count() const;  ///< with distinct centres
    std::size_t exposed_atom_count() const;
    std::size_t arc_count() const;     ///< exposed arcs, whole circles included
    std::size_t vertex_count() const;  ///< probe positions that touch three atoms

    /// The nearest feature of any point of space, whose coordinates must be finite. Implemented in nearest/.
    NearestFeature nearest(const Vec3& point) const;

    const Data& data() const { return *data_; }

private:
    explicit AccessibleSurface(std::unique_ptr<Data> data);

    std::unique_ptr<Data> data_;
};

}  // namespace meniscus
