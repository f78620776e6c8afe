// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion: how much of the sky the vertices of a mesh see.
#pragma once

#include <atomic>
#include <span>
#include <vector>

#include "meniscus/mesh.h"
#include "render/ray_scene.h"

namespace meniscus {

/// The share of the sky over a vertex that the mesh leaves open, worked out when it is first asked for.
///
/// The sky is a fixed set of directions, weighted by the cosine to the normal. What blocks one counts less the farther
/// it is away, and nothing beyond `reach`. The result depends on the vertex alone.
class SkyLight {
public:
    /// Of the surface, from which the sky is seen.
    enum class Side { Solvent, Molecule };

    /// Directions over the whole sphere; a vertex sees half of them.
    static constexpr std::size_t kDirections = 200;

    /// scene, mesh   must outlive this; the mesh has normals
    /// reach         Å
    SkyLight(const RayScene& scene, const Mesh& mesh, double reach, Side side = Side::Solvent,
             std::size_t directions = kDirections);

    /// Takes the shares as they are, one per vertex, instead of working them out.
    void take(std::span<const float> shares);

    /// 0 (all blocked) to 1 (all open). May be called from several threads at once.
    /// cost     a ray for half of the directions the first time
    float at(VertexId vertex) const;

private:
    float open_share(VertexId vertex) const;

    const RayScene& scene_;
    const Mesh& mesh_;
    double reach_;
    double sign_;  // of normals
    std::vector<Vec3> directions_;
    mutable std::vector<std::atomic<float>> known_;  // negative: not yet
};

}  // namespace meniscus
