// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "grid/ray_crossing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

#include "grid/cube_walk.h"
#include "grid/spline_cursor.h"

namespace meniscus {
namespace {

constexpr double kSamplesPerSpacing = 8.0;  // as LevelSet::intersect promises
constexpr double kCloseBracket = 1e-8;      // in spacings

// A ray on its way; lengths in spacings from the grid's origin.
class Crossing {
public:
    Crossing(const BlockGrid& grid, std::span<const float> coefficients, const Line& line)
        : grid_(grid), cursor_(grid, coefficients), line_(line) {}

    std::optional<double> find(const Stretch& stretch) {
        return blocks_along(stretch) > static_cast<double>(grid_.block_count()) ? find_from_block_to_block(stretch)
                                                                                : find_step_by_step(stretch);
    }

private:
    // About as many block's edges as a stretch passes.
    double blocks_along(const Stretch& stretch) const {
        double most = 0.0;
        for (const double d : line_.direction) most = std::max(most, std::abs(d));
        return most * (stretch.end - stretch.begin) / kBlockEdge;
    }

    std::optional<double> find_step_by_step(const Stretch& stretch) {
        CubeWalk blocks(line_, kBlockEdge, stretch);
        do {
            if (is_missing(blocks.cube()))
                was_inside_.reset();
            else if (const auto found = find_in_block(blocks.part()))
                return found;
        } while (blocks.advance());
        return std::nullopt;
    }

    // Where blocks lie so far apart that looking at all of them takes less than going from one to the next.
    std::optional<double> find_from_block_to_block(const Stretch& stretch) {
        std::vector<Stretch> parts;
        for (const BlockCoord& c : grid_.coords()) {
            const auto at = [](double x, double y, double z) {
                return std::array<double, 3>{kBlockEdge * x, kBlockEdge * y, kBlockEdge * z};
            };
            const Stretch part = clipped(line_, stretch, at(c.x, c.y, c.z), at(c.x + 1.0, c.y + 1.0, c.z + 1.0));
            if (!part.empty()) parts.push_back(part);
        }
        std::sort(parts.begin(), parts.end(), [](const Stretch& a, const Stretch& b) {
            return std::pair(a.begin, a.end) < std::pair(b.begin, b.end);
        });
        double end = stretch.begin;
        for (const Stretch& part : parts) {
            if (part.begin > end) was_inside_.reset();
            if (const auto found = find_in_block(part)) return found;
            end = part.end;
        }
        return std::nullopt;
    }

    bool is_missing(const std::array<std::int64_t, 3>& cube) const {
        const auto number = [&](std::size_t axis) { return static_cast<std::int32_t>(cube[axis]); };
        return grid_.find({.z = number(2), .y = number(1), .x = number(0)}) == kNoBlock;
    }

    std::optional<double> find_in_block(const Stretch& part) {
        CubeWalk cells(line_, 1.0, part);
        do {
            if (!cursor_.move_to_cell(cells.cube()))
                was_inside_.reset();
            else if (const auto found = find_in_cell(cells.cube(), cells.part()))
                return found;
        } while (cells.advance());
        return std::nullopt;
    }

    std::optional<double> find_in_cell(const std::array<std::int64_t, 3>& cell, const Stretch& part) {
        if (const int sign = cursor_.sign(); sign != 0)
            return passes_to(sign) ? std::optional(part.begin) : std::nullopt;
        for (std::size_t axis = 0; axis < 3; ++axis) corner_[axis] = static_cast<double>(cell[axis]);
        const double length = part.end - part.begin;
        const int count = static_cast<int>(std::ceil(length * kSamplesPerSpacing));
        double before = part.begin;
        double value_before = value(before);
        if (passes_to(value_before)) return before;
        for (int i = 1; i <= count; ++i) {
            const double at = i == count ? part.end : part.begin + length * i / count;
            const double value_at = value(at);
            if (passes_to(value_at)) return root_between(before, value_before, at, value_at);
            before = at;
            value_before = value_at;
        }
        return std::nullopt;
    }

    // Whether the sign has changed since the last value; zero counts as outside.
    bool passes_to(double value) {
        const bool is_inside = value < 0.0;
        const bool passes = was_inside_.has_value() && *was_inside_ != is_inside;
        was_inside_ = is_inside;
        return passes;
    }

    double value(double t) {
        cursor_.move_within({line_.at(0, t) - corner_[0], line_.at(1, t) - corner_[1], line_.at(2, t) - corner_[2]});
        return cursor_.value();
    }

    // Regula falsi in the Illinois form, then bisection in case that was slow.
    double root_between(double a, double value_a, double b, double value_b) {
        constexpr int kFalsiSteps = 20;
        int kept = 0;  // which end stayed: < 0 for a, > 0 for b
        for (int i = 0; std::abs(b - a) > kCloseBracket; ++i) {
            const double secant = (a * value_b - b * value_a) / (value_b - value_a);
            const double t = i < kFalsiSteps ? secant : 0.5 * (a + b);
            if (!(t > a && t < b)) return t;  // rounding: there is no number between
            const double here = value(t);
            if ((here < 0.0) == (value_b < 0.0)) {
                b = t;
                value_b = here;
                if (kept < 0) value_a *= 0.5;
                kept = -1;
            } else {
                a = t;
                value_a = here;
                if (kept > 0) value_b *= 0.5;
                kept = 1;
            }
        }
        return 0.5 * (a + b);
    }

    const BlockGrid& grid_;
    SplineCursor cursor_;
    Line line_;
    std::array<double, 3> corner_{};  // of the current cell
    std::optional<bool> was_inside_;  // unknown at the start and after gaps in the band
};

}  // namespace

double first_crossing(const BlockGrid& grid, std::span<const float> coefficients, const GridBounds& bounds,
                      const Ray& ray) {
    const double h = grid.spacing();
    const auto in_spacings = [&](const Vec3& p) {
        const Vec3 q = (1.0 / h) * (p - grid.origin());
        return std::array<double, 3>{q.x, q.y, q.z};
    };
    const Line line{in_spacings(ray.origin), {ray.direction.x, ray.direction.y, ray.direction.z}};
    const Stretch stretch = clipped(line, {0.0, ray.length / h}, in_spacings(bounds.low), in_spacings(bounds.high));
    const auto found = stretch.empty() ? std::nullopt : Crossing(grid, coefficients, line).find(stretch);
    return found ? h * *found : std::numeric_limits<double>::infinity();
}

}  // namespace meniscus
