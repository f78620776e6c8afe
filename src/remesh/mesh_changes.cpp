// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/mesh_changes.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <span>

#include "core/parallel.h"
#include "measure/triangle_lanes.h"
#include "mesh/corner_numbers.h"

namespace meniscus {
namespace {

constexpr std::size_t kTrianglesPerChunk = 1024;

// Renumbers components from 0 without gaps, in the same order.
void close_gaps(std::vector<std::uint32_t>& numbers) {
    std::vector<std::uint32_t> taken;
    for (const std::uint32_t n : numbers) {
        if (n >= taken.size()) taken.resize(std::size_t{n} + 1);
        taken[n] = 1;
    }
    if (std::count(taken.begin(), taken.end(), 0U) == 0) return;
    std::exclusive_scan(taken.begin(), taken.end(), taken.begin(), 0U);
    for (std::uint32_t& n : numbers) n = taken[n];
}

// Sets where vertices go, and moves them there.
void close_vertex_holes(Mesh& mesh, PendingChanges& pending, MeshChanges& changes) {
    std::vector<VertexId>& holes = pending.holes;
    std::sort(holes.begin(), holes.end());
    auto last = static_cast<VertexId>(mesh.vertices.size());
    std::vector<VertexId> number(holes.size());  // new ones, of the vertices from `left` on
    for (const VertexId hole : holes) {
        if (hole >= changes.left) break;
        do --last;
        while (std::binary_search(holes.begin(), holes.end(), last));
        changes.refilled.emplace_back(hole, last);
        number[last - changes.left] = hole;
    }
    std::erase_if(pending.moved, [&](VertexId v) { return std::binary_search(holes.begin(), holes.end(), v); });
    for (VertexId& v : pending.moved)
        if (v >= changes.left) v = number[v - changes.left];
    const auto left = static_cast<VertexId>(changes.left);
    parallel_chunks(mesh.triangles.size(), kTrianglesPerChunk, [&](std::size_t begin, std::size_t end) {
        const auto triangles = std::span(mesh.triangles).subspan(begin, end - begin);
        if (triangle_kernels().find_largest_index(all_corners(triangles)) < left) return;
        for (Triangle& triangle : triangles)
            for (VertexId& v : triangle)
                if (v >= left) v = number[v - left];
    });
    renumber_entries(changes, mesh.vertices);
    renumber_entries(changes, mesh.normals);
    renumber_entries(changes, mesh.components);
}

}  // namespace

MeshChanges close_holes(Mesh& mesh, PendingChanges pending) {
    auto& [moved, holes, removed, triangles, dropped_components] = pending;
    MeshChanges changes;
    changes.with_new = mesh.vertices.size();
    changes.left = changes.with_new - holes.size();
    std::sort(removed.begin(), removed.end(), std::greater<>());
    for (const std::uint32_t t : removed) {
        mesh.triangles[t] = mesh.triangles.back();
        mesh.triangles.pop_back();
    }
    triangles.insert(triangles.end(), removed.begin(), removed.end());
    std::erase_if(triangles, [&mesh](std::uint32_t t) { return t >= mesh.triangles.size(); });
    std::sort(triangles.begin(), triangles.end());
    triangles.erase(std::unique(triangles.begin(), triangles.end()), triangles.end());
    changes.triangles = std::move(triangles);
    changes.dropped_components = dropped_components;
    if (!holes.empty()) close_vertex_holes(mesh, pending, changes);
    if (dropped_components) close_gaps(mesh.components);
    std::sort(moved.begin(), moved.end());
    moved.erase(std::unique(moved.begin(), moved.end()), moved.end());
    changes.moved = std::move(moved);
    return changes;
}

}  // namespace meniscus
