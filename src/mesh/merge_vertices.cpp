// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/merge_vertices.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <tuple>
#include <vector>

namespace meniscus {
namespace {

// For every vertex the first one at its place.
std::vector<VertexId> first_at_same_place(const std::vector<Vec3>& vertices) {
    const auto place = [&](VertexId v) { return std::tie(vertices[v].x, vertices[v].y, vertices[v].z); };
    std::vector<VertexId> order(vertices.size());
    std::iota(order.begin(), order.end(), VertexId{0});
    std::sort(order.begin(), order.end(),
              [&](VertexId a, VertexId b) { return place(a) < place(b) || (!(place(b) < place(a)) && a < b); });
    std::vector<VertexId> first(vertices.size());
    for (std::size_t i = 0; i < order.size(); ++i)
        first[order[i]] = i > 0 && vertices[order[i]] == vertices[order[i - 1]] ? first[order[i - 1]] : order[i];
    return first;
}

}  // namespace

std::size_t merge_vertices(Mesh& mesh) {
    constexpr VertexId kUnused = std::numeric_limits<VertexId>::max();
    const std::vector<VertexId> first = first_at_same_place(mesh.vertices);
    std::vector<VertexId> new_number(mesh.vertices.size(), kUnused);
    for (Triangle& triangle : mesh.triangles)
        for (VertexId& corner : triangle) new_number[corner = first[corner]] = 0;
    std::vector<Vec3> kept;
    for (VertexId v = 0; v < new_number.size(); ++v) {
        if (new_number[v] == kUnused) continue;
        new_number[v] = static_cast<VertexId>(kept.size());
        kept.push_back(mesh.vertices[v]);
    }
    for (Triangle& triangle : mesh.triangles)
        for (VertexId& corner : triangle) corner = new_number[corner];
    const std::size_t gone = mesh.vertices.size() - kept.size();
    mesh.vertices = std::move(kept);
    return gone;
}

}  // namespace meniscus
