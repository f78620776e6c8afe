// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "project/vertex_distances.h"

#include <algorithm>
#include <iterator>
#include <span>
#include <utility>

#include "core/parallel.h"
#include "core/parallel_list.h"

namespace meniscus {
namespace {

constexpr std::size_t kSummed = 1 << 14;  // distances per task

// The element that would stand at a place near the end if the values were sorted. A sample tells below which value it
// cannot be, and most values are below that, or are that value: of vertices that lie on the exact surface all are 0.
float value_near_the_end(std::span<const float> values, std::size_t place) {
    constexpr std::size_t kStride = 64;
    const std::size_t beyond = values.size() - place;  // it is so manieth from the end
    const auto nth_from_the_end = [](std::vector<float>& list, std::size_t count) {
        const auto at = list.end() - static_cast<std::ptrdiff_t>(std::min(count, list.size()));
        std::nth_element(list.begin(), at, list.end());
        return *at;
    };
    std::vector<float> some;
    for (std::size_t i = 0; i < values.size(); i += kStride) some.push_back(values[i]);
    const float least = nth_from_the_end(some, 2 * beyond / kStride + kStride);
    auto high = parallel_list<float>(values.size(), kSummed, [&](std::size_t begin, std::size_t end, auto& list) {
        const auto part = values.subspan(begin, end - begin);
        std::copy_if(part.begin(), part.end(), std::back_inserter(list), [&](float v) { return v > least; });
    });
    if (high.size() < beyond) {
        const auto equal = static_cast<std::size_t>(std::count(values.begin(), values.end(), least));
        if (high.size() + equal >= beyond) return least;
        high.assign(values.begin(), values.end());
    }
    return nth_from_the_end(high, beyond);
}

DistanceSummary summary_of(std::span<const float> distances) {
    struct Sums {
        double sum = 0.0;
        double max = 0.0;
        Sums& operator+=(const Sums& b) {
            sum += b.sum;
            max = std::max(max, b.max);
            return *this;
        }
    };
    const auto [sum, max] = parallel_sum<Sums>(distances.size(), kSummed, [&](std::size_t begin, std::size_t end) {
        Sums sums;
        for (const double d : distances.subspan(begin, end - begin)) sums += {d, d};
        return sums;
    });
    DistanceSummary summary;
    summary.mean = sum / static_cast<double>(distances.size());
    summary.p99 =
        value_near_the_end(distances, static_cast<std::size_t>(0.99 * static_cast<double>(distances.size() - 1)));
    summary.max = max;
    return summary;
}

// The same where all but some are 0.
DistanceSummary summary_of(std::vector<float> some, std::size_t count) {
    DistanceSummary summary;
    for (const double d : some) {
        summary.mean += d;
        summary.max = std::max(summary.max, d);
    }
    summary.mean /= static_cast<double>(count);
    const auto place = static_cast<std::size_t>(0.99 * static_cast<double>(count - 1));
    const std::size_t zeros = count - some.size();
    if (place >= zeros) {
        const auto at = some.begin() + static_cast<std::ptrdiff_t>(place - zeros);
        std::nth_element(some.begin(), at, some.end());
        summary.p99 = *at;
    }
    return summary;
}

bool is_before(const VertexDistances::Off& off, std::size_t vertex) { return off.vertex < vertex; }

}  // namespace

float VertexDistances::operator[](VertexId vertex) const {
    if (!all_.empty()) return all_[vertex];
    if (const auto found = set_.find(vertex); found != set_.end()) return found->second;
    const auto place = std::lower_bound(off_.begin(), off_.end(), vertex, is_before);
    return place == off_.end() || place->vertex != vertex ? 0.0F : place->distance;
}

void VertexDistances::set(VertexId vertex, float distance) {
    if (!all_.empty())
        all_[vertex] = distance;
    else
        set_[vertex] = distance;
}

void VertexDistances::renumber(const MeshChanges& changes) {
    count_ = changes.left;
    renumber_entries(changes, all_);
    if (!all_.empty()) return;
    for (const auto& [hole, from] : changes.refilled) set(hole, (*this)[from]);
    off_.erase(std::lower_bound(off_.begin(), off_.end(), count_, is_before), off_.end());
    std::erase_if(set_, [this](const auto& entry) { return entry.first >= count_; });
}

DistanceSummary VertexDistances::summarise() const {
    if (count_ == 0) return {};
    if (!all_.empty()) return summary_of(all_);
    std::vector<float> some;
    some.reserve(off_.size() + set_.size());
    for (const auto& [vertex, distance] : off_)
        if (!set_.contains(vertex)) some.push_back(distance);
    for (const auto& [vertex, distance] : set_)
        if (distance != 0.0F) some.push_back(distance);
    return summary_of(std::move(some), count_);
}

}  // namespace meniscus
