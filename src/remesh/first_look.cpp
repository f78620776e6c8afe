// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/first_look.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/bits.h"
#include "core/parallel.h"
#include "platform/fresh_memory.h"
#include "remesh/patch.h"
#include "remesh/remesher.h"
#include "space/triangle_tree.h"

namespace meniscus {
namespace {

// Of two triangles that pass through each other at least one leans over: the cosine between its normal and that of one
// of its corners is below this.
constexpr double kLeaning = 0.4;

constexpr double kAboveOne = 1.0 + 1e-9;  // for rounding

constexpr std::size_t kChunk = TriangleBoxes::kChunk;
constexpr std::size_t kStretch = TriangleBoxes::kStretch;
static_assert(kChunk % kLanes == 0);

std::size_t chunks_of(std::size_t triangles) { return (triangles + kChunk - 1) / kChunk; }
std::size_t looks_of(std::size_t triangles) { return (triangles + kLanes - 1) / kLanes; }

std::vector<std::uint32_t> items_of(const std::vector<std::uint64_t>& words) {
    std::vector<std::uint32_t> items;
    for_each_item(words.data(), 64 * words.size(),
                  [&](std::size_t item) { items.push_back(static_cast<std::uint32_t>(item)); });
    return items;
}

}  // namespace

void TriangleBoxes::resize(std::size_t triangles) {
    chunks.resize(chunks_of(triangles));
    longest.resize(chunks.size());
    stretches.resize(chunks.size() * (kChunk / kStretch));
}

void TriangleBoxes::include(const Mesh& mesh, std::uint32_t triangle) {
    const Box box = box_of(mesh, mesh.triangles[triangle]);
    double& longest_side = longest[triangle / kChunk];
    chunks[triangle / kChunk].include(box);
    longest_side = std::max(longest_side, norm(box.high - box.low));
    stretches[triangle / kStretch].include(SmallBox(box));
}

FirstLook::FirstLook(const Mesh& mesh, double smallest_angle_deg, double shortest_edge)
    : mesh_(mesh), bad_(looks_of(mesh.triangles.size())), leaning_(bad_.size()) {
    const std::size_t chunks = chunks_of(mesh.triangles.size());
    boxes_.longest.resize(chunks);
    resize_touched(boxes_.stretches, chunks * (kChunk / kStretch));
    const double tangent = tangent_of_degrees(smallest_angle_deg);
    limits_ = {.squared_tangent = kAboveOne * tangent * tangent,
               .squared_edge = shortest_edge * shortest_edge,
               .squared_cosine = kLeaning * kLeaning};
}

void FirstLook::look(std::size_t first, std::span<const Triangle> triangles, const TriangleLanes& lanes) {
    const std::uint64_t looked_at = first_bits(triangles.size());
    const auto [may_be_bad, leaning] = triangle_kernels().mark(lanes, limits_);
    bad_[first / kLanes] = may_be_bad & looked_at;
    leaning_[first / kLanes] = leaning & looked_at;
    if (triangles.size() == kLanes && lanes.origin)
        bound_all(first, lanes);
    else
        bound_some(first, triangles, lanes);
}

void FirstLook::bound_all(std::size_t first, const TriangleLanes& lanes) {
    constexpr double kRounding = 1e-9;  // Å, of coordinates from an origin
    double& longest = boxes_.longest[first / kChunk];
    longest = std::max(longest, triangle_kernels().find_largest(lanes.longest));
    StretchBoxes boxes;
    triangle_kernels().bound(lanes, boxes);
    for (std::size_t s = 0; s < boxes.size(); ++s) {
        const Box from_origin = boxes[s].grown(kRounding);
        boxes_.stretches[first / kStretch + s] =
            SmallBox({*lanes.origin + from_origin.low, *lanes.origin + from_origin.high});
    }
}

void FirstLook::bound_some(std::size_t first, std::span<const Triangle> triangles, const TriangleLanes& lanes) {
    double& longest = boxes_.longest[first / kChunk];
    for (std::size_t lane = 0; lane < triangles.size(); ++lane) longest = std::max(longest, lanes.longest[lane]);
    for (std::size_t lane = 0; lane < triangles.size(); lane += kStretch) {
        Box box;
        for (const Triangle& triangle : triangles.subspan(lane, std::min(kStretch, triangles.size() - lane)))
            box.include(box_of(mesh_, triangle));
        boxes_.stretches[(first + lane) / kStretch] = SmallBox(box);
    }
}

void FirstLook::look_at_all() {
    constexpr std::size_t kChunksPerTask = 32;
    parallel_chunks(mesh_.triangles.size(), kChunksPerTask * kChunk, [&](std::size_t begin, std::size_t end) {
        TriangleLanes lanes;
        for (std::size_t first = begin; first < end; first += kLanes) {
            const auto triangles = std::span(mesh_.triangles).subspan(first, std::min(kLanes, end - first));
            triangle_kernels().gather(mesh_.vertices.data(), mesh_.normals.data(), triangles, {}, lanes);
            triangle_kernels().measure_with_normals(lanes);
            look(first, triangles, lanes);
        }
    });
}

FirstLook::Suspects FirstLook::suspects() && {
    Suspects all{.bad = items_of(bad_), .leaning = items_of(leaning_), .boxes = std::move(boxes_)};
    TriangleBoxes& round = all.boxes;
    round.chunks.resize(round.longest.size());
    parallel_for(round.chunks.size(), kChunk, [&](std::size_t c) {
        constexpr std::size_t kStretches = kChunk / kStretch;
        round.longest[c] = kAboveOne * std::sqrt(round.longest[c]);
        SmallBox box;
        for (std::size_t s = 0; s < kStretches; ++s) box.include(round.stretches[c * kStretches + s]);
        round.chunks[c] = box.box();
    });
    return all;
}

}  // namespace meniscus
