// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The triangles near a few others, by their boxes, for those of them that each of these may pass through.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/bits.h"
#include "nearest/local_features.h"
#include "nearest/nearest_kernels.h"
#include "space/box_tree.h"

namespace meniscus {

/// Filled again and again without setting its memory.
class NearTriangles {
public:
    void clear() { boxes_.clear(); }
    void add(const Box& box, std::uint32_t number) { boxes_.add(row_of(box), number); }

    /// Calls visit(number) for those whose boxes overlap one, in the order in which they were added.
    template <class Visit>
    void for_each_overlapping(const Box& box, const Visit& visit) {
        marks_.resize(std::max(marks_.size(), words_for(boxes_.size())));
        nearest_kernels().mark_overlapping(boxes_, box, marks_.data());
        for_each_item(marks_.data(), boxes_.size(), [&](std::size_t i) { visit(boxes_.index(i)); });
    }

private:
    BoxList boxes_;
    std::vector<std::uint64_t> marks_;
};

}  // namespace meniscus
