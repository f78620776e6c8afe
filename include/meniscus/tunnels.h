// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Tunnels and pores: the widest ways through a molecule, with their narrowest places, exact.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "meniscus/exact_surface.h"
#include "meniscus/mesh.h"
#include "meniscus/surface.h"
#include "meniscus/vec3.h"

namespace meniscus {

// The clearance of a point is its smallest distance from an atom's centre less the atom's radius: the radius of the
// largest ball there that reaches into no atom.

/// A place on a way.
struct PathPoint {
    Vec3 position;          ///< Å
    double distance = 0.0;  ///< from the beginning, along the way, Å
    double radius = 0.0;    ///< the clearance, Å
};

/// The narrowest place of a way.
struct Bottleneck {
    double radius = 0.0;    ///< Å
    Vec3 position;          ///< Å
    std::size_t point = 0;  ///< index into TunnelPath::points
    /// The caller's indices of the three atoms that a ball of that radius touches there, in rising order: its centre
    /// lies in the plane of theirs. Where the narrowest place is an end, the nearest atoms; kNone where there are less.
    std::array<std::uint32_t, 3> atoms{};
    bool at_end = false;  ///< not between three atoms but at the beginning of the way, or where it was cut off
};

/// A way and its shape.
struct TunnelPath {
    std::vector<PathPoint> points;  ///< a polyline, at most 0.25 Å apart
    Bottleneck bottleneck;
    /// The least clearance of the whole polyline, segments included, Å. Proves that a ball of this radius passes; it
    /// differs from Bottleneck::radius, which no way exceeds, only by rounding.
    double certified_radius = 0.0;
    double length = 0.0;     ///< Å
    double curvature = 1.0;  ///< length over the straight distance of the ends
};

/// A way from a start to the bulk.
struct Tunnel {
    std::size_t start = 0;  ///< index of its start
    std::size_t rank = 0;   ///< among those of its start, from 1: the widest first
    TunnelPath path;        ///< from the start outwards
};

/// Which tunnels are looked for. Lengths in Å.
struct TunnelOptions {
    double min_radius = 0.9;    ///< of bottlenecks
    double large_probe = 10.0;  ///< tunnels end where its SES ends, outside of which is the bulk
    int count = 3;              ///< tunnels per start
    double start_radius = 3.0;  ///< how far a start may be moved to a place of larger clearance
    double separation = 3.0;    ///< a further tunnel passes no three atoms that are as near to an earlier bottleneck
};

/// For every start, the way to the bulk with the widest bottleneck; of those, the one along which the integral of
/// 1/radius² is smallest. Then further ones that have other bottlenecks and other ends.
///
/// starts   moved uphill, by start_radius at most, to a maximum of clearance
/// returns  by start, then by rank; none for a start in the bulk, and for one that no ball of min_radius leaves
/// throws   UsageError for options out of range and starts that are not finite; LimitError for atoms spread too far;
///          as ExactSurface::accessible()
/// cost     some 0.1 ms per atom
/// source   docs/design/tunnels.md
std::vector<Tunnel> find_tunnels(const ExactSurface& exact, std::span<const Vec3> starts,
                                 const TunnelOptions& options = {}, const RunOptions& run = {});

/// Which pore is looked for. Lengths in Å.
struct PoreOptions {
    double min_radius = 0.5;    ///< of the bottleneck
    double reach = 10.0;        ///< how far from the straight line through both ends the pore may run
    double start_radius = 3.0;  ///< how far the ends may be moved to a place of larger clearance
};

/// The ends of a pore.
struct PoreEnds {
    Vec3 from;
    Vec3 to;
};

/// The ends of a line through a point where it leaves the slab that holds all atoms.
///
/// throws   UsageError for a direction without length, and for numbers that are not finite
PoreEnds ends_along(const ExactSurface& exact, const Vec3& point, const Vec3& direction);

/// The way with the widest bottleneck from one end to the other; as find_tunnels() otherwise. Clearance decides, not
/// pocket space: a pore may be wider than any probe.
///
/// returns  nothing where no ball of min_radius passes
/// throws   UsageError for options out of range and ends that are the same; as find_tunnels()
std::optional<TunnelPath> find_pore(const ExactSurface& exact, const PoreEnds& ends, const PoreOptions& options = {},
                                    const RunOptions& run = {});

}  // namespace meniscus
