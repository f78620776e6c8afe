// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Ambient occlusion: how much of the sky the vertices of a mesh see.
#pragma once

#include <atomic>
#include <cstddef>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "meniscus/mesh.h"
#include "render/ray_scene.h"

namespace meniscus {

/// Rays from the vertices of a mesh to the sky, which is weighted by the cosine to the normal. What blocks a direction
/// counts less the farther it is away, and nothing beyond `reach`.
class SkyRays {
public:
    /// Of the surface, from which the sky is seen.
    enum class Side { Solvent, Molecule };

    /// scene, mesh   must outlive this; the mesh has normals
    /// reach         Å
    SkyRays(const RayScene& scene, const Mesh& mesh, double reach, Side side = Side::Solvent)
        : scene_(scene), mesh_(mesh), reach_(reach), sign_(side == Side::Solvent ? 1.0 : -1.0) {}

    const Mesh& mesh() const { return mesh_; }

    /// The share that is open, 0 to 1, as so many rays tell. Every vertex has directions of its own: what they miss,
    /// those of its neighbours find.
    float open_share(VertexId vertex, std::size_t rays) const;

private:
    const RayScene& scene_;
    const Mesh& mesh_;
    double reach_;
    double sign_;  // of normals
};

/// The share of the sky over a vertex that the mesh leaves open, worked out when it is first asked for: a few rays of
/// each vertex, smoothed over its neighbours. The finer the mesh, the fewer.
class SkyLight {
public:
    /// The mesh has a triangle.
    explicit SkyLight(const SkyRays& rays) : rays_(rays) {}

    /// Takes the shares as they are, one per vertex, instead of working them out. They must outlive this.
    void take(std::span<const float> shares) { given_ = shares; }

    /// 0 (all blocked) to 1 (all open), the same for any number of threads. May be called from several at once.
    /// cost     the first time a dozen or two rays, where neighbours are asked for as well
    float at(VertexId vertex) const {
        if (!given_.empty()) return given_[vertex];
        Prepared* prepared = prepared_.load(std::memory_order_acquire);
        if (prepared == nullptr) prepared = &prepare();
        return smoothed(*prepared, vertex, prepared->rounds);
    }

private:
    // What is made when the light is first needed, which that of a side that nobody sees never is.
    struct Prepared {
        explicit Prepared(const Mesh& mesh);
        std::span<const VertexId> around(VertexId vertex) const;

        std::size_t rounds;                                  // of smoothing
        std::vector<std::size_t> begins;                     // of the neighbours of each vertex
        std::vector<VertexId> neighbours;                    // along the edges of triangles
        std::vector<std::vector<std::atomic<float>>> known;  // shares after so many rounds; negative: not yet
    };

    Prepared& prepare() const;
    float smoothed(Prepared& prepared, VertexId vertex, std::size_t rounds) const;
    float mean_around(Prepared& prepared, VertexId vertex, std::size_t rounds) const;

    SkyRays rays_;
    std::span<const float> given_;
    mutable std::once_flag preparation_;
    mutable std::unique_ptr<Prepared> owned_;
    mutable std::atomic<Prepared*> prepared_{nullptr};
};

}  // namespace meniscus
