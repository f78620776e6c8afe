// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact/reentrant_patches.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/elementary.h"
#include "core/mix_bits.h"
#include "core/workspaces.h"
#include "exact/reentrant_triangle.h"
#include "geometry/neighbour_caps.h"

namespace meniscus {
namespace {

constexpr double kPlaneShift = 1e-9;  // Å: far above rounding, far below 1e-7 of any area
constexpr int kMaxAttempts = 8;       // the last ones with a tenfold shift each

// Probe positions this close (Å) are one position found by several triples: they share edges, not ground.
constexpr double kSamePosition = 1e-6;

// Shift of the plane between two probes, Å, antisymmetric: both spheres are cut by the same plane.
double plane_shift(std::uint32_t v, std::uint32_t w, std::uint64_t seed) {
    const std::uint64_t pair = (std::uint64_t{std::min(v, w)} << 32U) | std::max(v, w);
    const double unit = signed_unit(mix_bits(mix_bits(pair + kMixIncrement) ^ mix_bits(seed)));
    return kPlaneShift * (v < w ? unit : -unit);
}

enum class Arcs : std::uint8_t { FilledIn, LeftOut };

// Trims one patch after the other, reusing its memory.
class Trimmer {
public:
    Trimmer(const AccessibleSurface& surface, std::uint64_t seed, Arcs arcs)
        : data_(surface.data()), seed_(seed), fills_arcs_in_(arcs == Arcs::FilledIn), near_(data_) {}

    void trim(std::uint32_t v, ReentrantPatch& patch) {
        near_.visit(v);
        patch.consistent = true;
        patch.degenerate = false;
        patch.triangle = near_.triangle().solid_angle;
        gather_probes(v, patch);
        if (probes_.empty() && near_.triangle().is_wide()) return take_whole(patch);
        for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
            patch.degenerate = patch.degenerate || attempt > 0;
            if (cut(v, attempt, patch)) return;
        }
        patch.regions.clear();
        patch.arcs.clear();
        patch.consistent = false;
    }

    /// The region that holds a direction. Precondition: the patch trimmed last has several regions.
    std::uint32_t region_of(const Vec3& direction) const { return regions_.region_of(direction); }

private:
    static constexpr std::uint32_t kEdges = ReentrantTriangle::kSides;

    void take_whole(ReentrantPatch& patch) {
        const ReentrantTriangle& triangle = near_.triangle();
        SphericalRegion region{triangle.solid_angle, {}};
        patch.arcs.clear();
        for (std::uint32_t k = 0; k < kEdges; ++k) {
            const Vec3& axis = triangle.sides[k];
            const double angle = triangle.lengths[k];
            region.vector_area += -0.5 * angle * axis;  // ½ ∮ n × dn along great circles
            if (!fills_arcs_in_) continue;
            const Vec3 middle = normalised(triangle.corners[k] + triangle.corners[(k + 1) % kEdges]);
            patch.arcs.push_back({.edge = k, .angle = angle, .axis = axis, .middle = middle});
        }
        patch.regions.assign(1, region);
    }

    void gather_probes(std::uint32_t v, ReentrantPatch& patch) {
        const Vec3& at = data_.vertices[v].position;
        const double reach = 2.0 * data_.probe;
        const ReentrantTriangle& triangle = near_.triangle();
        probes_.clear();
        for (const std::uint32_t w : near_.reaching()) {
            const Vec3 between = data_.vertices[w].position - at;
            const double d2 = squared_norm(between);
            if (d2 >= reach * reach) continue;
            const double d = std::sqrt(d2);
            if (d < kSamePosition)
                patch.degenerate = true;
            else if (!triangle.is_missed_by((1.0 / d) * between, d / reach))
                probes_.push_back({(1.0 / d) * between, d / reach, w});
        }
    }

    bool cut(std::uint32_t v, int attempt, ReentrantPatch& patch) {
        caps_.clear();
        for (std::uint32_t k = 0; k < kEdges; ++k) caps_.add({near_.triangle().sides[k], 0.0, k});
        const double growth = elementary::pow(10.0, std::max(0, attempt - kMaxAttempts / 2));
        const std::uint64_t seed = seed_ + 977 * static_cast<std::uint64_t>(attempt);
        for (Cap probe : probes_) {
            probe.t += growth * plane_shift(v, probe.atom, seed) / data_.probe;
            caps_.add(probe);
        }
        if (!builder_.build(caps_.planes)) return false;
        regions_.measure(builder_.kept_caps(), builder_.arcs());
        return accept(patch);
    }

    // A patch is a part of its triangle: anything else is a mistake of rounding.
    bool accept(ReentrantPatch& patch) {
        constexpr double kTolerance = 1e-7;
        double sum = 0.0;
        for (const SphericalRegion& region : regions_.regions()) {
            if (!(region.solid_angle > -kTolerance)) return false;
            sum += region.solid_angle;
        }
        if (!(sum < patch.triangle + kTolerance)) return false;
        patch.regions.assign(regions_.regions().begin(), regions_.regions().end());
        patch.arcs.clear();
        if (fills_arcs_in_) fill_in_arcs(patch);
        return true;
    }

    void fill_in_arcs(ReentrantPatch& patch) const {
        for (std::size_t a = 0; a < regions_.arcs().size(); ++a) {
            const MeasuredArc& arc = regions_.arcs()[a];
            const std::uint32_t cap = builder_.arcs()[a].cap;
            const std::uint32_t k = builder_.kept()[cap];
            TrimmedArc trimmed{.region = arc.region,
                               .angle = arc.angle,
                               .axis = builder_.kept_caps()[cap].axis,
                               .middle = regions_.middle(a)};
            if (k < kEdges)
                trimmed.edge = k;
            else
                trimmed.probe = caps_.atoms[k];
            patch.arcs.push_back(trimmed);
        }
    }

    const AccessibleSurface::Data& data_;
    std::uint64_t seed_;
    bool fills_arcs_in_;
    NearProbes near_;
    std::vector<Cap> probes_;  // that may reach into the triangle
    CapList caps_;             // of the sides and of probes_, as it is cut
    ContourBuilder builder_;
    SphericalRegions regions_;
};

template <class Visit>
void trim_each(const AccessibleSurface& surface, std::uint64_t seed, Arcs arcs, const Visit& visit) {
    if (surface.probe() == 0.0) return;
    parallel_chunks_with(
        surface.vertex_count(), kVerticesPerTask, [&] { return std::make_unique<Trimmer>(surface, seed, arcs); },
        [&](std::size_t begin, std::size_t end, Trimmer& trimmer) {
            ReentrantPatch patch;
            for (std::size_t v = begin; v < end; ++v) {
                trimmer.trim(static_cast<std::uint32_t>(v), patch);
                visit(static_cast<std::uint32_t>(v), patch);
            }
        });
}

}  // namespace

bool has_coincident_probes(const AccessibleSurface::Data& data) {
    return std::any_of(data.arcs.begin(), data.arcs.end(), [&](const SasArc& arc) {
        return !arc.whole_circle() &&
               norm(data.vertices[arc.end].position - data.vertices[arc.start].position) < kSamePosition;
    });
}

void for_each_reentrant_patch(const AccessibleSurface& surface, std::uint64_t seed,
                              const std::function<void(std::uint32_t, const ReentrantPatch&)>& visit) {
    trim_each(surface, seed, Arcs::LeftOut, visit);
}

std::vector<ReentrantPatch> trim_reentrant_patches(const AccessibleSurface& surface, std::uint64_t seed) {
    std::vector<ReentrantPatch> patches(surface.vertex_count());
    trim_each(surface, seed, Arcs::FilledIn, [&](std::uint32_t v, const ReentrantPatch& patch) { patches[v] = patch; });
    return patches;
}

std::uint32_t reentrant_region_of(const AccessibleSurface& surface, std::uint64_t seed, std::uint32_t vertex,
                                  const Vec3& direction) {
    Trimmer trimmer(surface, seed, Arcs::LeftOut);
    ReentrantPatch patch;
    trimmer.trim(vertex, patch);
    return patch.regions.size() > 1 ? trimmer.region_of(direction) : 0;
}

}  // namespace meniscus
