// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What every mesh of ours must be, checked plainly and without the library's own measures.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus::testing {

/// What is wrong with the mesh as a closed oriented 2-manifold with every vertex in use; empty if nothing is.
inline std::string why_not_closed_manifold(const Mesh& mesh) {
    std::map<std::pair<VertexId, VertexId>, int> directed;
    std::vector<std::map<VertexId, VertexId>> next(mesh.vertices.size());  // round each vertex
    for (const Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i) {
            const VertexId a = t[i];
            const VertexId b = t[(i + 1) % 3];
            if (a >= mesh.vertices.size()) return "a triangle names a vertex that does not exist";
            if (a == b) return "a triangle with a repeated vertex";
            ++directed[{a, b}];
            next[a][b] = t[(i + 2) % 3];
        }
    for (const auto& [edge, count] : directed) {
        if (count != 1) return "an edge with " + std::to_string(count) + " triangles in one direction";
        if (!directed.contains({edge.second, edge.first})) return "an edge with a triangle on one side only";
    }
    for (std::size_t v = 0; v < next.size(); ++v) {
        if (next[v].empty()) return "a vertex without triangles";
        std::size_t steps = 0;
        const VertexId start = next[v].begin()->first;
        VertexId at = start;
        do {
            at = next[v].at(at);
            ++steps;
        } while (at != start);
        if (steps != next[v].size()) return "a vertex with more than one fan";
    }
    return "";
}

inline void expect_closed_manifold(const Mesh& mesh) {
    EXPECT_FALSE(mesh.triangles.empty());
    EXPECT_EQ(why_not_closed_manifold(mesh), "");
}

inline double area_of(const Mesh& mesh, const Triangle& t) {
    return 0.5 * norm(cross(mesh.vertices[t[1]] - mesh.vertices[t[0]], mesh.vertices[t[2]] - mesh.vertices[t[0]]));
}

inline double area_of(const Mesh& mesh) {
    double area = 0.0;
    for (const Triangle& t : mesh.triangles) area += area_of(mesh, t);
    return area;
}

/// Signed volume: positive if triangles are counter-clockwise seen from outside.
inline double volume_of(const Mesh& mesh) {
    double volume = 0.0;
    for (const Triangle& t : mesh.triangles)
        volume += dot(mesh.vertices[t[0]], cross(mesh.vertices[t[1]], mesh.vertices[t[2]])) / 6.0;
    return volume;
}

inline double smallest_area_of(const Mesh& mesh) {
    double smallest = std::numeric_limits<double>::infinity();
    for (const Triangle& t : mesh.triangles) smallest = std::min(smallest, area_of(mesh, t));
    return smallest;
}

/// Vertices - edges + triangles, where an edge is a pair of different vertices.
inline std::int64_t euler_characteristic_of(const Mesh& mesh) {
    std::set<std::pair<VertexId, VertexId>> edges;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t i = 0; i < 3; ++i)
            if (t[i] != t[(i + 1) % 3]) edges.insert(std::minmax(t[i], t[(i + 1) % 3]));
    return static_cast<std::int64_t>(mesh.vertices.size()) - static_cast<std::int64_t>(edges.size()) +
           static_cast<std::int64_t>(mesh.triangles.size());
}

}  // namespace meniscus::testing
