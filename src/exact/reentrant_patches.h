// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Reentrant patches: spherical triangles on probe positions, trimmed by every overlapping probe position.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "geometry/accessible_surface_data.h"
#include "geometry/spherical_region.h"

namespace meniscus {

/// What bounds a stretch of a trimmed patch: an edge of its triangle (beside a torus) or another probe.
struct TrimmedArc {
    static constexpr std::uint32_t kNoProbe = 0xffffffffU;

    std::uint32_t probe = kNoProbe;  ///< the other vertex, or kNoProbe for an edge
    std::uint32_t edge = 0;          ///< 0: atoms 0-1 of the vertex, 1: atoms 1-2, 2: atoms 2-0
    std::uint32_t region = 0;        ///< of the patch, on the exposed side
    double angle = 0.0;              ///< swept along the rim, radian
    Vec3 axis;                       ///< of the rim
    Vec3 middle;                     ///< direction from the probe's centre
};

/// The reentrant patch of one vertex: what is left of its triangle, in connected regions.
struct ReentrantPatch {
    std::vector<SphericalRegion> regions;
    std::vector<TrimmedArc> arcs;
    double triangle = 0.0;    ///< solid angle of the untrimmed triangle, steradian
    bool consistent = true;   ///< false: the trimming could not be resolved; regions are then empty
    bool degenerate = false;  ///< another probe position among those that trim it coincides with its own, or the
                              ///< trimming had to be perturbed anew
};

/// Trims the triangles of all vertices.
///
/// Planes between probes are shifted by about 1e-9 Å, differently for every pair and seed: all probes of a pair of
/// atoms whose circle is smaller than the probe have bisector planes through one line, in ordinary proteins too.
/// cost     linear at protein density; parallel over vertices
std::vector<ReentrantPatch> trim_reentrant_patches(const AccessibleSurface& surface, std::uint64_t seed);

/// Whether probe positions at both ends of some arc coincide, as where more than three spheres meet in a point.
bool has_coincident_probes(const AccessibleSurface::Data& data);

/// Vertices v with the same v / kVerticesPerTask are visited by one thread, in their order.
inline constexpr std::size_t kVerticesPerTask = 128;

/// The same patches one after the other, without their arcs: calls visit(vertex, patch), from several threads, each
/// vertex once.
void for_each_reentrant_patch(const AccessibleSurface& surface, std::uint64_t seed,
                              const std::function<void(std::uint32_t, const ReentrantPatch&)>& visit);

/// The region of a trimmed patch that holds a direction; trims the patch again, with the same result.
std::uint32_t reentrant_region_of(const AccessibleSurface& surface, std::uint64_t seed, std::uint32_t vertex,
                                  const Vec3& direction);

}  // namespace meniscus
