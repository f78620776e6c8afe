// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The inner loops of NeighbourCaps and ContourBuilder, many atoms or caps side by side, for several instruction sets.
//
// Every set gives the same bits: vectors hold different atoms or caps, whose numbers never meet. Columns are read and
// written in whole vectors: up to the next multiple of Columns::kStep, where there need not be anything of sense.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "core/columns.h"
#include "geometry/contour_types.h"

namespace meniscus {

using SmallBallColumns = Columns<4, float, 64>;  ///< centre, enlarged radius
using CapColumns = Columns<4>;                   ///< axis, t

/// Eight arcs of a contour side by side: the caps whose rims they run along, and their ends, the same point twice for a
/// whole rim.
struct EightArcs {
    static constexpr std::size_t kCount = 8;
    static constexpr std::size_t kAxis = 0;  ///< columns: three
    static constexpr std::size_t kT = 3;
    static constexpr std::size_t kStart = 4;  ///< three
    static constexpr std::size_t kEnd = 7;    ///< three
    static constexpr std::size_t kColumns = 10;

    std::array<double, kColumns * kCount> numbers{};  ///< column after column
};

/// How a cap meets eight arcs; a bit for each arc.
struct EightMeetings {
    unsigned start_inside = 0;  ///< the arc begins inside the cap
    unsigned end_inside = 0;
    unsigned twice = 0;  ///< both ends inside or both outside, but what is between leaves the cap or enters it
    /// Coordinates of the point where the arc leaves the cap that it begins inside of, else of where it enters it;
    /// without sense if it does neither.
    std::array<double, 3 * EightArcs::kCount> crossing{};
};

struct CapKernels {
    std::string_view instructions;  ///< "plain", "avx2" or "avx512"
    /// Marks the balls that meet one of them, or miss it by no more than `slack`: a bit for each (core/bits.h).
    void (*mark_meeting)(const SmallBallColumns& balls, std::size_t one, float slack, std::uint64_t* marks);
    /// Writes the caps that listed balls bury on a sphere, as cap_between has them, to the places of `caps` from `at`
    /// on; t >= 1 for a ball that misses the sphere. Up to the next multiple of eight the list must repeat its last
    /// ball, and caps must have room.
    ///
    /// returns  whether all balls that are listed bury a part of the sphere
    bool (*find_caps)(const Vec3* centres, const double* rhos, std::span<const std::uint32_t> list, const Vec3& centre,
                      double rho, std::size_t at, CapColumns& caps);
    /// The cap, the first of equals, that a direction is deepest in: by more than so much, with t as given and not as
    /// in the caps; caps.size() if there is none. Behind the last cap t must be such that nothing is inside.
    std::size_t (*find_deepest)(const CapColumns& caps, const double* t, const Vec3& direction, double more_than);
    /// How a cap meets the first `count` arcs.
    void (*meet_arcs)(std::span<const EightArcs> arcs, std::size_t count, const CapPlane& cap, EightMeetings* meetings);
    /// Marks the caps that may still change a contour: those that hold the end of an arc, or that an arc enters, or
    /// whose middle is buried by none of `buried`. In single precision: others by a hair, too.
    void (*mark_changing)(const CapColumns& caps, std::span<const EightArcs> arcs, std::size_t count,
                          std::span<const CapPlane> buried, std::uint64_t* marks);
};

/// Those that this machine can run, the plainest first.
std::vector<CapKernels> supported_cap_kernels();

/// Those with the instructions that the environment variable MENISCUS_INSTRUCTIONS names, else the last ones.
const CapKernels& cap_kernels();

}  // namespace meniscus
