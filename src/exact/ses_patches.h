// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The patches of the solvent-excluded surface with their measures and adjacency: its exact pieces.
#pragma once

#include <cstdint>
#include <vector>

#include "exact/patch_integrals.h"
#include "exact/reentrant_patches.h"
#include "exact/volume_origins.h"
#include "geometry/accessible_surface_data.h"
#include "meniscus/measures.h"

namespace meniscus {

/// One patch: a region of an exposed sphere, a piece of a torus, or a region of a trimmed triangle.
struct SesPatch {
    PatchKind kind = PatchKind::Contact;
    std::uint32_t feature = 0;  ///< atom in canonical order, arc or vertex
    std::uint32_t part = 0;     ///< region or piece of it
    std::uint32_t component = 0;
    std::uint32_t sas_component = kNone;
    PatchIntegrals ses;
    PatchIntegrals sas;          ///< contact patches
    double area_at_first = 0.0;  ///< toroidal patches: of the area, what is on the side of the arc's first atom, Å²
};

/// All patches of one evaluation.
class SesPatches {
public:
    SesPatches(const AccessibleSurface& surface, std::uint64_t seed);

    const AccessibleSurface::Data& data() const { return surface_->data(); }
    const std::vector<SesPatch>& patches() const { return patches_; }
    /// In canonical order; kNone behind those of patches with fewer than three.
    std::array<std::uint32_t, 3> atoms_of(const SesPatch& patch) const;
    /// Of a patch's integrals; the same for all patches of a component.
    const Vec3& origin_of(const SesPatch& patch) const;
    std::size_t component_count() const { return pieces_.ses; }
    std::size_t sas_component_count() const { return pieces_.sas; }
    bool degenerate() const { return degenerate_; }
    /// Vertices whose trimming could not be resolved.
    const std::vector<std::uint32_t>& unresolved() const { return unresolved_; }

    /// The component of the patch that matches one of another evaluation of the same atoms, or kNone: the patch has the
    /// same atoms and place, and of several regions it is the one whose area is nearest.
    std::uint32_t component_like_contact(std::uint32_t atom, double area) const;
    std::uint32_t component_like_torus(std::uint32_t arc, const SasArc& like, std::uint32_t part) const;
    std::uint32_t component_like_reentrant(std::uint32_t vertex, const SasVertex& like, double area) const;

    /// The component whose surface is nearest to a point.
    std::uint32_t component_at(const Vec3& point) const;

private:
    // Where in patches_ those of an atom, arc or vertex begin; each list has one number more for its end.
    struct FirstPatches {
        std::vector<std::uint32_t> contact;
        std::vector<std::uint32_t> torus;
        std::vector<std::uint32_t> reentrant;
    };
    // How many connected pieces each surface has.
    struct PieceCounts {
        std::size_t ses = 0;
        std::size_t sas = 0;
    };
    // For each arc of a contour, the contact patch beside it.
    using ContactsBeside = std::vector<std::uint32_t>;

    ContactsBeside add_contact_patches();
    void add_toroidal_patches();
    void add_reentrant_patches(const std::vector<ReentrantPatch>& trimmed);
    void number_components(const ContactsBeside& beside, const std::vector<ReentrantPatch>& trimmed);
    void number_sas_components(const ContactsBeside& beside);
    std::uint32_t component_of_nearest_area(std::uint32_t begin, std::uint32_t end, double area) const;
    std::uint32_t torus_patch(std::uint32_t arc, std::uint32_t atom) const;
    std::uint32_t torus_patch_at(std::uint32_t arc, const Vec3& point) const;
    std::uint32_t patch_across(const std::vector<ReentrantPatch>& trimmed, std::uint32_t vertex,
                               const TrimmedArc& arc) const;

    const AccessibleSurface* surface_;
    std::uint64_t seed_;
    VolumeOrigins origins_;
    std::vector<SesPatch> patches_;
    FirstPatches first_;
    PieceCounts pieces_;
    bool degenerate_ = false;
    std::vector<std::uint32_t> unresolved_;
};

}  // namespace meniscus
