// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The exact surface of atoms, from which meshes, fields, pictures and tables are made and by which they are checked.
#pragma once

#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "meniscus/atoms.h"
#include "meniscus/measures.h"
#include "meniscus/nearest_feature.h"
#include "meniscus/vec3.h"

namespace meniscus {

class AccessibleSurface;

/// Kinds of molecular surface.
enum class SurfaceKind {
    Ses,  ///< solvent-excluded: bounds the space that no probe reaches
    Sas,  ///< solvent-accessible: traced by the probe's centre
    Vdw,  ///< van der Waals: of the atoms themselves, whatever the probe radius
};

/// Which surface of the atoms, and of which probe.
struct ExactOptions {
    SurfaceKind kind = SurfaceKind::Ses;
    double probe = 1.4;  ///< probe radius, Å; 0 gives the van der Waals surface

    bool operator==(const ExactOptions&) const = default;
};

/// A surface of atoms, known analytically. Immutable, and cheap to copy: copies share what has been computed.
///
/// Results are computed when they are first asked for, and kept. Members may be called by several threads at once.
class ExactSurface {
public:
    ExactSurface();  ///< without atoms: a placeholder until another surface is assigned
    /// throws   UsageError for a probe radius that is negative or not finite
    explicit ExactSurface(Atoms atoms, const ExactOptions& options = {});

    // References are valid as long as a surface of these atoms is kept. One that was moved from can only be assigned
    // to.
    const Atoms& atoms() const;
    const ExactOptions& options() const;

    /// The balls whose SES this surface is: the atoms themselves, or, for a SAS, the atoms enlarged by the probe
    /// radius. The probe that rolls over these balls has radius 0 for a SAS and for a van der Waals surface.
    const Atoms& balls() const;
    double probe_of_balls() const;  ///< Å

    /// Areas, volumes and pieces of the SES of the balls, with cavities, without depths and without patches.
    ///
    /// throws   as accessible()
    /// cost     the first time that of measure() (measures.h)
    const Measures& measures() const;

    /// Signed distance to the surface, Å, in the order of `points`.
    ///
    /// Negative inside the molecule. Exact inside and on the surface; outside, next to ridges where two probe
    /// positions intersect, a lower bound with the right zero set (docs/design/exact-geometry.md).
    ///
    /// throws   std::invalid_argument if a coordinate is not finite; as accessible()
    /// cost     O(log n) per point, parallel; 0.1 µs where points lie as close together as those of a grid
    std::vector<double> signed_distance(std::span<const Vec3> points) const;

    /// The nearest feature of each point, in the order of `points`. Throws and costs the same as signed_distance().
    std::vector<NearestFeature> nearest_features(std::span<const Vec3> points) const;

    /// A surface of the same atoms with other options, built only once and kept as long as any surface of these atoms.
    ///
    /// throws   UsageError for a probe radius that is negative or not finite
    ExactSurface of_same_atoms(const ExactOptions& options) const;

    /// The solvent-accessible surface of the balls, from which all else follows. For use within the library.
    ///
    /// throws   std::invalid_argument for no atoms, a radius that is not positive or a coordinate that is not finite;
    ///          LimitError for coordinates and radii beyond 1e12 Å
    /// cost     the first time linear at protein density, about 5 µs per atom, parallel
    const AccessibleSurface& accessible() const;

    /// The same as measures(), for callers that keep them longer than this surface.
    std::shared_ptr<const Measures> shared_measures() const;

private:
    struct Family;  // the atoms and all their surfaces
    struct Member;
    ExactSurface(std::shared_ptr<Family> family, Member* member);

    std::shared_ptr<Family> family_;
    Member* member_;  // owned by the family
};

}  // namespace meniscus
