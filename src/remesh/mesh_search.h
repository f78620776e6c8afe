// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The triangles near a place, in a mesh whose triangles change.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/bits.h"
#include "meniscus/mesh.h"
#include "remesh/first_look.h"
#include "space/box_tree.h"
#include "space/triangle_tree.h"

namespace meniscus {

/// A removed triangle stays in the list for the time being, with the same corner three times.
inline bool is_removed(const Triangle& t) { return t[0] == t[1]; }

class MeshSearch {
public:
    /// Both must outlive the search. A triangle that leaves the box that its chunk has now may be missed afterwards.
    MeshSearch(const Mesh& mesh, const TriangleBoxes& boxes) : mesh_(mesh), boxes_(boxes), chunks_(boxes.chunks) {}

    /// Calls visit(triangle, its box) for all whose boxes overlap one.
    template <class Visit>
    void for_each_near(const Box& box, const Visit& visit) const {
        chunks_.for_each_overlapping(box, [&](std::uint32_t chunk) {
            const Box near = box.grown(boxes_.longest[chunk]);
            for_each_bit(stretches_near(box, chunk), [&](std::size_t stretch) {
                const std::size_t begin = chunk * TriangleBoxes::kChunk + stretch * TriangleBoxes::kStretch;
                for_each_bit(triangles_near(near, begin), [&](std::size_t i) {
                    const Triangle& triangle = mesh_.triangles[begin + i];
                    const Box of_triangle = box_of(mesh_, triangle);
                    if (of_triangle.overlaps(box) && !is_removed(triangle))
                        visit(static_cast<std::uint32_t>(begin + i), of_triangle);
                });
            });
        });
    }

private:
    std::uint64_t stretches_near(const Box& box, std::size_t chunk) const;
    std::uint64_t triangles_near(const Box& box, std::size_t begin) const;

    const Mesh& mesh_;
    const TriangleBoxes& boxes_;
    BoxTree chunks_;
};

/// Triangles that pass through each other, one of two at least a leaning one (FirstLook); rising.
std::vector<std::uint32_t> tangled_triangles(const Mesh& mesh, const TriangleBoxes& boxes,
                                             std::span<const std::uint32_t> leaning);

}  // namespace meniscus
