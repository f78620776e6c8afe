// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/mesh_search.h"

#include <algorithm>

#include "core/parallel_list.h"
#include "remesh/self_intersections.h"

namespace meniscus {

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
                                             std::span<const std::uint32_t> leaning) {
    constexpr std::size_t kPerTask = 256;
    if (leaning.empty()) return {};
    const MeshSearch search(mesh, boxes);
    auto all = parallel_list<std::uint32_t>(
        leaning.size(), kPerTask, [&](std::size_t begin, std::size_t end, std::vector<std::uint32_t>& numbers) {
            for (const std::uint32_t t : leaning.subspan(begin, end - begin)) {
                const HeldTriangle held(mesh, mesh.triangles[t]);
                search.for_each_near(box_of(mesh, mesh.triangles[t]), [&](std::uint32_t other, const Box&) {
                    if (other != t && held.meeting(mesh, mesh.triangles[other]))
                        numbers.insert(numbers.end(), {t, other});
                });
            }
        });
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

}  // namespace meniscus
