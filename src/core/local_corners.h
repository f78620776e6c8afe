// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A few triangles of a mesh with numbers of their own for its vertices.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// Numbers the corners of some triangles, each once, in the order of the mesh.
class LocalCorners {
public:
    /// corners  of the triangles, as often as they have them
    /// cost     O(n log n)
    explicit LocalCorners(std::vector<VertexId> corners) : vertices_(std::move(corners)) {
        std::sort(vertices_.begin(), vertices_.end());
        vertices_.erase(std::unique(vertices_.begin(), vertices_.end()), vertices_.end());
    }

    /// The mesh's number of each.
    const std::vector<VertexId>& vertices() const { return vertices_; }

    /// One of the triangles, given with the mesh's numbers.
    Triangle local(const Triangle& triangle) const {
        const auto number = [this](VertexId v) {
            return static_cast<VertexId>(std::lower_bound(vertices_.begin(), vertices_.end(), v) - vertices_.begin());
        };
        return {number(triangle[0]), number(triangle[1]), number(triangle[2])};
    }

private:
    std::vector<VertexId> vertices_;
};

}  // namespace meniscus
