// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The inner loops of NearestBatch, over up to 64 points at once, for several instruction sets.
//
// Every set gives the same bits: vectors hold different points or features, whose numbers never meet. Arrays are read
// and written in whole vectors: up to 64 bytes beyond the end, where there need not be anything of sense.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/accessible_surface_data.h"
#include "nearest/local_features.h"
#include "nearest/nearest_feature.h"

namespace meniscus {

inline constexpr std::size_t kBatchLanes = 64;

/// Vectors may start at any lane: there is room for one that starts at the last.
template <class T>
struct alignas(64) LaneArray {
    T at[kBatchLanes + 64 / sizeof(T)]{};

    T& operator[](std::size_t lane) { return at[lane]; }
    const T& operator[](std::size_t lane) const { return at[lane]; }
};

template <class T>
struct LanePoints {
    LaneArray<T> x;
    LaneArray<T> y;
    LaneArray<T> z;
};

template <class T>
Vec3 get_point(const LanePoints<T>& points, std::size_t lane) {
    return {points.x[lane], points.y[lane], points.z[lane]};
}

template <class T>
void set_point(LanePoints<T>& points, std::size_t lane, const Vec3& p) {
    points.x[lane] = static_cast<T>(p.x);
    points.y[lane] = static_cast<T>(p.y);
    points.z[lane] = static_cast<T>(p.z);
}

struct LaneRange {
    std::size_t begin = 0;
    std::size_t end = 0;
};

/// What is known about points from a point in their middle, in single precision and relative to it: those near enough
/// to its foot are outside, those near enough to itself on its side.
struct PointScreen {
    float foot[3]{};
    float near_foot = 0.0F;    ///< squared distance, Å²; negative: the foot tells nothing
    float near_middle = 0.0F;  ///< distance, Å
    bool middle_inside = false;
};

/// Of kBatchLanes points, bit by bit: which are known to be inside, and of which it is known where they are.
struct KnownSides {
    std::uint64_t inside = 0;
    std::uint64_t settled = 0;
};

/// A ball in single precision, relative to a point nearby.
struct SmallBall {
    float x;
    float y;
    float z;
    float rho;
};

/// Per point: its depth in the ball where it is deepest, in the next one, and the position of the deepest ball in the
/// list (the first of equals). In single precision: for how much depths are off see NearestBatch.
struct Depths {
    LaneArray<float> first;
    LaneArray<float> second;
    LaneArray<std::int32_t> ball;
};

/// What depths tell about points: beyond which ones they are on one side of the margin, and by how much the deepest
/// ball must lead.
struct DepthLimits {
    float above = 0.0F;
    float below = 0.0F;
    float lead = 0.0F;
    std::int32_t balls = 0;  ///< their number
};
/// Where a point belongs: the position of its deepest ball, or, after the last ball, one of these.
inline constexpr std::int32_t kDoubtfulGroup = 0;
inline constexpr std::int32_t kAboveGroup = 1;
inline constexpr std::int32_t kBelowGroup = 2;
inline constexpr std::int32_t kSpecialGroups = 3;  ///< their number

/// A ball that may own points.
struct BallOwner {
    Vec3 centre;
    double rho = 0.0;
    bool exposed = false;
    std::span<const CapPlane> caps;  ///< where it is exposed
};

/// How far inside of a cell (FeatureWalk) points must be, as a length and as products of two and of three. Two features
/// are equally far but for rounding, some 1e-15 of the squares of lengths, up to 1e-7 of these beside their border,
/// since squared distances part with the square; three times that is surely further inside.
struct CellBorder {
    double length;  ///< Å
    double area;    ///< Å²
    double volume;  ///< Å³

    explicit CellBorder(double rho_max) : length(kPart * rho_max), area(length * rho_max), volume(area * rho_max) {}

private:
    static constexpr double kPart = 3e-7;  // of the largest radius
};

/// Per point, what its deepest ball says.
struct BallClaims {
    LaneArray<double> signed_distance;  ///< were the ball to own it
    LaneArray<double> rho;
    LaneArray<std::int64_t> owned;  ///< 0, or all bits set: see owned_by_ball() in nearest_feature.h
};

/// Per point, the nearest of what was offered so far: its squared distance, its tag, and, if it is an arc, how far the
/// point is from the arc's axis, and the arc's radius.
struct NearestTags {
    LaneArray<double> squared_distance;
    LaneArray<std::int64_t> tag;
    LaneArray<double> from_axis;
    LaneArray<double> radius;
};
inline std::int64_t vertex_tag(std::uint32_t vertex) { return vertex; }
inline std::int64_t arc_tag(std::uint32_t arc) { return -1 - std::int64_t{arc}; }
inline bool is_arc(std::int64_t tag) { return tag < 0; }
inline std::uint32_t arc_of(std::int64_t tag) { return static_cast<std::uint32_t>(-1 - tag); }

/// Where steps lead from points to the surface, and what is known of it there (SurfaceStep).
struct StepLanes {
    LanePoints<double> points;
    LanePoints<double> normals;
    LaneArray<double> mean;
    LaneArray<double> gaussian;       ///< +inf where both principal curvatures are the mean
    LaneArray<std::int64_t> settled;  ///< 0, or all bits set
};

/// One ball for each point.
struct BallLanes {
    LanePoints<double> centre;
    LaneArray<double> radius;  ///< without the probe
};

/// One arc for each point.
struct ArcLanes {
    LanePoints<double> centre;
    LanePoints<double> axis;
    LaneArray<double> radius;
    LaneArray<double> height0;
    LaneArray<double> height1;
    LaneArray<double> radius0;  ///< of its atoms
    LaneArray<double> radius1;

    void set(std::size_t lane, const SasArc& arc, const CanonicalAtoms& atoms) {
        set_point(centre, lane, arc.centre);
        set_point(axis, lane, arc.axis);
        radius[lane] = arc.radius;
        height0[lane] = arc.height0;
        height1[lane] = arc.height1;
        radius0[lane] = atoms.radii[arc.atoms[0]];
        radius1[lane] = atoms.radii[arc.atoms[1]];
    }
};

/// One vertex for each point, with its atoms.
struct VertexLanes {
    LanePoints<double> position;
    std::array<LanePoints<double>, 3> centres;
    std::array<LaneArray<double>, 3> radii;

    void set(std::size_t lane, const SasVertex& vertex, const CanonicalAtoms& atoms) {
        set_point(position, lane, vertex.position);
        for (std::size_t a = 0; a < 3; ++a) {
            set_point(centres[a], lane, atoms.centres[vertex.atoms[a]]);
            radii[a][lane] = atoms.radii[vertex.atoms[a]];
        }
    }
};

/// Marks are sets of items of a list, one bit for each (core/bits.h).
struct NearestKernels {
    std::string_view instructions;  ///< "plain", "avx2" or "avx512"

    /// Marks the spheres that, with radii enlarged by `beyond`, reach into a box.
    void (*mark_reaching)(const SphereList& spheres, double beyond, const Box& box, std::uint64_t* marks);
    /// Marks the boxes that overlap one.
    void (*mark_overlapping)(const BoxList& boxes, const Box& box, std::uint64_t* marks);
    /// How deep a point is in each ball; returns the position of one where it is deepest. There must be some.
    std::size_t (*find_depths_of)(const Vec3& point, const SphereList& balls, double* depths);
    /// Marks a ball and those that may be deeper than it somewhere in a box.
    void (*mark_contenders)(const SphereList& balls, std::size_t ball, const Box& box, std::uint64_t* marks);
    /// What is known of kBatchLanes points. from_middle: the points' distances from it.
    KnownSides (*screen)(const PointScreen& known, const LanePoints<float>& points,
                         const LaneArray<float>& from_middle);
    /// Points relative to one nearby, in single precision.
    void (*make_small)(const LanePoints<double>& points, const Vec3& origin, std::size_t count,
                       LanePoints<float>& small);
    void (*find_depths)(std::span<const SmallBall> balls, const LanePoints<float>& points, std::size_t count,
                        Depths& depths);
    void (*group_points)(const Depths& depths, const DepthLimits& limits, std::size_t count,
                         LaneArray<std::int32_t>& groups);
    void (*claim)(const BallOwner& ball, double probe, const LanePoints<double>& points, const LaneRange& lanes,
                  BallClaims& claims);
    /// Of a list, the items at `chosen`.
    void (*offer_vertices)(const SphereList& vertices, std::span<const std::uint32_t> chosen,
                           const LanePoints<double>& points, std::size_t count, NearestTags& nearest);
    /// Only where the nearest point of an arc is none of its ends, as foot_on_arc has it.
    void (*offer_arcs)(std::span<const SasArc> arcs, std::span<const std::uint32_t> chosen,
                       const LanePoints<double>& points, std::size_t count, NearestTags& nearest);
    /// Signed distances of points nearest to an arc or vertex.
    void (*find_edge_distances)(const NearestTags& nearest, double probe, std::size_t count,
                                LaneArray<double>& distances);
    /// Mean curvatures (parallel_curvature.h) of points that a ball owns, and of those nearest to an arc or vertex.
    void (*find_ball_curvatures)(const BallClaims& claims, double probe, std::size_t count,
                                 LaneArray<double>& curvatures);
    void (*find_edge_curvatures)(const NearestTags& nearest, double probe, std::size_t count,
                                 LaneArray<double>& curvatures);
    /// Steps from points that a ball owns, as step_from_ball() takes them, to the lanes from `to` on.
    void (*step_from_balls)(const LanePoints<double>& points, const BallLanes& balls, std::size_t count, std::size_t to,
                            StepLanes& steps);
    /// As step_from_arc(); also tells which atom is the nearest one, 0 or 1. Curvatures of steps that are not settled
    /// mean nothing.
    void (*step_from_arcs)(double probe, const LanePoints<double>& points, const ArcLanes& arcs, std::size_t count,
                           std::size_t to, StepLanes& steps, LaneArray<std::int64_t>& nearest);
    /// As step_from_vertex(), and which atom is the nearest one.
    void (*step_from_vertices)(double probe, const LanePoints<double>& points, const VertexLanes& vertices,
                               std::size_t count, std::size_t to, StepLanes& steps, LaneArray<std::int64_t>& nearest);
    /// Which of some lanes' points lie in a cell (FeatureWalk), further inside than `border`: bit by bit, as the lanes
    /// are given. The ball must be exposed, the arc no point.
    std::uint64_t (*find_in_ball_cell)(const BallOwner& ball, const CellBorder& border,
                                       const LanePoints<double>& points, std::uint64_t lanes);
    std::uint64_t (*find_in_arc_cell)(const SasArc& arc, const CellBorder& border, const LanePoints<double>& points,
                                      std::uint64_t lanes);
    std::uint64_t (*find_in_vertex_cell)(const VertexHull& hull, const CellBorder& border,
                                         const LanePoints<double>& points, std::uint64_t lanes);
    /// Clamps to ±limit; a NaN (0/0 on the SAS itself) becomes -limit.
    void (*clamp)(const LaneArray<double>& values, double limit, std::size_t count, LaneArray<float>& clamped);
    /// Sets those to 0 whose distance is not within ±margin.
    void (*clear_beyond)(const LaneArray<double>& distances, double margin, std::size_t count,
                         LaneArray<float>& values);
};

/// Those that this machine can run, the plainest first.
std::vector<NearestKernels> supported_nearest_kernels();

/// Those with the instructions that the environment variable MENISCUS_INSTRUCTIONS names, else the last ones; the same
/// from the first call to the end of the program.
const NearestKernels& nearest_kernels();

}  // namespace meniscus
