// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Features of the SAS in single precision, relative to a point nearby: enough to tell which side of the SES most points
// are on.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/columns.h"
#include "geometry/accessible_surface_data.h"
#include "meniscus/vec3.h"
#include "nearest/local_features.h"

namespace meniscus {

struct SideArc {
    SmallVec3 centre;  ///< of the circle, Å
    SmallVec3 axis;    ///< unit vector
    SmallVec3 middle;  ///< unit vector from the centre to the arc's midpoint
    float radius;      ///< of the circle, Å
    float cos_half;    ///< cosine of half the angle; below -1 for a whole circle
};

/// All features that can be nearest to some points. Lengths in Å.
struct SideFeatures {
    Columns<4, float> balls;           ///< x, y, z, rho
    std::vector<std::uint32_t> atoms;  ///< whose balls they are; there may be more
    std::vector<SideArc> arcs;
    Columns<3, float> vertices;  ///< x, y, z
};

/// The features that can be nearest to points of a box, relative to its middle, with what to choose from them by.
struct SideFeaturesOfBox {
    SideFeatures features;
    Columns<6, float> cells;  ///< of the arcs: low x, y, z, high x, y, z
};

/// Gathers them for one box after the other, reusing its memory.
class SideGatherer {
public:
    /// from: lists for a box around this one, which are complete as far as `margin` (LocalFeatures).
    void gather(const LocalFeatures& from, const Box& box, double margin, SideFeaturesOfBox& near);

private:
    // The items that are marked.
    std::span<const std::uint32_t> marked(std::size_t count);

    std::vector<std::uint64_t> marks_;
    std::vector<std::uint32_t> items_;
};

/// Caps of one ball side by side. Those without numbers bury nothing: a point at l from the ball's centre exceeds
/// others, whose |t| <= 1, by no less than -2 l, and these by -kNothing l.
struct EightCaps {
    static constexpr float kNothing = 1e6F;  ///< for t
    static constexpr std::size_t kCount = 8;
    std::array<float, kCount> x{};
    std::array<float, kCount> y{};
    std::array<float, kCount> z{};
    std::array<float, kCount> t{kNothing, kNothing, kNothing, kNothing, kNothing, kNothing, kNothing, kNothing};
};

/// The caps of all balls in single precision.
class SideCaps {
public:
    explicit SideCaps(const AccessibleSurface::Data& data);

    bool is_exposed(std::uint32_t atom) const { return exposed_[atom] != 0; }
    /// Of an exposed ball; none of others.
    std::span<const EightCaps> of(std::uint32_t atom) const {
        return std::span(caps_).subspan(begins_[atom], begins_[atom + 1] - begins_[atom]);
    }

private:
    std::span<const std::uint8_t> exposed_;  // per atom
    std::vector<std::size_t> begins_;        // per atom, and the end
    std::vector<EightCaps> caps_;
};

}  // namespace meniscus
