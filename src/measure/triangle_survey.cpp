// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "measure/triangle_survey.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/bits.h"
#include "core/elementary.h"
#include "core/parallel.h"
#include "meniscus/errors.h"
#include "mesh/components.h"
#include "mesh/corner_numbers.h"
#include "platform/fresh_memory.h"

namespace meniscus {
namespace {

static_assert(kSurveyChunk % kLanes == 0);
constexpr std::size_t kChunksPerTask = 32;  // some tens of microseconds

std::size_t chunks_of(std::size_t triangles) { return (triangles + kSurveyChunk - 1) / kSurveyChunk; }

}  // namespace

void check_corners(const Mesh& mesh, std::span<const Triangle> some) {
    if (!some.empty() && triangle_kernels().find_largest_index(all_corners(some)) >= mesh.vertices.size())
        throw UsageError("a triangle names a vertex that the mesh does not have");
}

TriangleSurvey::PieceLanes::PieceLanes(std::span<const Triangle> triangles, std::span<const std::uint32_t> of_vertex) {
    std::uint32_t others = 0;
    const std::uint32_t first = of_vertex[triangles[0][0]];
    for (std::size_t lane = 0; lane < triangles.size(); ++lane) {
        of[lane] = of_vertex[triangles[lane][0]];
        others |= of[lane] ^ first;
    }
    is_one = others == 0;
}

TriangleSurvey::TriangleSurvey(const Mesh& mesh, std::span<const std::uint32_t> of_vertex, Parts parts,
                               const TriangleLook& look)
    : parts_(parts == Parts::Creased && !knows_creases(mesh) ? Parts::Smooth : parts),
      triangles_(mesh.triangles.size()),
      chunks_(chunks_of(triangles_)) {
    for (const VertexId first : vertices_of_pieces(of_vertex).first) origins_.push_back(mesh.vertices[first]);
    if (parts_ != Parts::LeftOut) resize_touched(thirds_, triangles_);
    parallel_chunks(chunks_.size(), kChunksPerTask, [&](std::size_t begin, std::size_t end) {
        TriangleLanes lanes;
        for (std::size_t chunk = begin; chunk < end; ++chunk) survey(chunk, {mesh, of_vertex}, look, lanes);
    });
}

void TriangleSurvey::update(const Mesh& mesh, std::span<const std::uint32_t> of_vertex,
                            std::span<const std::uint32_t> changed) {
    std::vector<std::size_t> again;
    for (const std::uint32_t t : changed)
        if (again.empty() || again.back() != t / kSurveyChunk) again.push_back(t / kSurveyChunk);
    const std::size_t kept = std::min(triangles_, mesh.triangles.size()) / kSurveyChunk;
    if (triangles_ != mesh.triangles.size()) {
        while (!again.empty() && again.back() >= kept) again.pop_back();
        for (std::size_t chunk = kept; chunk < chunks_of(mesh.triangles.size()); ++chunk) again.push_back(chunk);
    }
    triangles_ = mesh.triangles.size();
    chunks_.resize(chunks_of(triangles_));
    if (parts_ != Parts::LeftOut) thirds_.resize(triangles_);
    parallel_chunks(again.size(), kChunksPerTask, [&](std::size_t begin, std::size_t end) {
        TriangleLanes lanes;
        for (std::size_t i = begin; i < end; ++i) survey(again[i], {mesh, of_vertex}, {}, lanes);
    });
}

void TriangleSurvey::survey(std::size_t chunk, const LabelledMesh& labelled, const TriangleLook& look,
                            TriangleLanes& lanes) {
    const auto& [mesh, of_vertex] = labelled;
    const std::size_t begin = chunk * kSurveyChunk;
    const std::size_t end = std::min(begin + kSurveyChunk, mesh.triangles.size());
    ChunkSums sums;
    for (std::size_t first = begin; first < end; first += kLanes) {
        const auto triangles = std::span(mesh.triangles).subspan(first, std::min(kLanes, end - first));
        check_corners(mesh, triangles);
        const PieceLanes pieces(triangles, of_vertex);
        load(mesh, triangles, pieces, lanes);
        measure(mesh, triangles, lanes);
        if (look) look(first, triangles, lanes);
        if (!thirds_.empty()) std::copy_n(lanes.thirds.begin(), triangles.size(), &thirds_[first]);
        add(triangles.size(), pieces, lanes, sums);
    }
    chunks_[chunk] = std::move(sums);
}

void TriangleSurvey::load(const Mesh& mesh, std::span<const Triangle> triangles, const PieceLanes& pieces,
                          TriangleLanes& lanes) const {
    const SmallVec3* normals = parts_ != Parts::LeftOut ? mesh.normals.data() : nullptr;
    if (pieces.is_one) {
        lanes.origin = origins_[pieces.of[0]];
        triangle_kernels().gather(mesh.vertices.data(), normals, triangles, *lanes.origin, lanes);
        return;
    }
    lanes.origin.reset();
    triangle_kernels().gather(mesh.vertices.data(), normals, triangles, {}, lanes);
    for (std::size_t lane = 0; lane < triangles.size(); ++lane)
        for (VectorLanes& corners : lanes.points) corners.set(lane, corners.at(lane) - origins_[pieces.of[lane]]);
}

void TriangleSurvey::measure(const Mesh& mesh, std::span<const Triangle> triangles, TriangleLanes& lanes) const {
    if (parts_ == Parts::LeftOut) return triangle_kernels().measure(lanes);
    const std::uint64_t may_be_creased = triangle_kernels().measure_with_parts(lanes);
    if (parts_ != Parts::Creased) return;
    const std::uint64_t looked_at = first_bits(triangles.size());
    follow_creases(mesh, triangles, may_be_creased & looked_at, lanes);
}

TriangleSurvey::RunSums& TriangleSurvey::run_of(std::uint32_t piece, ChunkSums& sums) {
    if (sums.runs.empty() || sums.runs.back().piece != piece) sums.runs.push_back({.piece = piece});
    return sums.runs.back();
}

void TriangleSurvey::add(std::size_t count, const PieceLanes& pieces, const TriangleLanes& lanes, ChunkSums& sums) {
    if (count == kLanes && pieces.is_one) {
        LaneSums all;
        triangle_kernels().add_up(lanes, all);
        RunSums& run = run_of(pieces.of[0], sums);
        run.triangles += kLanes;
        run.two_areas += all.two_areas;
        run.six_volumes += all.six_volumes;
        sums.parts_two_areas += all.parts_two_areas;
        sums.parts_six_volumes += all.parts_six_volumes;
        sums.smallest += all.smallest;
        sums.shortest = std::min(sums.shortest, all.shortest);
        return;
    }
    for (std::size_t lane = 0; lane < count; ++lane) {
        RunSums& run = run_of(pieces.of[lane], sums);
        ++run.triangles;
        run.two_areas += lanes.two_areas[lane];
        run.six_volumes += lanes.six_volumes[lane];
        sums.parts_two_areas += lanes.parts_two_areas[lane];
        sums.parts_six_volumes += lanes.parts_six_volumes[lane];
        sums.smallest += {lanes.opposite[lane], lanes.adjacent[lane]};
        sums.shortest = std::min(sums.shortest, lanes.shortest[lane]);
    }
}

MeshMeasures TriangleSurvey::measures(std::span<const std::uint32_t> of_vertex) const {
    MeshMeasures measures;
    for (const std::size_t count : vertices_of_pieces(of_vertex).counts)
        measures.components.emplace_back().vertices = count;
    SquaredTangent smallest;
    double shortest = std::numeric_limits<double>::infinity();
    for (const ChunkSums& chunk : chunks_) {
        smallest += chunk.smallest;
        shortest = std::min(shortest, chunk.shortest);
        for (const RunSums& run : chunk.runs) {
            MeshComponent& piece = measures.components[run.piece];
            piece.triangles += run.triangles;
            piece.area += run.two_areas / 2.0;
            piece.volume += run.six_volumes / 6.0;
        }
    }
    for (const MeshComponent& piece : measures.components) {
        measures.area += piece.area;
        measures.volume += piece.volume;
    }
    if (chunks_.empty()) return measures;
    const double angle = elementary::atan2(std::sqrt(smallest.opposite), std::sqrt(smallest.adjacent));
    measures.smallest_angle_deg = angle * 180.0 / std::numbers::pi;
    measures.shortest_edge = std::sqrt(shortest);
    return measures;
}

CorrectedMeasures TriangleSurvey::parts() const {
    double two_areas = 0.0;
    double six_volumes = 0.0;
    for (const ChunkSums& chunk : chunks_) {
        two_areas += chunk.parts_two_areas;
        six_volumes += chunk.parts_six_volumes;
    }
    return {two_areas / 2.0, six_volumes / 6.0};
}

}  // namespace meniscus
