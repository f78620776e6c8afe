// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What has changed about a mesh, and the numbers that its vertices and triangles have afterwards.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "meniscus/mesh.h"

namespace meniscus {

/// What changed about a mesh.
struct MeshChanges {
    std::size_t with_new = 0;  ///< vertices with those that were added at the end of the list
    /// Where a vertex was removed, and the one from the end of the list that took its number.
    std::vector<std::pair<VertexId, VertexId>> refilled;
    std::size_t left = 0;         ///< vertices after that
    bool was_tangled = false;     ///< the mesh passed through itself somewhere, and may do so still
    std::vector<Vec3> crumpled;   ///< where it was crumpled: on each of the triangles that SliverOptions count there
    std::vector<VertexId> moved;  ///< with those that were added; by their new numbers, rising
    /// Triangles that are others now, or whose vertices moved; rising.
    std::vector<std::uint32_t> triangles;
    bool gave_up = false;             ///< after most_hard_tries
    bool dropped_components = false;  ///< others have new numbers

    bool any() const { return left != with_new || !moved.empty(); }
};

/// Applies the renumbering to an array with one entry per vertex. Entries of added ones are still to be set.
template <class T>
void renumber_entries(const MeshChanges& changes, std::vector<T>& entries) {
    if (entries.empty()) return;
    entries.resize(changes.with_new);
    for (const auto& [hole, from] : changes.refilled) entries[hole] = entries[from];
    entries.resize(changes.left);
}

/// What has changed so far, while new vertices and triangles are at the end of the lists and removed ones still there.
struct PendingChanges {
    std::vector<VertexId> moved;           ///< and new ones
    std::vector<VertexId> holes;           ///< removed vertices
    std::vector<std::uint32_t> removed;    ///< triangles
    std::vector<std::uint32_t> triangles;  ///< that have changed, or vertices of theirs
    bool dropped_components = false;
};

/// Vertices and triangles from the end take the places of removed ones; the mesh's positions, normals and components
/// follow.
MeshChanges close_holes(Mesh& mesh, PendingChanges pending);

}  // namespace meniscus
