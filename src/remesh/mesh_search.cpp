// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/mesh_search.h"

#include <algorithm>

#include "core/parallel_list.h"
#include "remesh/near_triangles.h"
#include "remesh/self_intersections.h"

namespace meniscus {
namespace {

constexpr std::size_t kLeaningPerTask = 256;
constexpr double kNeighbours = 4.0;  // usual lengths of edges: triangles within such a cube share a search

// How many triangles from the first one on lie so near to each other that they share what is near them.
std::size_t neighbours_among(const Mesh& mesh, std::span<const std::uint32_t> triangles, double edge) {
    Box all;
    std::size_t count = 0;
    for (; count < triangles.size(); ++count) {
        all.include(box_of(mesh, mesh.triangles[triangles[count]]));
        const Vec3 size = all.high - all.low;
        if (std::max({size.x, size.y, size.z}) > kNeighbours * edge) break;
    }
    return std::max<std::size_t>(count, 1);
}

// Appends the triangles that pass through each other, one of two at least among some neighbours. `near` is memory.
void find_tangled(std::span<const std::uint32_t> triangles, const MeshSearch& search, NearTriangles& near,
                  std::vector<std::uint32_t>& numbers) {
    const Mesh& mesh = search.mesh();
    Box all;
    for (const std::uint32_t t : triangles) all.include(box_of(mesh, mesh.triangles[t]));
    near.clear();
    search.for_each_near(all, [&](std::uint32_t t, const Box& box) { near.add(box, t); });
    for (const std::uint32_t t : triangles) {
        const HeldTriangle held(mesh, mesh.triangles[t]);
        near.for_each_overlapping(box_of(mesh, mesh.triangles[t]), [&](std::uint32_t other) {
            if (other != t && held.meeting(mesh, mesh.triangles[other])) numbers.insert(numbers.end(), {t, other});
        });
    }
}

}  // namespace

// Bit by bit, the stretches of a chunk that overlap a box. This function and the next one have no branch, because the
// processor would often guess it wrong.
std::uint64_t MeshSearch::stretches_near(const Box& box, std::size_t chunk) const {
    constexpr std::size_t kStretches = TriangleBoxes::kChunk / TriangleBoxes::kStretch;
    const SmallBox small(box);
    std::uint64_t near = 0;
    for (std::size_t s = 0; s < kStretches; ++s)
        near |= std::uint64_t{small.overlaps(boxes_.stretches[chunk * kStretches + s])} << s;
    return near;
}

// The triangles of a stretch that have their first corner in a box.
std::uint64_t MeshSearch::triangles_near(const Box& box, std::size_t begin) const {
    const std::size_t end = std::min(begin + TriangleBoxes::kStretch, mesh_.triangles.size());
    std::uint64_t near = 0;
    for (std::size_t t = begin; t < end; ++t) {
        const Vec3& corner = mesh_.vertices[mesh_.triangles[t][0]];
        near |= std::uint64_t{box.overlaps({corner, corner})} << (t - begin);
    }
    return near;
}

std::vector<std::uint32_t> tangled_triangles(const Mesh& mesh, const TriangleBoxes& boxes,
                                             std::span<const std::uint32_t> leaning, double edge) {
    if (leaning.empty()) return {};
    const MeshSearch search(mesh, boxes);
    auto all = parallel_list<std::uint32_t>(
        leaning.size(), kLeaningPerTask, [&](std::size_t begin, std::size_t end, auto& numbers) {
            NearTriangles near;
            while (begin < end) {
                const std::size_t count = neighbours_among(mesh, leaning.subspan(begin, end - begin), edge);
                find_tangled(leaning.subspan(begin, count), search, near, numbers);
                begin += count;
            }
        });
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}  // namespace meniscus
