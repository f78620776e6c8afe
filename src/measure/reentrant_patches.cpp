// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/reentrant_patches.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "core/mix_bits.h"
#include "core/parallel.h"
#include "core/workspaces.h"

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

// Solid angle of the triangle of three unit vectors (van Oosterom & Strackee 1983).
double triangle_angle(const std::array<Vec3, 3>& d) {
    const double volume = std::abs(dot(d[0], cross(d[1], d[2])));
    return 2.0 * std::atan2(volume, 1.0 + dot(d[0], d[1]) + dot(d[1], d[2]) + dot(d[2], d[0]));
}

enum class Arcs : std::uint8_t { FilledIn, LeftOut };

// Trims one patch after the other, reusing its memory.
class Trimmer {
public:
    Trimmer(const AccessibleSurface& surface, std::uint64_t seed, Arcs arcs)
        : data_(surface.data()), seed_(seed), fills_arcs_in_(arcs == Arcs::FilledIn) {}

    void trim(std::uint32_t v, ReentrantPatch& patch) {
        patch.consistent = true;
        patch.degenerate = false;
        patch.triangle = gather_edges(v);
        gather_probes(v, patch);
        whole_ = base_.size() == kEdges && is_wide(patch.triangle);
        if (whole_) return take_whole(patch);
        for (int attempt = 0; attempt < kMaxAttempts; ++attempt) {
            patch.degenerate = patch.degenerate || attempt > 0;
            if (cut(v, attempt, patch)) return;
        }
        patch.regions.clear();
        patch.arcs.clear();
        patch.consistent = false;
    }

    /// Of the patch trimmed last.
    std::uint32_t region_of(const Vec3& direction) const { return whole_ ? 0 : regions_.region_of(direction); }

private:
    static constexpr std::uint32_t kEdges = 3;

    // Hemispheres beyond the triangle's sides; returns its solid angle.
    double gather_edges(std::uint32_t v) {
        const SasVertex& vertex = data_.vertices[v];
        std::array<Vec3, 3>& d = corners_;
        for (std::size_t k = 0; k < 3; ++k) d[k] = normalised(data_.atoms.centres[vertex.atoms[k]] - vertex.position);
        base_.clear();
        for (std::uint32_t k = 0; k < kEdges; ++k)
            base_.push_back({normalised(cross(d[k], d[(k + 1) % 3])), 0.0, k});  // away from the third: see SasVertex
        const Vec3 sum = d[0] + d[1] + d[2];
        const Vec3 middle = (1.0 / std::max(norm(sum), 1e-3)) * sum;
        may_miss_ = std::min({dot(middle, d[0]), dot(middle, d[1]), dot(middle, d[2])}) > 1e-3;
        return triangle_angle(d);
    }

    // Whether a triangle that no other probe reaches is all there is, rounding or not: no sliver and no hemisphere.
    bool is_wide(double solid_angle) const {
        constexpr double kSliver = 1e-6;  // steradian
        return may_miss_ && solid_angle > kSliver;
    }

    void take_whole(ReentrantPatch& patch) {
        SphericalRegion region{patch.triangle, {}};
        patch.arcs.clear();
        for (std::uint32_t k = 0; k < kEdges; ++k) {
            const Vec3& from = corners_[k];
            const Vec3& to = corners_[(k + 1) % kEdges];
            const double angle = std::atan2(norm(cross(from, to)), dot(from, to));
            region.vector_area += -0.5 * angle * base_[k].axis;  // ½ ∮ n × dn along great circles
            if (!fills_arcs_in_) continue;
            patch.arcs.push_back({.edge = k, .angle = angle, .axis = base_[k].axis, .middle = normalised(from + to)});
        }
        patch.regions.assign(1, region);
    }

    // Whether a probe's cap is known to lie beyond the sides of the triangle: wholly beyond one of them, as nearly all
    // are that miss it, or off the nearest direction of the triangle.
    bool misses_triangle(const Vec3& axis, double t) const {
        constexpr double kSlack = 1e-6;  // shifts of planes, rounding
        const double sine = std::sqrt(1.0 - t * t);
        const std::array<double, kEdges> beyond{dot(axis, base_[0].axis), dot(axis, base_[1].axis),
                                                dot(axis, base_[2].axis)};
        if (std::max({beyond[0], beyond[1], beyond[2]}) > sine + kSlack) return true;
        return may_miss_ && nearest_in_triangle(axis, beyond) < t - kSlack;
    }

    // Cosine of the angle from a direction to the nearest one of the triangle: itself, or on a side that it lies
    // beyond.
    double nearest_in_triangle(const Vec3& axis, const std::array<double, kEdges>& beyond) const {
        double nearest = -1.0;
        bool inside = true;
        for (std::size_t k = 0; k < kEdges; ++k) {
            if (beyond[k] <= 0.0) continue;
            inside = false;
            const Vec3& from = corners_[k];
            const Vec3& to = corners_[(k + 1) % kEdges];
            const Vec3 across = cross(axis, base_[k].axis);
            const bool faces_side = dot(across, from) >= 0.0 && dot(across, to) <= 0.0;
            nearest = std::max(nearest, faces_side ? std::sqrt(std::max(0.0, 1.0 - beyond[k] * beyond[k]))
                                                   : std::max(dot(axis, from), dot(axis, to)));
        }
        return inside ? 1.0 : nearest;
    }

    // Neighbouring vertices share a search: they are numbered in spatial order.
    void search_near(std::uint32_t v) {
        constexpr std::uint32_t kGroup = 8;
        constexpr double kLargestBox = 4.0;  // Å
        const double reach = 2.0 * data_.probe;
        Box box;
        box.include(data_.vertices[v].position);
        searched_end_ = v + 1;
        while (searched_end_ < data_.vertices.size() && searched_end_ < v + kGroup) {
            Box larger = box;
            larger.include(data_.vertices[searched_end_].position);
            if (norm(larger.high - larger.low) > kLargestBox) break;
            box = larger;
            ++searched_end_;
        }
        searched_begin_ = v;
        near_.clear();
        data_.vertex_tree.for_each_overlapping(box.grown(reach), [&](std::uint32_t w) { near_.push_back(w); });
    }

    void gather_probes(std::uint32_t v, ReentrantPatch& patch) {
        if (v < searched_begin_ || v >= searched_end_) search_near(v);
        const Vec3& at = data_.vertices[v].position;
        const double reach = 2.0 * data_.probe;
        for (const std::uint32_t w : near_) {
            if (w == v) continue;
            const Vec3 between = data_.vertices[w].position - at;
            const double d2 = squared_norm(between);
            if (d2 >= reach * reach) continue;
            const double d = std::sqrt(d2);
            if (d < kSamePosition)
                patch.degenerate = true;
            else if (!misses_triangle((1.0 / d) * between, d / reach))
                base_.push_back({(1.0 / d) * between, d / reach, w});
        }
    }

    bool cut(std::uint32_t v, int attempt, ReentrantPatch& patch) {
        caps_ = base_;
        const double growth = std::pow(10.0, std::max(0, attempt - kMaxAttempts / 2));
        for (std::size_t k = kEdges; k < caps_.size(); ++k)
            caps_[k].t +=
                growth * plane_shift(v, caps_[k].atom, seed_ + 977 * static_cast<std::uint64_t>(attempt)) / data_.probe;
        if (!builder_.build(caps_)) return false;
        planes_.clear();
        for (const Cap& cap : caps_) planes_.push_back({cap.axis, cap.t});
        regions_.measure(planes_, builder_.arcs(), builder_.kept());
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
            const std::uint32_t k = builder_.arcs()[a].cap;
            TrimmedArc trimmed{
                .region = arc.region, .angle = arc.angle, .axis = caps_[k].axis, .middle = regions_.middle(a)};
            if (k < kEdges)
                trimmed.edge = k;
            else
                trimmed.probe = caps_[k].atom;
            patch.arcs.push_back(trimmed);
        }
    }

    const AccessibleSurface::Data& data_;
    std::uint64_t seed_;
    bool fills_arcs_in_;
    std::uint32_t searched_begin_ = 0;  // vertices that near_ is complete for
    std::uint32_t searched_end_ = 0;
    std::vector<std::uint32_t> near_;
    std::array<Vec3, 3> corners_;  // of the triangle, directions from the probe
    bool whole_ = false;           // the triangle trimmed last
    bool may_miss_ = false;        // its corners lie within a hemisphere round their mean, not at its rim
    std::vector<Cap> base_;
    std::vector<Cap> caps_;
    std::vector<CapPlane> planes_;  // of caps_
    ContourBuilder builder_;
    SphericalRegions regions_;
};

template <class Visit>
void trim_each(const AccessibleSurface& surface, std::uint64_t seed, Arcs arcs, const Visit& visit) {
    if (surface.probe() == 0.0) return;
    Workspaces trimmers([&] { return std::make_unique<Trimmer>(surface, seed, arcs); });
    parallel_chunks(surface.vertex_count(), 128, [&](std::size_t begin, std::size_t end) {
        trimmers.with_one([&](Trimmer& trimmer) {
            ReentrantPatch patch;
            for (std::size_t v = begin; v < end; ++v) {
                trimmer.trim(static_cast<std::uint32_t>(v), patch);
                visit(static_cast<std::uint32_t>(v), patch);
            }
        });
    });
}

}  // namespace

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
    return trimmer.region_of(direction);
}

}  // namespace meniscus
