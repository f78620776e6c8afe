// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh/components.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <utility>

#include "core/disjoint_sets.h"

namespace meniscus {
namespace {

// Pieces numbered by their smallest vertex.
std::vector<std::uint32_t> pieces_by_first_vertex(const Mesh& mesh) {
    DisjointSets sets(mesh.vertices.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        sets.join(a, b);
        sets.join(a, c);
    }
    return sets.numbers();
}

// order[i] = old number of the piece that becomes number i.
std::vector<std::uint32_t> final_order(const std::vector<MeshComponent>& pieces) {
    std::vector<std::uint32_t> order(pieces.size());
    std::iota(order.begin(), order.end(), 0U);
    std::stable_sort(order.begin(), order.end(), [&](std::uint32_t a, std::uint32_t b) {
        return std::abs(pieces[a].volume) > std::abs(pieces[b].volume);
    });
    const auto outer =
        std::find_if(order.begin(), order.end(), [&](std::uint32_t p) { return pieces[p].volume > 0.0; });
    if (outer != order.end()) std::rotate(order.begin(), outer, outer + 1);
    return order;
}

}  // namespace

std::vector<MeshComponent> measure_components(const Mesh& mesh, std::span<const std::uint32_t> of_vertex) {
    std::vector<MeshComponent> pieces;
    std::vector<Vec3> origins;  // first vertex of each piece
    for (VertexId v = 0; v < mesh.vertices.size(); ++v) {
        const std::size_t p = of_vertex[v];
        if (p >= pieces.size()) {
            pieces.resize(p + 1);
            origins.resize(p + 1);
        }
        if (pieces[p].vertices++ == 0) origins[p] = mesh.vertices[v];
    }
    for (std::size_t t = 0; t < mesh.triangles.size();) {
        // One run of triangles of the same piece at a time, summed in registers.
        const std::uint32_t p = of_vertex[mesh.triangles[t][0]];
        const Vec3 origin = origins[p];
        MeshComponent run;
        for (; t < mesh.triangles.size() && of_vertex[mesh.triangles[t][0]] == p; ++t) {
            const auto& [i, j, k] = mesh.triangles[t];
            const Vec3 a = mesh.vertices[i] - origin;
            const Vec3 normal = cross(mesh.vertices[j] - mesh.vertices[i], mesh.vertices[k] - mesh.vertices[i]);
            ++run.triangles;
            run.area += 0.5 * norm(normal);
            run.volume += dot(a, normal);
        }
        pieces[p].triangles += run.triangles;
        pieces[p].area += run.area;
        pieces[p].volume += run.volume / 6.0;
    }
    return pieces;
}

Components find_components(const Mesh& mesh) {
    Components found{.of_vertex = pieces_by_first_vertex(mesh), .pieces = {}};
    const std::vector<MeshComponent> pieces = measure_components(mesh, found.of_vertex);
    const std::vector<std::uint32_t> order = final_order(pieces);
    std::vector<std::uint32_t> number(pieces.size());
    found.pieces.reserve(pieces.size());
    for (std::uint32_t i = 0; i < order.size(); ++i) {
        number[order[i]] = i;
        found.pieces.push_back(pieces[order[i]]);
    }
    for (std::uint32_t& p : found.of_vertex) p = number[p];
    return found;
}

std::vector<MeshComponent> label_components(Mesh& mesh) {
    Components found = find_components(mesh);
    mesh.components = std::move(found.of_vertex);
    return std::move(found.pieces);
}

void keep_components(Mesh& mesh, const std::vector<bool>& keep) {
    const auto kept = [&](VertexId v) { return keep[mesh.components[v]]; };
    std::vector<VertexId> number(mesh.vertices.size());
    VertexId next = 0;
    for (VertexId v = 0; v < mesh.vertices.size(); ++v) {
        if (!kept(v)) continue;
        mesh.vertices[next] = mesh.vertices[v];
        number[v] = next++;
    }
    const auto gone =
        std::remove_if(mesh.triangles.begin(), mesh.triangles.end(), [&](const Triangle& t) { return !kept(t[0]); });
    mesh.triangles.erase(gone, mesh.triangles.end());
    for (Triangle& t : mesh.triangles) t = {number[t[0]], number[t[1]], number[t[2]]};
    mesh.vertices.resize(next);
    label_components(mesh);
}

}  // namespace meniscus
