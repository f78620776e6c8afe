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

struct MeasureOptions {
    double probe = 1.4;    ///< probe radius, Å; 0 gives the van der Waals surface
    bool cavities = true;  ///< also nesting and inscribed spheres of the components
    bool depth = false;    ///< also the depth of every atom
    bool patches = false;  ///< also the list of all patches, which takes a kilobyte per atom
    int threads = 0;       ///< 0: all cores; results do not depend on it
};

/// Areas and volumes of the whole surface; Å² and Å³. Cavities count negative in the volumes.
struct SurfaceTotals {
    double sas_area = 0.0;
    double sas_volume = 0.0;
    double ses_area = 0.0;
    double ses_volume = 0.0;
    double contact_area = 0.0;
    double toroidal_area = 0.0;
    double reentrant_area = 0.0;
};

/// Stands for "no atom", "no component".
inline constexpr std::uint32_t kNone = 0xffffffffU;

/// A patch of the SES: what trimming leaves connected of one feature of the SAS.
struct PatchMeasure {
    PatchKind kind = PatchKind::Contact;
    std::array<std::uint32_t, 3> atoms{kNone, kNone, kNone};  ///< one, two or three, in the caller's order
    std::uint32_t component = 0;                              ///< into Measures::components
    double ses_area = 0.0;                                    ///< Å²
    double sas_area = 0.0;                                    ///< Å²; contact patches only
    double first_share = 0.0;  ///< of ses_area, what belongs to atoms[0]; the others have equal parts of the rest
};

enum class ComponentKind {
    Outer,   ///< bounds a piece of the molecule from outside
    Cavity,  ///< bounds solvent enclosed by the molecule
};

/// A connected closed piece of the SES, found from the adjacency of its patches.
struct SurfaceComponent {
    ComponentKind kind = ComponentKind::Outer;
    double ses_area = 0.0;  ///< Å²
    double contact_area = 0.0;
    double toroidal_area = 0.0;
    double reentrant_area = 0.0;
    double ses_volume = 0.0;           ///< Å³ enclosed, positive
    double sas_area = 0.0;             ///< of the SAS pieces that belong to it
    double sas_volume = 0.0;           ///< Å³ enclosed by them, positive
    std::size_t sas_components = 0;    ///< several where voids of separate probe pockets merge
    Vec3 centre;                       ///< centroid of its surface, Å
    std::uint32_t inside_of = kNone;   ///< the component next outside, or kNone
    std::vector<std::uint32_t> atoms;  ///< that touch it, ascending, in the caller's order
    Vec3 inscribed_centre;             ///< cavities: of the largest sphere without atoms in it, Å
    double inscribed_radius = 0.0;     ///< Å; 0 for outer pieces
    SurfaceTotals errors;              ///< absolute error estimates of the areas and volumes
};

/// Shares of one atom. A toroidal patch is divided at the plane of its circle, a reentrant one in three equal parts.
struct AtomMeasure {
    double sas_area = 0.0;  ///< Å²
    double contact_area = 0.0;
    double toroidal_area = 0.0;
    double reentrant_area = 0.0;
    double depth = 0.0;  ///< -(signed distance to the SES) at the centre, Å; if asked for

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
    SurfaceTotals errors;  ///< absolute error estimates
    std::size_t sas_components = 0;
    /// SES patches of the piece of the SAS with the largest area: all that a probe reaches by rolling without leaving
    /// the atoms. Programs that start from one reduced surface report this as the outer component.
    PatchAreas largest_sas_piece;
    std::vector<SurfaceComponent> components;  ///< by falling volume
    std::vector<AtomMeasure> atoms;            ///< in the caller's order; of exact duplicates only the first has areas
    std::vector<PatchMeasure> patches;         ///< if asked for
    bool agreed = true;                        ///< two evaluations that share no perturbation agree
    bool degenerate = false;            ///< probe positions coincide, as on lattices: 1e-5 is asked for instead of 1e-7
    std::vector<std::string> disputed;  ///< patches on which they do not, if not agreed
};

/// Exact measures of the SAS and SES.
///
/// throws   UsageError for options out of range; as ExactSurface::accessible()
/// cost     linear at protein density, about 25 µs per atom
/// source   Gauss-Bonnet on spheres (Connolly 1983) with all self-intersections of reentrant patches trimmed;
///          docs/design/exact-measures.md
Measures measure(const Atoms& atoms, const MeasureOptions& options = {});

}  // namespace meniscus
