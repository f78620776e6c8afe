// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "band/surface_blocks.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <span>
#include <unordered_set>

#include "core/bits.h"
#include "core/parallel.h"
#include "core/parallel_list.h"
#include "core/workspaces.h"
#include "geometry/accessible_surface_data.h"
#include "meniscus/errors.h"
#include "nearest/nearest_batch.h"

namespace meniscus {
namespace {

constexpr std::size_t kCubesPerChunk = 4;

using CubeSet = std::unordered_set<BlockCoord, BlockCoordHash>;

// Blocks are looked at in cubes of 4³, one bit for each block.
constexpr std::int32_t kCubeEdge = 4;
using CubeMask = std::uint64_t;

int cube_bit(int x, int y, int z) { return x + kCubeEdge * (y + kCubeEdge * z); }

// The blocks of a cube that touch its neighbour in a direction.
CubeMask facing(int dx, int dy, int dz) {
    const auto touches = [](int at, int d) { return d == 0 || at == (d < 0 ? 0 : kCubeEdge - 1); };
    CubeMask mask = 0;
    for (int z = 0; z < kCubeEdge; ++z)
        for (int y = 0; y < kCubeEdge; ++y)
            for (int x = 0; x < kCubeEdge; ++x)
                if (touches(x, dx) && touches(y, dy) && touches(z, dz)) mask |= CubeMask{1} << cube_bit(x, y, z);
    return mask;
}

struct Direction {
    BlockCoord step;
    CubeMask facing = 0;
};
std::vector<Direction> directions() {
    std::vector<Direction> all;
    for (int dz = -1; dz <= 1; ++dz)
        for (int dy = -1; dy <= 1; ++dy)
            for (int dx = -1; dx <= 1; ++dx)
                if (dx != 0 || dy != 0 || dz != 0) all.push_back({{.z = dz, .y = dy, .x = dx}, facing(dx, dy, dz)});
    return all;
}

// Finds which blocks of a cube have a centre within reach of the surface.
class CubeSearch {
public:
    CubeSearch(const AccessibleSurface& surface, const Lattice& lattice, double reach)
        : lattice_(lattice), part_edge_(part_edge(lattice.block_edge())), local_(surface, reach), batch_(surface) {}

    CubeMask near(const BlockCoord& cube) {
        CubeMask mask = 0;
        for (int z = 0; z < kCubeEdge; z += part_edge_)
            for (int y = 0; y < kCubeEdge; y += part_edge_)
                for (int x = 0; x < kCubeEdge; x += part_edge_) mask |= near_in_part(cube, x, y, z);
        return mask;
    }

private:
    // In larger parts most features are far from most blocks.
    static int part_edge(double block_edge) {
        constexpr double kLargestPart = 16.0;  // Å
        int edge = kCubeEdge;
        while (edge > 1 && edge * block_edge > kLargestPart) edge /= 2;
        return edge;
    }

    CubeMask near_in_part(const BlockCoord& cube, int x0, int y0, int z0) {
        centres_.clear();
        bits_.clear();
        Box box;
        for (int z = z0; z < z0 + part_edge_; ++z)
            for (int y = y0; y < y0 + part_edge_; ++y)
                for (int x = x0; x < x0 + part_edge_; ++x) {
                    centres_.push_back(lattice_.centre(
                        {.z = kCubeEdge * cube.z + z, .y = kCubeEdge * cube.y + y, .x = kCubeEdge * cube.x + x}));
                    bits_.push_back(cube_bit(x, y, z));
                    box.include(centres_.back());
                }
        local_.gather(box);
        if (batch_.start(local_, box, local_.margin()) != NearestBatch::Claim::Open) return 0;
        batch_.find(centres_);
        CubeMask mask = 0;
        for (std::size_t i = 0; i < centres_.size(); ++i)
            if (batch_.found(i)) mask |= CubeMask{1} << bits_[i];
        return mask;
    }

    const Lattice& lattice_;
    int part_edge_;
    LocalFeatures local_;
    NearestBatch batch_;
    std::vector<Vec3> centres_;
    std::vector<int> bits_;
};

BlockCoord cube_of(const BlockCoord& block) { return {.z = block.z >> 2, .y = block.y >> 2, .x = block.x >> 2}; }

// The blocks of a cube near the surface, one bit for each.
struct MarkedCube {
    BlockCoord cube;
    CubeMask blocks = 0;
};

// Calls visit(run) for each run of cubes that are equal along an axis.
template <class Visit>
void for_each_run(std::span<const MarkedCube> cubes, std::int32_t BlockCoord::*axis, const Visit& visit) {
    for (std::size_t begin = 0, end = 0; begin < cubes.size(); begin = end) {
        while (end < cubes.size() && cubes[end].cube.*axis == cubes[begin].cube.*axis) ++end;
        visit(cubes.subspan(begin, end - begin));
    }
}

// The blocks of ascending cubes, ascending themselves.
std::vector<BlockCoord> list_blocks(std::span<const MarkedCube> cubes) {
    constexpr CubeMask kRow = (CubeMask{1} << kCubeEdge) - 1;
    std::vector<BlockCoord> blocks;
    const auto list_row = [&](std::span<const MarkedCube> row, int y, int z) {
        for (const MarkedCube& marked : row)
            for_each_bit(marked.blocks >> cube_bit(0, y, z) & kRow, [&](std::size_t x) {
                blocks.push_back({.z = kCubeEdge * marked.cube.z + z,
                                  .y = kCubeEdge * marked.cube.y + y,
                                  .x = kCubeEdge * marked.cube.x + static_cast<std::int32_t>(x)});
            });
    };
    for_each_run(cubes, &BlockCoord::z, [&](std::span<const MarkedCube> layer) {
        for (int z = 0; z < kCubeEdge; ++z)
            for_each_run(layer, &BlockCoord::y, [&](std::span<const MarkedCube> row) {
                for (int y = 0; y < kCubeEdge; ++y) list_row(row, y, z);
            });
    });
    return blocks;
}

// Cubes with at least one point of the van der Waals spheres on every piece of the surface; some more than once.
std::vector<BlockCoord> cubes_on_surface(const AccessibleSurface::Data& data, const Lattice& lattice) {
    constexpr std::size_t kPerChunk = 1024;
    const auto add = [&](std::uint32_t atom, const Vec3& towards, std::vector<BlockCoord>& cubes) {
        const Vec3& centre = data.atoms.centres[atom];
        const Vec3 point = centre + (data.atoms.radii[atom] / norm(towards - centre)) * (towards - centre);
        const BlockCoord cube = cube_of(lattice.block_of(point));
        if (cubes.empty() || cubes.back() != cube) cubes.push_back(cube);  // most are in that of the one before
    };
    using Cubes = std::vector<BlockCoord>;
    Cubes cubes = parallel_list<BlockCoord>(data.arcs.size(), kPerChunk, [&](auto begin, auto end, Cubes& list) {
        for (std::size_t a = begin; a < end; ++a) {
            const SasArc& arc = data.arcs[a];
            for (const std::uint32_t atom : arc.atoms) add(atom, arc.centre + arc.radius * arc.middle, list);
        }
    });
    for (std::uint32_t i = 0; i < data.atoms.size(); ++i)
        if (data.exposed[i] != 0 && data.caps_of(i).empty()) add(i, data.atoms.centres[i] + Vec3{0.0, 0.0, 1.0}, cubes);
    return cubes;
}

}  // namespace

BlockCoord Lattice::block_of(const Vec3& point) const {
    const auto index = [&](double offset) {
        const double block = std::floor(offset / block_edge());
        if (!(std::abs(block) < (1 << 30)))
            throw LimitError("the atoms are too far from the origin for this grid spacing; choose a larger one");
        return static_cast<std::int32_t>(block);
    };
    const Vec3 offset = point - origin;
    return {.z = index(offset.z), .y = index(offset.y), .x = index(offset.x)};
}

std::vector<BlockCoord> blocks_near_surface(const AccessibleSurface& surface, const Lattice& lattice, double margin,
                                            std::size_t max_blocks) {
    const double reach = margin + 0.5 * std::numbers::sqrt3 * lattice.block_edge();
    const std::vector<Direction> around = directions();
    CubeSet seen;
    std::vector<BlockCoord> frontier;
    for (const BlockCoord& cube : cubes_on_surface(surface.data(), lattice))
        if (seen.insert(cube).second) frontier.push_back(cube);

    Workspaces searches([&] { return std::make_unique<CubeSearch>(surface, lattice, reach); });
    std::vector<MarkedCube> found;
    std::size_t blocks = 0;
    std::vector<CubeMask> near;
    while (!frontier.empty()) {
        near.resize(frontier.size());
        parallel_chunks(frontier.size(), kCubesPerChunk, [&](std::size_t begin, std::size_t end) {
            searches.with_one([&](CubeSearch& search) {
                for (std::size_t c = begin; c < end; ++c) near[c] = search.near(frontier[c]);
            });
        });
        std::vector<BlockCoord> next;
        for (std::size_t c = 0; c < frontier.size(); ++c) {
            const BlockCoord& at = frontier[c];
            if (near[c] == 0) continue;
            found.push_back({at, near[c]});
            blocks += count_bits(near[c]);
            for (const auto& [step, facing] : around) {
                const BlockCoord beside{.z = at.z + step.z, .y = at.y + step.y, .x = at.x + step.x};
                if ((near[c] & facing) != 0 && seen.insert(beside).second) next.push_back(beside);
            }
        }
        if (blocks > max_blocks)
            throw LimitError(
                "the narrow band would not fit into memory; choose a larger spacing, or allow more memory");
        frontier = std::move(next);
    }
    std::sort(found.begin(), found.end(), [](const MarkedCube& a, const MarkedCube& b) { return a.cube < b.cube; });
    return list_blocks(found);
}

}  // namespace meniscus
