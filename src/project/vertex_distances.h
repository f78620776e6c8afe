// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How far the vertices of a mesh are from the exact surface.
#pragma once

#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

#include "meniscus/mesh_quality.h"
#include "remesh/mesh_changes.h"

namespace meniscus {

/// Absolute values, Å. Where nearly all vertices are on the surface, as in a mesh made directly, only the others take
/// memory.
class VertexDistances {
public:
    struct Off {
        VertexId vertex = 0;
        float distance = 0.0F;
    };

    explicit VertexDistances(std::vector<float> of_all) : count_(of_all.size()), all_(std::move(of_all)) {}
    /// The distances of so many vertices, which are on the surface but for some, in rising order.
    VertexDistances(std::size_t vertices, std::vector<Off> off) : count_(vertices), off_(std::move(off)) {}

    float operator[](VertexId vertex) const;
    void set(VertexId vertex, float distance);
    /// As renumber_entries; the distances of added vertices are still to be set.
    void renumber(const MeshChanges& changes);
    DistanceSummary summarise() const;

private:
    std::size_t count_;
    std::vector<float> all_;                   // or empty,
    std::vector<Off> off_;                     // and then of those off the surface, but for
    std::unordered_map<VertexId, float> set_;  // those that were set since, which may be on it
};

}  // namespace meniscus
