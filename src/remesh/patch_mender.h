// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Bad triangles of a patch, one by one: the least change that helps.
#pragma once

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "remesh/mend_slivers.h"
#include "remesh/patch.h"
#include "space/box_tree.h"

namespace meniscus {

/// A patch, and what of it may change.
struct MendablePatch {
    Patch patch;
    std::vector<bool> free;  ///< per vertex: triangles round it may change. They lie within `room`, and stay there.
    std::vector<bool> held;  ///< per vertex: it stays where it is, and so do edges to others of its kind
    Box room;
};

class PatchMender {
public:
    PatchMender(MendablePatch part, const SliverOptions& options, const SurfaceProjector& project);

    /// Mends small angles, short edges and triangles that face the wrong way, worst first. Often this untangles them,
    /// too.
    void mend();
    /// Parts triangles that pass through each other; the patch is to be mended again then. False if there are none.
    bool untangle();
    const Patch& patch() const { return patch_; }
    /// How often one change alone was not enough, and many were tried together: they take nearly all of the time.
    std::size_t hard_tries() const { return hard_tries_; }

private:
    using Edge = std::pair<VertexId, VertexId>;
    struct Candidate {
        Patch patch;
        double goodness = 0.0;  ///< of the worst triangle that changed
    };

    struct Limits {
        double needed;  ///< tangents
        double wanted;
        double enough;
        double shortest;  ///< edge, Å
    };

    std::optional<std::size_t> worst_triangle(const std::vector<std::size_t>& stuck) const;
    bool mend_triangle(std::size_t triangle);
    bool part(const std::pair<std::size_t, std::size_t>& crossing);
    /// The corners, and those of all triangles that a candidate changes.
    std::vector<VertexId> touched_by(const Patch& candidate, std::vector<VertexId> corners) const;
    bool try_flips(const Triangle& corners, std::size_t triangle);
    bool try_moves(const Triangle& corners, std::size_t triangle);
    bool try_collapses(const Triangle& corners, std::size_t triangle);
    bool try_together(const Triangle& corners, std::size_t triangle, bool splits);

    std::vector<Edge> edges_round(const Triangle& corners) const;
    bool is_free(const Triangle& corners) const { return free_[corners[0]] && free_[corners[1]] && free_[corners[2]]; }
    bool is_held(const Edge& edge) const { return held_[edge.first] && held_[edge.second]; }
    bool is_along_ridge(const Edge& edge) const;
    bool makes_short_edges(const PatchShape& before, const PatchShape& after) const;
    /// Whether an edge's ends and the corners opposite to it are free.
    bool is_between_free(const Edge& edge) const;
    /// The patch with an edge turned, with the edge's first end in its second, or with a vertex on the edge; nothing
    /// where that may not be.
    std::optional<Patch> flipped(const Edge& edge) const;
    std::optional<Patch> collapsed(const Edge& edge) const;
    std::optional<Patch> split(const Edge& edge);

    /// What a candidate makes of the triangle and all that it changes, if that is allowed, better than before and
    /// `at_least` so good.
    std::optional<double> judge(const Patch& candidate, std::size_t triangle, double at_least) const;
    bool take_if_enough(Patch& candidate, std::size_t triangle);

    void relax(Patch& patch, const std::vector<VertexId>& vertices);
    void move(Patch& patch, VertexId v);
    std::vector<SurfacePoint> places_round(const SurfacePoint& centre, double step) const;

    Patch patch_;
    std::vector<bool> free_;
    std::vector<bool> held_;
    Box room_;
    const SliverOptions& options_;
    const SurfaceProjector& project_;
    Limits limits_;
    std::size_t hard_tries_ = 0;
};

}  // namespace meniscus
