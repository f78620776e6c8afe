// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Exact areas, volumes and cavities of molecular surfaces, without a grid, each with an error estimate.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "meniscus/atoms.h"
#include "meniscus/mesh.h"

namespace meniscus {

/// What is measured, and how.
struct MeasureOptions {
    double probe = 1.4;    ///< probe radius, Å; 0 gives the van der Waals surface
    bool cavities = true;  ///< also find which component encloses which, and inscribed spheres
    bool depth = false;    ///< also find the depth of every atom
    bool patches = false;  ///< also list all patches, which takes a kilobyte per atom
    int threads = 0;       ///< 0: all cores; results do not depend on it
};

/// Areas, Å², and volumes, Å³, of a whole surface, or the errors of these. Cavities count negative in the volumes.
struct SurfaceTotals {
    double sas_area = 0.0;
    double sas_volume = 0.0;
    double ses_area = 0.0;
    double ses_volume = 0.0;
    double contact_area = 0.0;
    double toroidal_area = 0.0;
    double reentrant_area = 0.0;
};

/// The index that means "no atom" or "no component".
inline constexpr std::uint32_t kNone = 0xffffffffU;

/// A patch of the SES: a connected part of what one face, arc or vertex of the SAS contributes after trimming.
struct PatchMeasure {
    PatchKind kind = PatchKind::Contact;
    std::array<std::uint32_t, 3> atoms{kNone, kNone, kNone};  ///< indices of its 1, 2 or 3 atoms, then kNone
    std::uint32_t component = 0;                              ///< index into Measures::components
    double ses_area = 0.0;                                    ///< Å²
    double sas_area = 0.0;                                    ///< Å²; contact patches only
    double first_share = 0.0;  ///< Å² of ses_area that belong to atoms[0]; the other atoms share the rest equally
};

/// Kinds of closed pieces of the SES.
enum class ComponentKind {
    Outer,   ///< bounds a piece of the molecule from outside
    Cavity,  ///< bounds solvent enclosed by the molecule
};

/// A connected closed piece of the SES, found from the adjacency of its patches. Areas in Å², volumes in Å³.
struct SurfaceComponent {
    ComponentKind kind = ComponentKind::Outer;
    double ses_area = 0.0;
    double contact_area = 0.0;
    double toroidal_area = 0.0;
    double reentrant_area = 0.0;
    double ses_volume = 0.0;           ///< enclosed volume, positive
    double sas_area = 0.0;             ///< area of the pieces of the SAS that have a patch on this component
    double sas_volume = 0.0;           ///< volume that those pieces enclose, positive
    std::size_t sas_components = 0;    ///< number of those pieces
    Vec3 centre;                       ///< centroid of the component's surface, Å
    std::uint32_t inside_of = kNone;   ///< index of the next component outside, or kNone
    std::vector<std::uint32_t> atoms;  ///< indices of the atoms that touch the component, ascending
    Vec3 inscribed_centre;             ///< centre of the largest sphere in a cavity that touches no atom, Å
    double inscribed_radius = 0.0;     ///< radius of that sphere, Å; 0 for outer pieces
    SurfaceTotals errors;              ///< absolute error estimates of the areas and volumes
};

/// An atom's areas, Å². Toroidal patches are divided at the plane of the circle in which the two expanded spheres meet,
/// reentrant ones into three equal parts.
struct AtomMeasure {
    double sas_area = 0.0;
    double contact_area = 0.0;
    double toroidal_area = 0.0;
    double reentrant_area = 0.0;
    double depth = 0.0;  ///< depth of the centre below the SES, Å; 0 without MeasureOptions::depth

    double ses_area() const { return contact_area + toroidal_area + reentrant_area; }
};

/// Areas of patches of the SES by kind, Å².
struct PatchAreas {
    double contact = 0.0;
    double toroidal = 0.0;
    double reentrant = 0.0;

    double sum() const { return contact + toroidal + reentrant; }
};

/// All that measure() finds.
struct Measures {
    MeasureOptions options;
    SurfaceTotals totals;
    SurfaceTotals errors;            ///< absolute error estimates
    std::size_t sas_components = 0;  ///< number of closed pieces of the SAS
    /// SES patches of the piece of the SAS with the largest area: all that one probe reaches by rolling on the atoms.
    /// Programs that start from one reduced surface report this as the outer component.
    PatchAreas largest_sas_piece;
    std::vector<SurfaceComponent> components;  ///< components of the SES, by falling volume
    std::vector<AtomMeasure> atoms;            ///< in the caller's order; of identical atoms only the first has areas
    std::vector<PatchMeasure> patches;         ///< empty without MeasureOptions::patches
    bool agreed = true;                        ///< whether two evaluations with different perturbations agree
    bool degenerate = false;  ///< probe positions coincide, as on lattices; then `agreed` is to 1e-5, else 1e-7
    std::vector<std::string> disputed;  ///< patches on which the two evaluations differ, unless agreed
};

/// Measures the SAS and SES of atoms exactly.
///
/// throws   UsageError for options out of range, and whatever ExactSurface::accessible() throws
/// cost     linear at protein density, about 25 µs per atom
/// source   Gauss-Bonnet on spheres (Connolly 1983) with all self-intersections of reentrant patches trimmed;
///          docs/design/exact-measures.md
Measures measure(const Atoms& atoms, const MeasureOptions& options = {});

}  // namespace meniscus
