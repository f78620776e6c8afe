// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact/patch_totals.h"

#include <algorithm>

#include "core/parallel.h"
#include "exact/patch_integrals.h"
#include "exact/reentrant_patches.h"
#include "exact/volume_origins.h"

namespace meniscus {
namespace {

constexpr std::size_t kPatchesPerTask = 128;

void accumulate(SurfaceTotals& to, PatchKind kind, const PatchIntegrals& ses, const PatchIntegrals& sas,
                double factor = 1.0) {
    to.sas_area += factor * sas.area;
    to.sas_volume += factor * sas.volume;
    to.ses_area += factor * ses.area;
    to.ses_volume += factor * ses.volume;
    if (kind == PatchKind::Contact) to.contact_area += factor * ses.area;
    if (kind == PatchKind::Toroidal) to.toroidal_area += factor * ses.area;
    if (kind == PatchKind::Reentrant) to.reentrant_area += factor * ses.area;
}

// Integrals over patches of one kind. Those of the largest component, nearly all, are only summed up.
class PatchSums {
public:
    PatchSums() = default;
    explicit PatchSums(std::uint32_t largest) : largest_(largest) {}

    void add(std::uint32_t component, const PatchIntegrals& ses, const PatchIntegrals& sas = {}) {
        ses_ += ses;
        sas_ += sas;
        if (component != largest_ && component != kNone) elsewhere_.push_back({component, ses, sas});
    }
    PatchSums& operator+=(const PatchSums& other) {
        ses_ += other.ses_;
        sas_ += other.sas_;
        elsewhere_.insert(elsewhere_.end(), other.elsewhere_.begin(), other.elsewhere_.end());
        return *this;
    }
    void add_to(PatchTotals& found, PatchKind kind, std::uint32_t largest) const {
        accumulate(found.totals, kind, ses_, sas_);
        accumulate(found.components[largest], kind, ses_, sas_);
        for (const Elsewhere& patch : elsewhere_) {
            accumulate(found.components[patch.component], kind, patch.ses, patch.sas);
            accumulate(found.components[largest], kind, patch.ses, patch.sas, -1.0);
        }
    }

private:
    struct Elsewhere {
        std::uint32_t component;
        PatchIntegrals ses;
        PatchIntegrals sas;
    };
    std::uint32_t largest_ = 0;
    PatchIntegrals ses_;
    PatchIntegrals sas_;
    std::vector<Elsewhere> elsewhere_;
};

std::uint32_t largest_component(const SesPatches& patches) {
    std::vector<double> areas(patches.component_count());
    for (const SesPatch& patch : patches.patches()) areas[patch.component] += patch.ses.area;
    return static_cast<std::uint32_t>(std::max_element(areas.begin(), areas.end()) - areas.begin());
}

// The components of a first evaluation that the patches of a second are counted to; without a first they are all one.
class Likes {
public:
    explicit Likes(const SesPatches* first)
        : first_(first),
          count_(first == nullptr ? 1 : first->component_count()),
          largest_(first == nullptr ? 0 : largest_component(*first)) {}

    std::size_t count() const { return count_; }
    std::uint32_t largest() const { return largest_; }

    std::uint32_t contact(std::uint32_t atom, double area) const {
        return first_ == nullptr ? largest_ : first_->component_like_contact(atom, area);
    }
    std::uint32_t torus(std::uint32_t index, const SasArc& arc, std::uint32_t piece) const {
        return first_ == nullptr ? largest_ : first_->component_like_torus(index, arc, piece);
    }
    std::uint32_t reentrant(std::uint32_t index, const SasVertex& vertex, double area) const {
        return first_ == nullptr ? largest_ : first_->component_like_reentrant(index, vertex, area);
    }

private:
    const SesPatches* first_;
    std::size_t count_;
    std::uint32_t largest_;
};

PatchSums sum_contact_patches(const AccessibleSurface::Data& data, const VolumeOrigins& origins, const Likes& likes) {
    return parallel_sum<PatchSums>(data.atoms.size(), kPatchesPerTask, [&](std::size_t begin, std::size_t end) {
        PatchSums sums(likes.largest());
        SphericalRegions regions;
        for (std::size_t i = begin; i < end; ++i) {
            if (data.exposed[i] == 0) continue;
            const auto atom = static_cast<std::uint32_t>(i);
            regions.measure(data.caps_of(atom), data.contour_of(atom));
            const Vec3 centre = data.atoms.centres[i] - origins.of(atom);
            for (const SphericalRegion& region : regions.regions()) {
                const PatchIntegrals ses = sphere_patch(centre, data.rho[i] - data.probe, region, 1);
                sums.add(likes.contact(atom, ses.area), ses, sphere_patch(centre, data.rho[i], region, 1));
            }
        }
        return sums;
    });
}

PatchSums sum_toroidal_patches(const AccessibleSurface::Data& data, const VolumeOrigins& origins, const Likes& likes) {
    return parallel_sum<PatchSums>(data.arcs.size(), kPatchesPerTask, [&](std::size_t begin, std::size_t end) {
        PatchSums sums(likes.largest());
        for (std::size_t a = begin; a < end; ++a) {
            const SasArc& arc = data.arcs[a];
            const ToroidalPatch torus = toroidal_patch(arc, data.probe);
            for (std::uint32_t k = 0; k < static_cast<std::uint32_t>(torus.count); ++k)
                sums.add(likes.torus(static_cast<std::uint32_t>(a), arc, k),
                         toroidal_piece(arc, data.probe, torus.pieces[k], arc.centre - origins.of(arc.atoms[0])));
        }
        return sums;
    });
}

PatchSums sum_reentrant_patches(const AccessibleSurface& surface, std::uint64_t seed, const VolumeOrigins& origins,
                                const Likes& likes, PatchTotals& found) {
    const AccessibleSurface::Data& data = surface.data();
    struct Trimmed {
        PatchSums sums;
        std::vector<std::uint32_t> unresolved;
        bool degenerate = false;
    };
    const std::size_t tasks = (data.vertices.size() + kVerticesPerTask - 1) / kVerticesPerTask;
    std::vector<Trimmed> trimmed(tasks, {PatchSums(likes.largest()), {}});
    for_each_reentrant_patch(surface, seed, [&](std::uint32_t v, const ReentrantPatch& patch) {
        Trimmed& task = trimmed[v / kVerticesPerTask];
        task.degenerate = task.degenerate || patch.degenerate;
        if (!patch.consistent) task.unresolved.push_back(v);
        const SasVertex& vertex = data.vertices[v];
        const Vec3 centre = vertex.position - origins.of(vertex.atoms[0]);
        for (const SphericalRegion& region : patch.regions) {
            const PatchIntegrals ses = sphere_patch(centre, data.probe, region, -1);
            task.sums.add(likes.reentrant(v, vertex, ses.area), ses);
        }
    });
    PatchSums sums(likes.largest());
    for (const Trimmed& task : trimmed) {
        sums += task.sums;
        found.degenerate = found.degenerate || task.degenerate;
        found.unresolved.insert(found.unresolved.end(), task.unresolved.begin(), task.unresolved.end());
    }
    return sums;
}

}  // namespace

PatchTotals sum_patches(const AccessibleSurface& surface, std::uint64_t seed, const SesPatches* first) {
    const AccessibleSurface::Data& data = surface.data();
    const Likes likes(first);
    const VolumeOrigins origins(data);
    PatchTotals found;
    found.degenerate = has_coincident_probes(data);
    found.components.resize(likes.count());
    sum_contact_patches(data, origins, likes).add_to(found, PatchKind::Contact, likes.largest());
    sum_toroidal_patches(data, origins, likes).add_to(found, PatchKind::Toroidal, likes.largest());
    sum_reentrant_patches(surface, seed, origins, likes, found).add_to(found, PatchKind::Reentrant, likes.largest());
    return found;
}

}  // namespace meniscus
