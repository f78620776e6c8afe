// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Triangle meshes of molecular surfaces, and measures of a mesh by itself.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "meniscus/vec3.h"

namespace meniscus {

/// Kinds of patches of the solvent-excluded surface.
enum class PatchKind : std::uint8_t {
    Contact = 0,    ///< on an atom's van der Waals sphere
    Toroidal = 1,   ///< on the torus swept by the probe rolling over two atoms
    Reentrant = 2,  ///< on the sphere of a probe that touches three atoms
};

/// Largest absolute coordinate, Å. Meshes that reach farther are refused, so that products of lengths stay finite.
inline constexpr double kFarthestCoordinate = 1e9;

/// Number of a vertex, from 0. More than 2^32 - 1 vertices or triangles are a LimitError.
using VertexId = std::uint32_t;

/// The corners of a triangle, counter-clockwise seen from the solvent.
using Triangle = std::array<VertexId, 3>;

/// Values at the vertices that do not follow from the surface, such as a potential.
struct VertexValues {
    std::string name;           ///< a word that names no other vertex array of the mesh
    std::vector<float> values;  ///< one per vertex; NaN where there is none
};

/// The name of values that tell which pocket a vertex lies beside: its rank, NaN for none.
inline constexpr const char* kPocketValues = "pocket";

/// A triangle mesh. Every vertex array has one entry per vertex, or none at all.
struct Mesh {
    std::vector<Vec3> vertices;             ///< positions, Å, in the frame of the input
    std::vector<SmallVec3> normals;         ///< unit vectors pointing into the solvent
    std::vector<std::uint32_t> atoms;       ///< index of the nearest atom, in the caller's order
    std::vector<PatchKind> patches;         ///< kind of the nearest patch
    std::vector<std::uint32_t> components;  ///< number of the piece: 0 is the largest outer one, then by falling volume
    std::vector<float> areas{};             ///< a third of the areas of the triangles around the vertex, Å²
    /// Curvatures of the surface itself, not of the triangles; principal curvatures are capped at ±1/spacing.
    std::vector<float> mean_curvatures{};      ///< Å^-1, positive on a sphere
    std::vector<float> gaussian_curvatures{};  ///< Å^-2
    std::vector<float> shape_indices{};        ///< from -1 (cup) to 1 (ball); see PrincipalCurvatures
    std::vector<VertexValues> values{};        ///< more arrays, by name
    std::vector<Triangle> triangles;
};

/// Measures of one connected piece of a mesh.
struct MeshComponent {
    std::size_t vertices = 0;
    std::size_t triangles = 0;
    double area = 0.0;    ///< Å²
    double volume = 0.0;  ///< Å³, signed: negative for the wall of a cavity
};

/// Measures of a mesh alone: plain sums over its flat triangles.
struct MeshMeasures {
    double area = 0.0;                      ///< Å²
    double volume = 0.0;                    ///< Å³, by the divergence theorem; cavities count negative
    bool closed = false;                    ///< every edge has two triangles that run along it in opposite directions
    bool manifold = false;                  ///< no edge or vertex where more than one sheet meets
    std::int64_t euler_characteristic = 0;  ///< vertices - edges + triangles
    double smallest_angle_deg = 0.0;        ///< smallest angle of any triangle, degrees
    double shortest_edge = 0.0;             ///< shortest side of any triangle, Å
    std::vector<MeshComponent> components;  ///< in the order of Mesh::components
};

/// Measures a mesh, piece by piece as Mesh::components numbers them; where that is empty, pieces are found first.
///
/// cost     O(n log n)
MeshMeasures measure_mesh(const Mesh& mesh);

}  // namespace meniscus
