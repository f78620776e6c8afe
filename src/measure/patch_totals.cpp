// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/patch_totals.h"

#include "core/parallel.h"
#include "measure/patch_integrals.h"
#include "measure/reentrant_patches.h"
#include "measure/volume_origins.h"

namespace meniscus {
namespace {

constexpr std::size_t kChunk = 128;

struct SpherePair {
    PatchIntegrals sas;
    PatchIntegrals ses;
    SpherePair& operator+=(const SpherePair& other) {
        sas += other.sas;
        ses += other.ses;
        return *this;
    }
};

SpherePair sum_contact_patches(const AccessibleSurface::Data& data, const VolumeOrigins& origins) {
    return parallel_sum<SpherePair>(data.atoms.size(), kChunk, [&](std::size_t begin, std::size_t end) {
        SpherePair sum;
        SphericalRegions regions;
        for (std::size_t i = begin; i < end; ++i) {
            if (data.exposed[i] == 0) continue;
            measure_exposed_regions(data, static_cast<std::uint32_t>(i), regions);
            const Vec3 centre = data.atoms.centres[i] - origins.of(static_cast<std::uint32_t>(i));
            for (const SphericalRegion& region : regions.regions()) {
                sum.sas += sphere_patch(centre, data.rho[i], region, 1);
                sum.ses += sphere_patch(centre, data.rho[i] - data.probe, region, 1);
            }
        }
        return sum;
    });
}

PatchIntegrals sum_toroidal_patches(const AccessibleSurface::Data& data, const VolumeOrigins& origins) {
    return parallel_sum<PatchIntegrals>(data.arcs.size(), kChunk, [&](std::size_t begin, std::size_t end) {
        PatchIntegrals sum;
        for (std::size_t a = begin; a < end; ++a) {
            const SasArc& arc = data.arcs[a];
            const ToroidalPatch torus = toroidal_patch(arc, data.probe);
            for (std::size_t k = 0; k < static_cast<std::size_t>(torus.count); ++k)
                sum += toroidal_piece(arc, data.probe, torus.pieces[k], arc.centre - origins.of(arc.atoms[0]));
        }
        return sum;
    });
}

PatchIntegrals sum_reentrant_patches(const AccessibleSurface& surface, std::uint64_t seed, const VolumeOrigins& origins,
                                     PatchTotals& found) {
    const AccessibleSurface::Data& data = surface.data();
    struct Trimmed {
        PatchIntegrals sum;
        bool consistent = true;
        bool degenerate = false;
    };
    std::vector<Trimmed> trimmed(data.vertices.size());
    for_each_reentrant_patch(surface, seed, [&](std::uint32_t v, const ReentrantPatch& patch) {
        trimmed[v].consistent = patch.consistent;
        trimmed[v].degenerate = patch.degenerate;
        for (const SphericalRegion& region : patch.regions)
            trimmed[v].sum +=
                sphere_patch(data.vertices[v].position - origins.of(data.vertices[v].atoms[0]), data.probe, region, -1);
    });
    PatchIntegrals sum;
    for (std::uint32_t v = 0; v < trimmed.size(); ++v) {
        sum += trimmed[v].sum;
        found.degenerate = found.degenerate || trimmed[v].degenerate;
        if (!trimmed[v].consistent) found.unresolved.push_back(v);
    }
    return sum;
}

}  // namespace

PatchTotals sum_patches(const AccessibleSurface& surface, std::uint64_t seed) {
    const AccessibleSurface::Data& data = surface.data();
    const VolumeOrigins origins(data);
    PatchTotals found;
    const SpherePair contact = sum_contact_patches(data, origins);
    const PatchIntegrals toroidal = sum_toroidal_patches(data, origins);
    const PatchIntegrals reentrant = sum_reentrant_patches(surface, seed, origins, found);
    found.totals = {.sas_area = contact.sas.area,
                    .sas_volume = contact.sas.volume,
                    .ses_area = contact.ses.area + toroidal.area + reentrant.area,
                    .ses_volume = contact.ses.volume + toroidal.volume + reentrant.volume,
                    .contact_area = contact.ses.area,
                    .toroidal_area = toroidal.area,
                    .reentrant_area = reentrant.area};
    return found;
}

}  // namespace meniscus
