// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The triangles that touch each stretch of a mesh's vertices, so that what is gathered round vertices stays in a
// core's cache.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// Stretches of consecutive vertices, and the runs of triangles that have a corner there. The triangles of a mesh of
/// blocks touch few stretches each; any other mesh takes more time, but gives the same.
class VertexStretches {
public:
    /// triangles   must outlive this; every corner below vertex_count
    /// cost        O(n); an eighth of a byte per triangle and stretch that its run touches
    VertexStretches(std::size_t vertex_count, std::span<const Triangle> triangles);

    std::size_t size() const { return (vertex_count_ + kLength - 1) / kLength; }
    VertexId first(std::size_t stretch) const { return static_cast<VertexId>(stretch * kLength); }
    std::size_t count(std::size_t stretch) const { return std::min(kLength, vertex_count_ - stretch * kLength); }

    /// Calls visit(triangle, its number) for all triangles that have a corner in a stretch, and for some others, in
    /// rising order.
    template <class Visit>
    void visit_triangles(std::size_t stretch, const Visit& visit) const {
        for (std::size_t i = begins_[stretch]; i < begins_[stretch + 1]; ++i) {
            const std::size_t begin = runs_[i] * kRun;
            const std::size_t end = std::min(begin + kRun, triangles_.size());
            for (std::size_t t = begin; t < end; ++t) visit(triangles_[t], t);
        }
    }

private:
    static constexpr std::size_t kLength = 4096;  // vertices
    static constexpr std::size_t kRun = 64;       // triangles

    struct Touch {
        std::uint32_t stretch = 0;
        std::size_t run = 0;
    };
    void find_touches(std::size_t first_run, std::size_t last_run, std::vector<Touch>& touches) const;

    std::size_t vertex_count_;
    std::span<const Triangle> triangles_;
    std::vector<std::size_t> begins_;  // of each stretch's runs
    std::vector<std::size_t> runs_;
};

}  // namespace meniscus
