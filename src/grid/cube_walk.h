// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The cubes of a regular lattice that a ray passes, in order (Amanatides & Woo 1987).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace meniscus {

/// A line: origin + t * direction, in any one unit of length.
struct Line {
    std::array<double, 3> origin{};
    std::array<double, 3> direction{};

    double at(std::size_t axis, double t) const { return origin[axis] + t * direction[axis]; }
};

/// The part of a line between two values of t.
struct Stretch {
    double begin = 0.0;
    double end = 0.0;

    bool empty() const { return !(begin <= end); }
};

/// The part of a stretch that lies in the box [low, high]; may be empty.
inline Stretch clipped(const Line& line, Stretch stretch, const std::array<double, 3>& low,
                       const std::array<double, 3>& high) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double d = line.direction[axis];
        const double o = line.origin[axis];
        if (d == 0.0) {
            if (o < low[axis] || o > high[axis]) return {1.0, 0.0};
            continue;
        }
        const double t1 = (low[axis] - o) / d;
        const double t2 = (high[axis] - o) / d;
        stretch.begin = std::max(stretch.begin, std::min(t1, t2));
        stretch.end = std::min(stretch.end, std::max(t1, t2));
    }
    return stretch;
}

/// Walks through the cubes of edge `edge` between the beginning and the end of a stretch, which must be finite.
///
/// Where each cube is entered and left follows from its number, so that no error grows along the way; the parts in
/// successive cubes join without gaps.
class CubeWalk {
public:
    CubeWalk(const Line& line, double edge, const Stretch& stretch) : line_(line), edge_(edge), stretch_(stretch) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double d = line.direction[axis];
            cube_[axis] = static_cast<std::int64_t>(std::floor(line.at(axis, stretch.begin) / edge));
            // Along an axis that is as good as normal to the line no border is ever met.
            step_[axis] = std::abs(d) < kNormal ? 0 : (d > 0.0 ? 1 : -1);
            per_length_[axis] = step_[axis] == 0 ? 0.0 : 1.0 / d;
            next_[axis] = border(axis);
        }
    }

    const std::array<std::int64_t, 3>& cube() const { return cube_; }
    /// The part of the line in the current cube.
    Stretch part() const { return {stretch_.begin, std::clamp(next_[next_axis()], stretch_.begin, stretch_.end)}; }

    /// Goes to the next cube; false if the stretch ends in this one.
    bool advance() {
        const std::size_t axis = next_axis();
        if (!(next_[axis] < stretch_.end)) return false;
        stretch_.begin = std::max(stretch_.begin, next_[axis]);
        cube_[axis] += step_[axis];
        next_[axis] = border(axis);
        return true;
    }

private:
    static constexpr double kNormal = 1e-30;

    std::size_t next_axis() const {
        return static_cast<std::size_t>(std::min_element(next_.begin(), next_.end()) - next_.begin());
    }
    double border(std::size_t axis) const {
        if (step_[axis] == 0) return std::numeric_limits<double>::infinity();
        const std::int64_t ahead = cube_[axis] + (step_[axis] > 0 ? 1 : 0);
        return (edge_ * static_cast<double>(ahead) - line_.origin[axis]) * per_length_[axis];
    }

    Line line_;
    double edge_;
    Stretch stretch_;
    std::array<std::int64_t, 3> cube_{};
    std::array<std::int64_t, 3> step_{};
    std::array<double, 3> per_length_{};
    std::array<double, 3> next_{};
};

}  // namespace meniscus
