// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What the triangles of a mesh measure, found in one pass in which every one is looked at while its corners are at
// hand.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "measure/corrected.h"
#include "measure/creases.h"
#include "measure/triangle_lanes.h"
#include "meniscus/mesh.h"
#include "meniscus/node_field.h"

namespace meniscus {

/// Looks at at most kLanes triangles in a row, of which the first has a number that is a multiple of kLanes, after
/// measure_with_normals. Called from several threads at once, but only from one for kSurveyChunk in a row.
using TriangleLook =
    std::function<void(std::size_t first, std::span<const Triangle> triangles, const TriangleLanes& lanes)>;
inline constexpr std::size_t kSurveyChunk = 256;

/// throws   UsageError where a triangle names a vertex that the mesh does not have
void check_corners(const Mesh& mesh, std::span<const Triangle> some);

class TriangleSurvey {
public:
    /// What is measured beside areas, volumes and angles.
    enum class Parts : std::uint8_t {
        LeftOut,
        Smooth,   ///< those of triangles (measure/corrected.h); needs normals
        Creased,  ///< the same, following creases where the mesh has the curvatures to know them by (measure/creases.h)
    };

    /// of_vertex   number of each vertex's piece
    /// throws      as check_corners
    /// cost        O(n) for n triangles; 4 bytes are kept of each if parts are measured
    TriangleSurvey(const Mesh& mesh, std::span<const std::uint32_t> of_vertex, Parts parts,
                   const TriangleLook& look = {});

    /// Looks once more at triangles that have changed, and at how many there are.
    ///
    /// changed     numbers, rising, of those that other vertices belong to or vertices that moved
    /// Precondition: pieces are numbered as before.
    void update(const Mesh& mesh, std::span<const std::uint32_t> of_vertex, std::span<const std::uint32_t> changed);

    /// All but the topology; pieces in the order of their numbers.
    MeshMeasures measures(std::span<const std::uint32_t> of_vertex) const;

    /// Sums over the parts of all triangles.
    CorrectedMeasures parts() const;

    /// A third of the area of each triangle, if parts are measured.
    std::span<const float> thirds() const { return thirds_; }

private:
    // What one run of triangles of the same piece measures.
    struct RunSums {
        std::uint32_t piece = 0;
        std::size_t triangles = 0;
        double two_areas = 0.0;
        double six_volumes = 0.0;
    };
    struct ChunkSums {
        std::vector<RunSums> runs;
        double parts_two_areas = 0.0;
        double parts_six_volumes = 0.0;
        SquaredTangent smallest;
        double shortest = std::numeric_limits<double>::infinity();  // squared
    };
    struct LabelledMesh {
        const Mesh& mesh;
        std::span<const std::uint32_t> of_vertex;  // number of each vertex's piece
    };
    // The pieces that at most kLanes triangles belong to.
    struct PieceLanes {
        PieceLanes(std::span<const Triangle> triangles, std::span<const std::uint32_t> of_vertex);
        std::array<std::uint32_t, kLanes> of{};
        bool is_one = false;
    };

    void survey(std::size_t chunk, const LabelledMesh& labelled, const TriangleLook& look, TriangleLanes& lanes);
    void load(const Mesh& mesh, std::span<const Triangle> triangles, const PieceLanes& pieces,
              TriangleLanes& lanes) const;
    void measure(const Mesh& mesh, std::span<const Triangle> triangles, TriangleLanes& lanes) const;
    static void add(std::size_t count, const PieceLanes& pieces, const TriangleLanes& lanes, ChunkSums& sums);
    static RunSums& run_of(std::uint32_t piece, ChunkSums& sums);

    Parts parts_;
    std::size_t triangles_;
    std::vector<Vec3> origins_;  // first vertex of each piece: volumes taken from there keep their digits
    std::vector<ChunkSums> chunks_;
    std::vector<float, UnsetAllocator<float>> thirds_;
};

}  // namespace meniscus
