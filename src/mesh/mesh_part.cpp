// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/mesh_part.h"

#include <stdexcept>

namespace meniscus {
namespace {

template <class T>
std::vector<T> picked(const std::vector<T>& values, const std::vector<VertexId>& places) {
    std::vector<T> result;
    if (values.empty()) return result;
    result.reserve(places.size());
    for (const VertexId v : places) result.push_back(values[v]);
    return result;
}

// The corners of the triangles, ascending.
std::vector<VertexId> corners_of(const std::vector<Triangle>& triangles, std::size_t vertex_count) {
    std::vector<bool> used(vertex_count, false);
    for (const Triangle& triangle : triangles)
        for (const VertexId v : triangle) used[v] = true;
    std::vector<VertexId> vertices;
    for (std::size_t v = 0; v < vertex_count; ++v)
        if (used[v]) vertices.push_back(static_cast<VertexId>(v));
    return vertices;
}

void number_anew(std::vector<Triangle>& triangles, const std::vector<VertexId>& vertices, std::size_t vertex_count) {
    std::vector<VertexId> number(vertex_count);
    for (std::size_t i = 0; i < vertices.size(); ++i) number[vertices[i]] = static_cast<VertexId>(i);
    for (Triangle& triangle : triangles)
        for (VertexId& v : triangle) v = number[v];
}

template <class Belongs>
MeshPart part_of(const Mesh& mesh, const Belongs& belongs) {
    MeshPart part;
    for (const Triangle& triangle : mesh.triangles)
        if (belongs(triangle)) part.mesh.triangles.push_back(triangle);
    part.vertices = corners_of(part.mesh.triangles, mesh.vertices.size());
    number_anew(part.mesh.triangles, part.vertices, mesh.vertices.size());
    part.mesh.vertices = picked(mesh.vertices, part.vertices);
    part.mesh.normals = picked(mesh.normals, part.vertices);
    part.mesh.atoms = picked(mesh.atoms, part.vertices);
    part.mesh.patches = picked(mesh.patches, part.vertices);
    part.mesh.components = picked(mesh.components, part.vertices);
    part.mesh.areas = picked(mesh.areas, part.vertices);
    part.mesh.mean_curvatures = picked(mesh.mean_curvatures, part.vertices);
    part.mesh.gaussian_curvatures = picked(mesh.gaussian_curvatures, part.vertices);
    part.mesh.shape_indices = picked(mesh.shape_indices, part.vertices);
    for (const VertexValues& array : mesh.values)
        part.mesh.values.push_back({array.name, picked(array.values, part.vertices)});
    return part;
}

}  // namespace

MeshPart part_of_atoms(const Mesh& mesh, const std::vector<bool>& selected) {
    if (mesh.atoms.size() != mesh.vertices.size())
        throw std::invalid_argument("the mesh does not say to which atoms its vertices belong");
    return part_of(mesh, [&](const Triangle& triangle) {
        int count = 0;
        for (const VertexId v : triangle) count += selected.at(mesh.atoms[v]) ? 1 : 0;
        return count >= 2;
    });
}

MeshPart part_of_component(const Mesh& mesh, std::uint32_t component) {
    if (mesh.components.size() != mesh.vertices.size())
        throw std::invalid_argument("the mesh does not say to which components its vertices belong");
    return part_of(mesh, [&](const Triangle& triangle) { return mesh.components[triangle[0]] == component; });
}

}  // namespace meniscus
