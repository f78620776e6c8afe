// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The inner loops of NeighbourCaps and ContourBuilder, many atoms or caps side by side, for several instruction sets.
//
// Every set gives the same bits: vectors hold different atoms or caps, whose numbers never meet. Columns are read and
// written in whole vectors: up to the next multiple of eight, where there need not be anything of sense.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "geometry/contour_types.h"

namespace meniscus {

/// Numbers of many items side by side, `kCount` of each.
template <std::size_t kCount>
class Columns {
public:
    static constexpr std::size_t kStep = 8;  // columns are readable up to the next multiple

    /// Keeps nothing that was in it.
    void resize(std::size_t items) {
        size_ = items;
        if (columns_[0].size() >= padded_size()) return;
        for (std::vector<double>& column : columns_) column.resize(padded_size());
    }
    std::size_t size() const { return size_; }
    std::size_t padded_size() const { return (size_ + kStep - 1) / kStep * kStep; }
    double* operator[](std::size_t column) { return columns_[column].data(); }
    const double* operator[](std::size_t column) const { return columns_[column].data(); }

private:
    std::size_t size_ = 0;
    std::array<std::vector<double>, kCount> columns_;
};

using BallColumns = Columns<4>;  ///< centre, enlarged radius
using CapColumns = Columns<5>;   ///< axis, t, sine of the rim's angle

using NeighbourColumns = Columns<4>;  ///< axis, t of the caps that balls bury; without sense where they bury none

/// The rim of a cap, and the frame that pseudo-angles along it are measured in.
struct Rim {
    Vec3 axis;
    double t = 0.0;
    Vec3 e1;  ///< direction of pseudo-angle 0
    Vec3 e2;  ///< a quarter turn clockwise around the cap
};

/// Where rims meet that of one other cap.
struct MeetingColumns : Columns<9> {
    static constexpr std::size_t kDiscriminant = 0;  ///< positive where the rims cross
    static constexpr std::size_t kOnto = 1;  ///< three: the point where the contour passes from the rim onto the cap's
    static constexpr std::size_t kBack = 4;  ///< three: and back onto the rim
    static constexpr std::size_t kAngleOnto = 7;  ///< their pseudo-angles along the rim
    static constexpr std::size_t kAngleBack = 8;
};

struct CapKernels {
    std::string_view instructions;  ///< "plain", "avx2" or "avx512"
    /// The caps that balls bury on a sphere, as cap_between has them, and marks for the balls that meet it: a bit for
    /// each (core/bits.h).
    void (*find_caps)(const BallColumns& balls, const Vec3& centre, double rho, NeighbourColumns& caps,
                      std::uint64_t* marks);
    /// The cap, the first of equals, that a direction is deepest in; caps.size() if it is in none. Behind the last cap
    /// t must be such that nothing is inside.
    std::size_t (*find_deepest)(const CapColumns& caps, const Vec3& direction);
    /// idle[k] > 0: the cap is apart from all arcs and its middle is buried by one of `buried`, so it changes nothing.
    void (*find_idle)(const CapColumns& caps, std::span<const ArcExtent> arcs, std::span<const Cap> buried,
                      double* idle);
    /// Where those of `rims` that are listed meet the rim of `cap`; as cross_rims has it.
    void (*find_meetings)(std::span<const Rim> rims, std::span<const std::uint32_t> list, const Cap& cap,
                          MeetingColumns& meetings);
};

/// Those that this machine can run, the plainest first.
std::vector<CapKernels> supported_cap_kernels();

/// Those with the instructions that the environment variable MENISCUS_INSTRUCTIONS names, else the last ones.
const CapKernels& cap_kernels();

}  // namespace meniscus
