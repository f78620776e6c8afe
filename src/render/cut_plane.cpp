// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/cut_plane.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "meniscus/errors.h"

namespace meniscus {
namespace {

/// Six times the volume within a closed piece, and its centre times that and four.
struct Moments {
    double volume = 0.0;
    Vec3 centre;
};

void add(Moments& moments, const Vec3& a, const Vec3& b, const Vec3& c) {
    const double volume = dot(a, cross(b, c));
    moments.volume += volume;
    moments.centre += volume * (a + b + c);
}

/// Centres of the cavities, by falling volume.
std::vector<Vec3> cavity_centres(const Mesh& mesh) {
    if (mesh.components.size() != mesh.vertices.size() || mesh.vertices.empty()) return {};
    const Vec3 origin = mesh.vertices.front();
    std::vector<Moments> pieces(std::size_t{*std::max_element(mesh.components.begin(), mesh.components.end())} + 1);
    for (const auto& [a, b, c] : mesh.triangles)
        add(pieces[mesh.components[a]], mesh.vertices[a] - origin, mesh.vertices[b] - origin,
            mesh.vertices[c] - origin);
    std::erase_if(pieces, [](const Moments& piece) { return piece.volume >= 0.0; });
    std::stable_sort(pieces.begin(), pieces.end(),
                     [](const Moments& a, const Moments& b) { return a.volume < b.volume; });
    std::vector<Vec3> centres(pieces.size());
    std::transform(pieces.begin(), pieces.end(), centres.begin(),
                   [&](const Moments& piece) { return origin + (0.25 / piece.volume) * piece.centre; });
    return centres;
}

Vec3 centre_of_cavity(const Mesh& mesh, std::size_t number) {
    const std::vector<Vec3> centres = cavity_centres(mesh);
    if (number < 1 || number > centres.size())
        throw UsageError("a picture cannot be cut through cavity " + std::to_string(number) + ": the surface has " +
                         std::to_string(centres.size()));
    return centres[number - 1];
}

Vec3 point_at_depth(const Camera& camera, double depth) { return camera.nearest() - depth * camera.frame().towards; }

Vec3 find_point(const Mesh& mesh, const Cut& cut, const Camera& camera) {
    switch (cut.through) {
        case Cut::Through::Cavity:
            return centre_of_cavity(mesh, cut.cavity);
        case Cut::Through::Depth:
            return point_at_depth(camera, cut.depth);
        case Cut::Through::Point:
            return cut.point;
        case Cut::Through::LargestCavity:
            break;
    }
    const std::vector<Vec3> centres = cavity_centres(mesh);
    return centres.empty() ? point_at_depth(camera, 0.5 * camera.depth_range()) : centres.front();
}

double signed_volume(const Mesh& mesh) {
    Moments all;
    const Vec3 origin = mesh.vertices.empty() ? Vec3{} : mesh.vertices.front();
    for (const auto& [a, b, c] : mesh.triangles)
        add(all, mesh.vertices[a] - origin, mesh.vertices[b] - origin, mesh.vertices[c] - origin);
    return all.volume;
}

/// Edges as pairs of vertices, the smaller first; by the direction in which a triangle runs along them.
std::array<std::vector<std::pair<VertexId, VertexId>>, 2> edges_by_direction(const Mesh& mesh) {
    std::array<std::vector<std::pair<VertexId, VertexId>>, 2> edges;
    for (const auto& [a, b, c] : mesh.triangles)
        for (const auto& [from, to] : {std::pair{a, b}, {b, c}, {c, a}})
            edges[from < to ? 0 : 1].emplace_back(std::minmax(from, to));
    for (auto& list : edges) std::sort(list.begin(), list.end());
    return edges;
}

}  // namespace

HalfSpace find_cut(const Mesh& mesh, const Cut& cut, const Camera& camera) {
    const HalfSpace kept{find_point(mesh, cut, camera), cut.normal.value_or(camera.frame().towards)};
    const double length = norm(kept.normal);
    if (!std::isfinite(length) || length == 0.0 || !std::isfinite(norm(kept.point)))
        throw UsageError("a cut needs a finite place and a normal that is finite and not zero");
    return {kept.point, (1.0 / length) * kept.normal};
}

bool is_body(const Mesh& mesh) {
    if (signed_volume(mesh) <= 0.0) return false;
    const auto [there, back] = edges_by_direction(mesh);
    return there == back;
}

}  // namespace meniscus
