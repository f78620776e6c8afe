// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "cavities/choose_pieces.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "core/elementary.h"
#include "mesh/components.h"
#include "project/surface_projector.h"
#include "space/box_tree.h"

namespace meniscus {
namespace {

// Puts the vertices of all cavities onto the surface for as long as it lives.
class CavitiesOnSurface {
public:
    CavitiesOnSurface(Mesh& mesh, const std::vector<MeshComponent>& pieces, const SurfaceProjector& project)
        : mesh_(mesh) {
        std::vector<Vec3> points;
        for (VertexId v = 0; v < mesh.vertices.size(); ++v) {
            if (pieces[mesh.components[v]].volume >= 0.0) continue;
            moved_.emplace_back(v, mesh.vertices[v]);
            points.push_back(mesh.vertices[v]);
        }
        put_on_surface(points, project);
        for (std::size_t i = 0; i < points.size(); ++i) mesh_.vertices[moved_[i].first] = points[i];
    }
    ~CavitiesOnSurface() {
        for (const auto& [v, place] : moved_) mesh_.vertices[v] = place;
    }
    CavitiesOnSurface(const CavitiesOnSurface&) = delete;
    CavitiesOnSurface& operator=(const CavitiesOnSurface&) = delete;

private:
    Mesh& mesh_;
    std::vector<std::pair<VertexId, Vec3>> moved_;
};

// The boxes of the pieces, and one vertex of each.
struct Extents {
    std::vector<Box> boxes;
    std::vector<Vec3> points;

    Extents(const Mesh& mesh, std::size_t pieces) : boxes(pieces), points(pieces) {
        for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
            boxes[mesh.components[v]].include(mesh.vertices[v]);
            points[mesh.components[v]] = mesh.vertices[v];
        }
    }
};

// Looks for outer pieces that lie within dropped cavities.
class Islands {
public:
    Islands(const Mesh& mesh, const std::vector<MeshComponent>& pieces)
        : mesh_(mesh), pieces_(pieces), extents_(mesh, pieces.size()) {}

    std::vector<std::uint32_t> within(const std::vector<bool>& dropped) const {
        std::vector<std::uint32_t> islands;
        for (std::uint32_t p = 0; p < pieces_.size(); ++p)
            if (pieces_[p].volume > 0.0 && is_within_any(p, dropped)) islands.push_back(p);
        return islands;
    }

private:
    bool is_within_any(std::uint32_t piece, const std::vector<bool>& dropped) const {
        for (std::uint32_t p = 0; p < pieces_.size(); ++p)
            if (dropped[p] && pieces_[piece].volume < -pieces_[p].volume &&
                extents_.boxes[p].squared_distance(extents_.points[piece]) == 0.0 &&
                surrounds(p, extents_.points[piece]))
                return true;
        return false;
    }

    bool surrounds(std::uint32_t wall, const Vec3& point) const {
        double angle = 0.0;
        for (const Triangle& t : mesh_.triangles)
            if (mesh_.components[t[0]] == wall) angle += solid_angle(point, mesh_, t);
        return is_all_round(angle);
    }

    const Mesh& mesh_;
    const std::vector<MeshComponent>& pieces_;
    Extents extents_;
};

}  // namespace

double solid_angle(const Vec3& from, const Mesh& mesh, const Triangle& triangle) {
    const Vec3 a = mesh.vertices[triangle[0]] - from;
    const Vec3 b = mesh.vertices[triangle[1]] - from;
    const Vec3 c = mesh.vertices[triangle[2]] - from;
    const double la = norm(a);
    const double lb = norm(b);
    const double lc = norm(c);
    return 2.0 *
           elementary::atan2(dot(a, cross(b, c)), la * lb * lc + dot(a, b) * lc + dot(b, c) * la + dot(c, a) * lb);
}

DroppedPieces drop_small_cavities(Mesh& zero_set, double least_volume, const SurfaceProjector& project, Mesh* walls) {
    const std::vector<MeshComponent> pieces = label_components(zero_set);
    std::vector<bool> dropped(pieces.size());
    DroppedPieces result;
    {
        const CavitiesOnSurface settled(zero_set, pieces, project);
        const std::vector<MeshComponent> measured = measure_components(zero_set, zero_set.components);
        for (std::size_t p = 0; p < pieces.size(); ++p) {
            dropped[p] = pieces[p].volume < 0.0 && std::abs(measured[p].volume) < least_volume;
            if (dropped[p]) ++result.cavities;
        }
    }
    if (result.cavities == 0) return result;
    const std::vector<std::uint32_t> islands = Islands(zero_set, pieces).within(dropped);
    for (const std::uint32_t p : islands) dropped[p] = true;
    result.islands = islands.size();
    if (walls != nullptr) {
        *walls = zero_set;
        keep_components(*walls, dropped);
    }
    std::vector<bool> keep = dropped;
    keep.flip();
    keep_components(zero_set, keep);
    return result;
}

std::size_t drop_tiny_pieces(Mesh& zero_set, double diameter) {
    const std::vector<MeshComponent> pieces = label_components(zero_set);
    std::vector<Vec3> centres(pieces.size());
    for (std::size_t v = 0; v < zero_set.vertices.size(); ++v) centres[zero_set.components[v]] += zero_set.vertices[v];
    for (std::size_t p = 0; p < pieces.size(); ++p)
        centres[p] = (1.0 / static_cast<double>(pieces[p].vertices)) * centres[p];
    std::vector<bool> keep(pieces.size());
    const double squared_radius = 0.25 * diameter * diameter;
    for (std::size_t v = 0; v < zero_set.vertices.size(); ++v) {
        const std::uint32_t p = zero_set.components[v];
        keep[p] = keep[p] || squared_norm(zero_set.vertices[v] - centres[p]) >= squared_radius;
    }
    if (!keep.empty() && pieces.front().volume > 0.0) keep.front() = true;
    const auto dropped = static_cast<std::size_t>(std::count(keep.begin(), keep.end(), false));
    if (dropped > 0) keep_components(zero_set, keep);
    return dropped;
}

}  // namespace meniscus
