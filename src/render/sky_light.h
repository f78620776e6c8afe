// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion: how much of the sky the vertices of a mesh see.
#pragma once

#include <atomic>
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

    /// scene, mesh   must outlive this; the mesh has normals
    /// reach         Å
    SkyLight(const RayScene& scene, const Mesh& mesh, double reach, Side side = Side::Solvent);

    /// 0 (all blocked) to 1 (all open). May be called from several threads at once.
    /// cost     about 100 rays the first time
    float at(VertexId vertex) const;

private:
    float open_share(VertexId vertex) const;

    const RayScene& scene_;
    const Mesh& mesh_;
    double reach_;
    double sign_;                                    // of normals
    mutable std::vector<std::atomic<float>> known_;  // negative: not yet
};

}  // namespace meniscus
