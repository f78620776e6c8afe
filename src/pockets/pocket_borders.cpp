// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pockets/pocket_borders.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <utility>

#include "core/disjoint_sets.h"
#include "pockets/voxel_neighbours.h"

namespace meniscus {
namespace {

struct Facet {
    Vec3 centre;
    Vec3 normal;  // unit vector; zero for a triangle without an area
    double area = 0.0;
};

Facet facet_of(const Mesh& mesh, const Triangle& triangle) {
    const Vec3& a = mesh.vertices[triangle[0]];
    const Vec3& b = mesh.vertices[triangle[1]];
    const Vec3& c = mesh.vertices[triangle[2]];
    const Vec3 turned = cross(b - a, c - a);
    const double length = norm(turned);
    return {(1.0 / 3.0) * (a + b + c), length > 0.0 ? (1.0 / length) * turned : Vec3{}, 0.5 * length};
}

// The voxel next to a point that holds most pocket space, of the eight around it; kNoVoxel where none holds any.
VoxelId fullest_voxel_near(const PocketSpace& space, const Vec3& point) {
    const double half = 0.5 * space.grid.spacing();
    VoxelId best = kNoVoxel;
    for (const double z : {-half, half})
        for (const double y : {-half, half})
            for (const double x : {-half, half}) {
                const VoxelId voxel = space.voxel_at(point + Vec3{x, y, z});
                if (voxel != kNoVoxel && (best == kNoVoxel || space.shares[voxel] > space.shares[best])) best = voxel;
            }
    return best;
}

// The pocket that a point beside the surface lies in, or kNone. A point whose own voxel holds nothing, as in a gap
// narrower than a voxel, is in the pocket of its neighbours.
std::uint32_t pocket_at(const PocketSpace& space, const PocketLabels& labels, const Vec3& point) {
    VoxelId voxel = space.voxel_at(point);
    if (voxel == kNoVoxel) voxel = fullest_voxel_near(space, point);
    return voxel == kNoVoxel ? kNone : labels.of_voxel[voxel];
}

PocketMouth mouth_of(double area, const Vec3& moment, double scale) {
    return {scale * area, std::sqrt(scale * area / std::numbers::pi), (1.0 / area) * moment};
}

void sort_by_area(std::vector<PocketMouth>& mouths) {
    std::stable_sort(mouths.begin(), mouths.end(),
                     [](const PocketMouth& a, const PocketMouth& b) { return a.area > b.area; });
}

// Connected parts of what is added, by pocket.
class Parts {
public:
    explicit Parts(std::size_t pockets) : pockets_(pockets) {}

    /// Adds a piece that hangs together with all others of the pocket that share a number with it.
    template <class Numbers>
    void add(std::uint32_t pocket, const Numbers& numbers, double area, const Vec3& centre) {
        const auto piece = static_cast<std::uint32_t>(pieces_.size());
        pieces_.push_back({pocket, area, centre});
        sets_.grow(pieces_.size());
        for (const std::uint32_t number : numbers) {
            const auto [place, fresh] = first_.try_emplace({pocket, number}, piece);
            if (!fresh) sets_.join(place->second, piece);
        }
    }

    std::vector<std::vector<PocketMouth>> mouths(double scale) {
        std::map<std::uint32_t, std::pair<double, Vec3>> sums;  // by the root of a part
        for (std::uint32_t i = 0; i < pieces_.size(); ++i) {
            auto& [area, moment] = sums[sets_.root(i)];
            area += pieces_[i].area;
            moment += pieces_[i].area * pieces_[i].centre;
        }
        std::vector<std::vector<PocketMouth>> result(pockets_);
        for (const auto& [root, sum] : sums)
            if (sum.first > 0.0) result[pieces_[root].pocket].push_back(mouth_of(sum.first, sum.second, scale));
        for (std::vector<PocketMouth>& list : result) sort_by_area(list);
        return result;
    }

private:
    struct Piece {
        std::uint32_t pocket;
        double area;
        Vec3 centre;
    };

    std::size_t pockets_;
    std::vector<Piece> pieces_;
    DisjointSets sets_;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> first_;
};

}  // namespace

std::vector<std::vector<WallAtom>> walls(const PocketSpace& space, const PocketLabels& labels, const Mesh& mesh,
                                         const Measures& measures) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, double> areas;  // of pocket and atom
    std::vector<double> of_atom(measures.atoms.size());
    for (const Triangle& triangle : mesh.triangles) {
        const Facet facet = facet_of(mesh, triangle);
        const Vec3 beside = facet.centre + 0.5 * space.grid.spacing() * facet.normal;
        const std::uint32_t pocket = pocket_at(space, labels, beside);
        for (const VertexId corner : triangle) {
            of_atom[mesh.atoms[corner]] += facet.area / 3.0;
            if (pocket != kNone) areas[{pocket, mesh.atoms[corner]}] += facet.area / 3.0;
        }
    }
    std::vector<std::vector<WallAtom>> result(labels.count);
    for (const auto& [key, area] : areas) {
        const auto& [pocket, atom] = key;
        const double exact = measures.atoms[atom].ses_area() * (area / of_atom[atom]);
        if (exact > 0.0) result[pocket].push_back({atom, exact});
    }
    return result;
}

std::vector<std::vector<PocketMouth>> mouths(const PocketSpace& space, const PocketLabels& labels, const Mesh& mesh,
                                             double exact_area) {
    Parts parts(labels.count);
    double total = 0.0;
    for (const Triangle& triangle : mesh.triangles) {
        Facet facet = facet_of(mesh, triangle);
        const auto free = std::count_if(triangle.begin(), triangle.end(),
                                        [&](VertexId v) { return mesh.patches[v] != PatchKind::Contact; });
        if (free == 0) continue;
        facet.area *= static_cast<double>(free) / 3.0;
        total += facet.area;
        const Vec3 beneath = facet.centre - 0.5 * space.grid.spacing() * facet.normal;
        const std::uint32_t pocket = pocket_at(space, labels, beneath);
        if (pocket != kNone) parts.add(pocket, triangle, facet.area, facet.centre);
    }
    return parts.mouths(total > 0.0 ? exact_area / total : 1.0);
}

std::vector<std::vector<PocketMouth>> openings(const PocketSpace& space, const PocketLabels& labels) {
    // The mean projection of an area of any orientation on the three axes is half of it each: faces of cubes count
    // 3/2 of it.
    const double face = 2.0 / 3.0 * space.grid.spacing() * space.grid.spacing();
    Parts parts(labels.count);
    for (VoxelId v = 0; v < space.size(); ++v) {
        const std::uint32_t pocket = labels.of_voxel[v];
        if (pocket == kNone) continue;
        double area = 0.0;
        Vec3 moment;
        for_each_face_neighbour(space, v, [&](VoxelId other) {
            if (labels.of_voxel[other] == pocket) return;
            area += face;
            moment += (0.5 * face) * (space.position(v) + space.position(other));
        });
        if (area == 0.0) continue;
        std::vector<std::uint32_t> numbers{v};
        for_each_neighbour(space, v, [&](VoxelId other) {
            if (labels.of_voxel[other] == pocket) numbers.push_back(other);
        });
        parts.add(pocket, numbers, area, (1.0 / area) * moment);
    }
    return parts.mouths(1.0);
}

}  // namespace meniscus
