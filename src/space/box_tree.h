// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A static tree of bounding boxes over items that are already in spatial order.
//
// No sorting and no pointers: level 0 holds the items' boxes, each box of the next level encloses eight
// consecutive ones. Serves items spread over any extent, from one atom to a capsid with an outlier far away.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#include "meniscus/vec3.h"
#include "simd/pairs.h"

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
    Vec3 middle() const { return 0.5 * (low + high); }
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
        const double dx = p.x - std::max(std::min(p.x, high.x), low.x);
        const double dy = p.y - std::max(std::min(p.y, high.y), low.y);
        const double dz = p.z - std::max(std::min(p.z, high.z), low.z);
        return dx * dx + dy * dy + dz * dz;
    }
};

/// The box round some points.
inline Box box_of(std::span<const Vec3> points) {
    Box box;
    for (const Vec3& p : points) box.include(p);
    return box;
}

/// A box in single precision, no smaller than the one it stands for; the default one is empty.
struct SmallBox {
    static constexpr float kLargest = std::numeric_limits<float>::max();
    using Floats = float __attribute__((vector_size(16)));
    using Bits = std::int32_t __attribute__((vector_size(16)));
    std::array<float, 3> low{kLargest, kLargest, kLargest};
    std::array<float, 3> high{-kLargest, -kLargest, -kLargest};

    SmallBox() = default;
    explicit SmallBox(const Box& box) : low(moved_out(box.low, -1.0F)), high(moved_out(box.high, 1.0F)) {}

    void include(const SmallBox& b) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], b.low[axis]);
            high[axis] = std::max(high[axis], b.high[axis]);
        }
    }
    bool overlaps(const SmallBox& b) const {
        unsigned apart = 0;  // all axes always, as for Box
        for (std::size_t axis = 0; axis < 3; ++axis)
            apart |= static_cast<unsigned>(low[axis] > b.high[axis]) | static_cast<unsigned>(b.low[axis] > high[axis]);
        return apart == 0;
    }
    Box box() const { return {{low[0], low[1], low[2]}, {high[0], high[1], high[2]}}; }

private:
    // Coordinates a little farther in a direction than rounding has left them. In a vector, as compilers make branches
    // of single numbers.
    static std::array<float, 3> moved_out(const Vec3& corner, float direction) {
        constexpr Floats kMost = Floats{} + kLargest;
        Floats x{static_cast<float>(corner.x), static_cast<float>(corner.y), static_cast<float>(corner.z), 0.0F};
        x = x > kMost ? kMost : x;
        x = x < -kMost ? -kMost : x;
        const auto size = reinterpret_cast<Floats>(reinterpret_cast<Bits>(x) & 0x7FFFFFFF);
        x += direction * (0x1p-22F * size + std::numeric_limits<float>::min());
        return {x[0], x[1], x[2]};
    }
};

/// Eight small boxes side by side in vectors.
class EightBoxes {
public:
    static constexpr std::size_t kCount = 8;

    void set(std::size_t i, const SmallBox& box) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            low_[axis][i / 4][i % 4] = box.low[axis];
            high_[axis][i / 4][i % 4] = box.high[axis];
        }
    }

    /// Round all that were set.
    SmallBox hull() const {
        SmallBox hull;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const Floats& a = low_[axis][0];
            const Floats& b = low_[axis][1];
            const Floats low = b < a ? b : a;  // the first one where the second is unset
            const Floats& c = high_[axis][0];
            const Floats& d = high_[axis][1];
            const Floats high = d > c ? d : c;
            for (std::size_t i = 0; i < 4; ++i) {
                hull.low[axis] = std::min(hull.low[axis], low[i]);
                hull.high[axis] = std::max(hull.high[axis], high[i]);
            }
        }
        return hull;
    }

    /// As it was set.
    SmallBox box(std::size_t i) const {
        SmallBox box;
        for (std::size_t axis = 0; axis < 3; ++axis) {
            box.low[axis] = low_[axis][i / 4][i % 4];
            box.high[axis] = high_[axis][i / 4][i % 4];
        }
        return box;
    }

    /// Bit i is set if box i overlaps; those that were never set do not.
    unsigned overlapping(const SmallBox& query) const {
        const Bits bits = (overlaps(0, query) & Bits{1, 2, 4, 8}) | (overlaps(1, query) & Bits{16, 32, 64, 128});
        return static_cast<unsigned>((bits[0] | bits[1]) | (bits[2] | bits[3]));
    }

    /// Of a point from each box; 0 inside, and for those that were never set.
    std::array<double, kCount> squared_distances(const Vec3& point) const {
        const std::array<double, 3> p{point.x, point.y, point.z};
        std::array<double, kCount> squares;
        for (std::size_t i = 0; i < kCount; i += 2) {
            Pair sum{};
            for (std::size_t axis = 0; axis < 3; ++axis) {
                const Pair before = pair(low_[axis], i) - p[axis];
                const Pair behind = p[axis] - pair(high_[axis], i);
                const Pair apart = before > behind ? before : behind;  // at most one is positive
                const Pair outside = apart > 0.0 ? apart : Pair{};
                sum += outside * outside;
            }
            std::memcpy(&squares[i], &sum, sizeof sum);
        }
        return squares;
    }

private:
    using Floats = SmallBox::Floats;
    using Bits = SmallBox::Bits;
    using Columns = std::array<std::array<Floats, 2>, 3>;

    Bits overlaps(std::size_t half, const SmallBox& query) const {
        Bits bits = ~Bits{};
        for (std::size_t axis = 0; axis < 3; ++axis)
            bits &= (low_[axis][half] <= query.high[axis]) & (high_[axis][half] >= query.low[axis]);
        return bits;
    }

    // Two of a column, from box i on.
    static Pair pair(const std::array<Floats, 2>& column, std::size_t i) {
        float __attribute__((vector_size(8))) two;
        std::memcpy(&two, reinterpret_cast<const char*>(column.data()) + i * sizeof(float), sizeof two);
        return __builtin_convertvector(two, Pair);
    }

    static constexpr float kNan = std::numeric_limits<float>::quiet_NaN();  // no comparison holds
    static constexpr Floats kNone{kNan, kNan, kNan, kNan};
    static constexpr Columns kUnset{{{kNone, kNone}, {kNone, kNone}, {kNone, kNone}}};
    Columns low_ = kUnset;
    Columns high_ = kUnset;
};

/// Items by their boxes, which are kept in single precision, relative to one of them, and no smaller than they are:
/// what is found may be apart by a millionth of the extent.
class BoxTree {
public:
    BoxTree() = default;
    explicit BoxTree(std::span<const Box> boxes) {
        if (boxes.empty()) return;
        if (is_finite(boxes[boxes.size() / 2].low)) origin_ = boxes[boxes.size() / 2].low;
        sizes_.push_back(boxes.size());
        std::vector<EightBoxes>& items = eights_.emplace_back((boxes.size() + kFanOut - 1) / kFanOut);
        for (std::size_t i = 0; i < boxes.size(); ++i) items[i / kFanOut].set(i % kFanOut, from_origin(boxes[i]));
        while (eights_.back().size() > 1) {
            const std::size_t size = eights_.back().size();
            sizes_.push_back(size);
            std::vector<EightBoxes> above((size + kFanOut - 1) / kFanOut);
            for (std::size_t i = 0; i < size; ++i) above[i / kFanOut].set(i % kFanOut, eights_.back()[i].hull());
            eights_.push_back(std::move(above));
        }
    }

    /// Of an item.
    Box box(std::size_t item) const {
        const Box from_origin = eights_[0][item / kFanOut].box(item % kFanOut).box();
        return {origin_ + from_origin.low, origin_ + from_origin.high};
    }

    /// Calls visit(item) for every item whose box overlaps `box`, in the items' order.
    template <class Visit>
    void for_each_overlapping(const Box& box, const Visit& visit) const {
        if (!eights_.empty()) descend_overlapping({eights_.size() - 1, 0}, from_origin(box), visit);
    }

    /// Branch and bound: calls visit(item) near to far for items whose squared box distance from `point` is
    /// below bound(), which may shrink from call to call.
    template <class Bound, class Visit>
    void search_nearest(const Vec3& point, const Bound& bound, const Visit& visit) const {
        if (!eights_.empty()) descend_nearest({eights_.size() - 1, 0}, point - origin_, bound, visit);
    }

private:
    static constexpr std::size_t kFanOut = EightBoxes::kCount;

    struct Node {
        std::size_t level;
        std::size_t eight;  // of the level
    };

    SmallBox from_origin(const Box& box) const { return SmallBox({box.low - origin_, box.high - origin_}); }

    template <class Visit>
    void descend_overlapping(const Node& node, const SmallBox& query, const Visit& visit) const {
        const auto [level, eight] = node;
        for (unsigned bits = eights_[level][eight].overlapping(query); bits != 0; bits &= bits - 1) {
            const std::size_t i = eight * kFanOut + static_cast<std::size_t>(std::countr_zero(bits));
            if (level > 0)
                descend_overlapping({level - 1, i}, query, visit);
            else
                visit(static_cast<std::uint32_t>(i));
        }
    }

    template <class Bound, class Visit>
    void descend_nearest(const Node& node, const Vec3& point, const Bound& bound, const Visit& visit) const {
        const auto [level, eight] = node;
        struct Child {
            double distance2;
            std::size_t index;
        };
        std::array<Child, kFanOut> children;
        std::size_t count = 0;
        const std::size_t begin = eight * kFanOut;
        const std::array<double, kFanOut> distances = eights_[level][eight].squared_distances(point);
        const double most = bound();
        for (std::size_t i = begin; i < std::min(begin + kFanOut, sizes_[level]); ++i) {
            const Child child{distances[i - begin], i};
            if (!(child.distance2 < most)) continue;
            std::size_t at = count++;
            for (; at > 0 && children[at - 1].distance2 > child.distance2; --at) children[at] = children[at - 1];
            children[at] = child;
        }
        for (std::size_t c = 0; c < count && children[c].distance2 < bound(); ++c) {
            const std::size_t i = children[c].index;
            if (level == 0)
                visit(static_cast<std::uint32_t>(i));
            else
                descend_nearest({level - 1, i}, point, bound, visit);
        }
    }

    Vec3 origin_;
    std::vector<std::size_t> sizes_;  // of the levels, items first
    std::vector<std::vector<EightBoxes>> eights_;
};

}  // namespace meniscus
