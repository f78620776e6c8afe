// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A static tree of bounding boxes over items that are already in spatial order.
//
// No sorting and no pointers: level 0 holds the items' boxes, each box of the next level encloses eight
// consecutive ones. Serves items spread over any extent, from one atom to a capsid with an outlier far away.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "meniscus/vec3.h"

namespace meniscus {

/// An axis-aligned box; the default one is empty.
struct Box {
    Vec3 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity(),
             std::numeric_limits<double>::infinity()};
    Vec3 high{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(),
              -std::numeric_limits<double>::infinity()};

    void include(const Vec3& p) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    void include(const Box& b) {
        low = {std::min(low.x, b.low.x), std::min(low.y, b.low.y), std::min(low.z, b.low.z)};
        high = {std::max(high.x, b.high.x), std::max(high.y, b.high.y), std::max(high.z, b.high.z)};
    }
    Box grown(double by) const { return {low - Vec3{by, by, by}, high + Vec3{by, by, by}}; }
    bool overlaps(const Box& b) const {
        // All of them always: six guesses of a branch are dearer.
        const bool in_x = (low.x <= b.high.x) & (b.low.x <= high.x);
        const bool in_y = (low.y <= b.high.y) & (b.low.y <= high.y);
        const bool in_z = (low.z <= b.high.z) & (b.low.z <= high.z);
        return in_x & in_y & in_z;
    }
    bool contains(const Box& b) const {
        return low.x <= b.low.x && low.y <= b.low.y && low.z <= b.low.z && b.high.x <= high.x && b.high.y <= high.y &&
               b.high.z <= high.z;
    }
    /// Squared distance of a point from the box; 0 inside.
    double squared_distance(const Vec3& p) const {
        const double dx = std::max(std::max(low.x - p.x, p.x - high.x), 0.0);
        const double dy = std::max(std::max(low.y - p.y, p.y - high.y), 0.0);
        const double dz = std::max(std::max(low.z - p.z, p.z - high.z), 0.0);
        return dx * dx + dy * dy + dz * dz;
    }
};

class BoxTree {
public:
    BoxTree() = default;
    explicit BoxTree(std::vector<Box> boxes) {
        levels_.push_back(std::move(boxes));
        while (levels_.back().size() > kFanOut) {
            const std::vector<Box>& below = levels_.back();
            std::vector<Box> above((below.size() + kFanOut - 1) / kFanOut);
            for (std::size_t i = 0; i < below.size(); ++i) above[i / kFanOut].include(below[i]);
            levels_.push_back(std::move(above));
        }
    }

    /// Calls visit(item) for every item whose box overlaps `box`, in the items' order.
    template <class Visit>
    void for_each_overlapping(const Box& box, const Visit& visit) const {
        if (!levels_.empty()) descend_overlapping(levels_.size() - 1, 0, levels_.back().size(), box, visit);
    }

    /// Branch and bound: calls visit(item) near to far for items whose squared box distance from `point` is
    /// below bound(), which may shrink from call to call.
    template <class Bound, class Visit>
    void search_nearest(const Vec3& point, const Bound& bound, const Visit& visit) const {
        if (!levels_.empty()) descend_nearest(levels_.size() - 1, 0, levels_.back().size(), point, bound, visit);
    }

private:
    static constexpr std::size_t kFanOut = 8;

    template <class Visit>
    void descend_overlapping(std::size_t level, std::size_t begin, std::size_t end, const Box& box,
                             const Visit& visit) const {
        for (std::size_t i = begin; i < end; ++i) {
            if (!levels_[level][i].overlaps(box)) continue;
            if (level == 0)
                visit(static_cast<std::uint32_t>(i));
            else
                descend_overlapping(level - 1, i * kFanOut, std::min((i + 1) * kFanOut, levels_[level - 1].size()), box,
                                    visit);
        }
    }

    template <class Bound, class Visit>
    void descend_nearest(std::size_t level, std::size_t begin, std::size_t end, const Vec3& point, const Bound& bound,
                         const Visit& visit) const {
        struct Child {
            double distance2;
            std::size_t index;
        };
        std::array<Child, kFanOut> children;
        std::size_t count = 0;
        for (std::size_t i = begin; i < end; ++i) {
            Child child{levels_[level][i].squared_distance(point), i};
            std::size_t at = count++;
            for (; at > 0 && children[at - 1].distance2 > child.distance2; --at) children[at] = children[at - 1];
            children[at] = child;
        }
        for (std::size_t c = 0; c < count && children[c].distance2 < bound(); ++c) {
            const std::size_t i = children[c].index;
            if (level == 0)
                visit(static_cast<std::uint32_t>(i));
            else
                descend_nearest(level - 1, i * kFanOut, std::min((i + 1) * kFanOut, levels_[level - 1].size()), point,
                                bound, visit);
        }
    }

    std::vector<std::vector<Box>> levels_;
};

}  // namespace meniscus
