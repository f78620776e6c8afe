// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What triangles measure, many side by side, for several instruction sets.
//
// Every set gives the same bits: vectors hold different triangles, whose numbers never meet.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "measure/lanes.h"
#include "meniscus/mesh.h"
#include "space/box_tree.h"

namespace meniscus {

/// kLanes triangles, and what a kernel finds out about each: Å, Å² and Å³.
struct TriangleLanes {
    std::array<VectorLanes, 3> points;        ///< corners, from an origin nearby
    std::optional<Vec3> origin{Vec3{}};       ///< if it is the same for all
    std::array<SmallVectorLanes, 3> normals;  ///< of the surface there

    Lanes two_areas{};
    Lanes six_volumes{};  ///< over the origin
    /// Square of the tangent of the smallest corner, as a fraction of two finite numbers; 0 for a point.
    Lanes opposite{};
    Lanes adjacent{};
    Lanes shortest{};                       ///< side, squared
    Lanes longest{};                        ///< side, squared
    SmallLanes thirds{};                    ///< of the areas
    std::array<SmallVectorLanes, 3> sides;  ///< from each corner to the next
    /// Scalar products of the triangle's normal, twice its area long, with that of the surface.
    SmallLanes facing{};          ///< at the first corner
    SmallLanes least_facing{};    ///< the smallest of the three
    SmallLanes squared_normal{};  ///< the triangle's
    /// Sums over the four parts of each, split at the middles of the arcs over its sides (measure/corrected.h).
    SmallLanes parts_two_areas{};
    Lanes parts_six_volumes{};
};

/// What the shapes of kLanes triangles are like (meniscus/mesh_quality.h).
struct TriangleShapes {
    std::array<Lanes, 3> sides;    ///< lengths, opposite to each corner, Å
    std::array<Lanes, 3> cosines;  ///< of the angle at each corner; 1 at an end of a side without length
    Lanes one_less_cosine;         ///< of the smallest angle
    Lanes aspect_ratio;            ///< infinite without an area
};

/// What some of kLanes values are, bit by bit, beside the numbers of a bracket.
struct Bracket {
    double low = 0.0;
    double high = 0.0;
};
struct BracketMarks {
    std::uint64_t below = 0;   ///< less than the lower one
    std::uint64_t within = 0;  ///< neither that nor more than the higher one
};

/// Some triangles of a surface that may have creases over their sides (measure/creases.h), side by side.
struct CreasedLanes {
    static constexpr std::size_t kCount = 8;
    using Numbers = std::array<double, kCount>;
    using SmallNumbers = std::array<float, kCount>;

    struct Corner {
        LanesOf<double, Vec3, kCount> point;
        LanesOf<float, SmallVec3, kCount> normal;
        SmallNumbers mean_curvature{};      ///< Å^-1
        SmallNumbers gaussian_curvature{};  ///< Å^-2
    };
    std::array<Corner, 3> corners;

    /// Sums over the four parts of each, split at its creases and at the middles of the arcs over its other sides.
    Numbers two_areas{};
    Numbers six_volumes{};
};

/// Square of the tangent of an angle below 90 degrees, as a fraction: compared without dividing.
struct SquaredTangent {
    double opposite = 3.0;  ///< of 60 degrees: no triangle has a larger smallest corner
    double adjacent = 1.0;

    bool operator<(const SquaredTangent& b) const { return opposite * b.adjacent < b.opposite * adjacent; }
    /// The smaller of both.
    SquaredTangent& operator+=(const SquaredTangent& b) { return *this = b < *this ? b : *this; }
};

/// What triangles measure together: Å² and Å³, as in TriangleLanes.
struct LaneSums {
    double two_areas = 0.0;
    double six_volumes = 0.0;
    double parts_two_areas = 0.0;
    double parts_six_volumes = 0.0;
    SquaredTangent smallest;
    double shortest = std::numeric_limits<double>::infinity();  ///< side, squared
};

/// What makes a triangle suspect.
struct SuspectLimits {
    double squared_tangent = 0.0;  ///< of the smallest angle that is good enough
    double squared_edge = 0.0;     ///< of the shortest side that is, Å²
    double squared_cosine = 0.0;   ///< of the angle with a corner's normal from which on a triangle leans
};
/// A bit for each of kLanes triangles.
struct SuspectMarks {
    std::uint64_t may_be_bad = 0;  ///< too small an angle or side, or the surface looks the other way
    std::uint64_t leaning = 0;
};
static_assert(kLanes == 64);

/// Boxes round kStretchLanes triangles each.
inline constexpr std::size_t kStretchLanes = 16;
using StretchBoxes = std::array<Box, kLanes / kStretchLanes>;

/// The triangles (v, from, to) round a vertex v: what lies behind them, a step each. Where there are fewer, v stands in
/// the rest.
struct HalfStar {
    static constexpr std::uint32_t kSteps = 8;
    std::array<VertexId, kSteps> from;
    std::array<VertexId, kSteps> to;
};

struct TriangleKernels {
    std::string_view instructions;  ///< "plain", "avx2" or "avx512"

    /// Copies the corners of at most kLanes triangles, from an origin, and the normals there unless they are null.
    void (*gather)(const Vec3* points, const SmallVec3* normals, std::span<const Triangle> triangles,
                   const Vec3& origin, TriangleLanes& lanes);
    /// After gather.
    void (*measure_shapes)(const TriangleLanes& lanes, TriangleShapes& shapes);
    /// Finds which of all lanes are below and within a bracket.
    BracketMarks (*bracket)(const Lanes& values, const Bracket& bracket);
    /// Measures all that needs no normals.
    void (*measure)(TriangleLanes& lanes);
    /// Measures all but the parts.
    void (*measure_with_normals)(TriangleLanes& lanes);
    /// Returns a bit for each triangle along a side of which the surface turns so fast that it may have a crease there
    /// (measure/creases.h).
    std::uint64_t (*measure_with_parts)(TriangleLanes& lanes);
    /// Measures the first `count` triangles; returns a bit for each of these with a crease over one or more of its
    /// sides.
    std::uint64_t (*measure_over_creases)(CreasedLanes& lanes, std::size_t count);
    /// Sums over all lanes; those of the parts mean nothing where they were not measured.
    void (*add_up)(const TriangleLanes& lanes, LaneSums& sums);
    /// After measure_with_normals.
    SuspectMarks (*mark)(const TriangleLanes& lanes, const SuspectLimits& limits);
    /// The least and the largest of all lanes.
    double (*find_least)(const Lanes& lanes);
    double (*find_largest)(const Lanes& lanes);
    /// The boxes are relative to the origin of the lanes.
    void (*bound)(const TriangleLanes& lanes, StretchBoxes& boxes);
    /// The largest of some indices, 0 of none.
    std::uint32_t (*find_largest_index)(std::span<const std::uint32_t> indices);
    /// Tells, bit by bit, which of at most 64 stars are one ring each. Stars are as long as their sizes tell, with
    /// their first steps in one half star, and from kSteps on the others in a second one; from 2 kSteps on none is a
    /// ring.
    std::uint64_t (*find_rings)(std::span<const HalfStar> stars, const HalfStar* second_halves,
                                std::span<const std::uint32_t> sizes);
    /// Twice the signed areas of triangles whose corners are sent to any places of the parabola y = x², modulo 2^64.
    std::uint64_t (*sum_signed_areas)(std::span<const Triangle> triangles);
};

/// The kernels that this machine can run, the plainest first.
std::vector<TriangleKernels> supported_triangle_kernels();

/// The ones that MENISCUS_INSTRUCTIONS names, else the last of them (simd/instructions.h); the same from the first call
/// to the end of the program.
const TriangleKernels& triangle_kernels();

}  // namespace meniscus
