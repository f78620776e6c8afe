// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What tells the bad triangles of a mesh, and where to look for what lies near them, found in one pass over all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "measure/triangle_lanes.h"
#include "meniscus/mesh.h"
#include "space/box_tree.h"

namespace meniscus {

/// Boxes round the triangles of a mesh, chunk by chunk: neighbours, if the mesh comes from blocks.
struct TriangleBoxes {
    static constexpr std::size_t kChunk = 256;              // triangles
    static constexpr std::size_t kStretch = kStretchLanes;  // of these, nearer to each other still

    std::vector<Box> chunks;          ///< each round its triangles
    std::vector<double> longest;      ///< per chunk: Å, no side is longer
    std::vector<SmallBox> stretches;  ///< each round its triangles

    /// Makes room for so many triangles.
    void resize(std::size_t triangles);
    /// Makes the boxes hold a triangle that has changed.
    void include(const Mesh& mesh, std::uint32_t triangle);
};

/// Looks at triangles as they are measured (measure/triangle_survey.h).
class FirstLook {
public:
    /// mesh   with normals; must outlive this and stay as it is until all of it has been looked at
    /// shortest_edge   Å
    FirstLook(const Mesh& mesh, double smallest_angle_deg, double shortest_edge);

    /// A TriangleLook.
    void look(std::size_t first, std::span<const Triangle> triangles, const TriangleLanes& lanes);
    void look_at_all();

    struct Suspects {
        std::vector<std::uint32_t> bad;      ///< may have too small an angle or side, or face the wrong way; rising
        std::vector<std::uint32_t> leaning;  ///< one of two that pass through each other is among these; rising
        TriangleBoxes boxes;
    };
    /// After a look at every triangle.
    Suspects suspects() &&;

private:
    void bound_all(std::size_t first, const TriangleLanes& lanes);
    void bound_some(std::size_t first, std::span<const Triangle> triangles, const TriangleLanes& lanes);

    const Mesh& mesh_;
    SuspectLimits limits_;
    std::vector<std::uint64_t> bad_;      // a word for each look, a bit for each triangle
    std::vector<std::uint64_t> leaning_;  // likewise
    TriangleBoxes boxes_;                 // not `chunks` yet, and of `longest` the squares
};

}  // namespace meniscus
