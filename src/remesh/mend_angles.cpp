// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "remesh/mend_angles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

namespace meniscus {
namespace {

constexpr double kEnough = 0.8660254;  // cosine of 30 degrees
constexpr int kRounds = 12;
constexpr double kGain = 1e-6;  // of the cosine: less is not worth a change

// Places tried for a vertex: on rings round it, in parts of the target length.
constexpr std::array<double, 3> kRings{0.05, 0.15, 0.3};
constexpr int kPerRing = 8;

class Mending {
public:
    Mending(WorkingMesh& mesh, const SurfaceProjector& project) : mesh_(mesh), project_(project) {}

    bool round() {
        bool changed = false;
        for (HalfEdge h = 0; h < mesh_.edges.half_edge_slots(); h += 3)
            if (mesh_.edges.has(h) && mesh_.badness(h) > kEnough) changed = mend(h) || changed;
        return changed;
    }

private:
    bool mend(HalfEdge triangle) {
        const std::array<HalfEdge, 3> sides{triangle, next(triangle), previous(triangle)};
        for (const HalfEdge h : sides) {
            const WorkingMesh::Flip flip = mesh_.try_flip(h, WorkingMesh::Facing::AsBefore);
            if (!flip.allowed || flip.after > flip.before - kGain) continue;
            mesh_.edges.flip(h);
            return true;
        }
        const double before = mesh_.badness(triangle);
        for (const HalfEdge h : sides)
            if (mesh_.collapse(h, before - kGain)) return true;
        const std::array<VertexId, 3> corners{mesh_.edges.origin(triangle), mesh_.edges.target(triangle),
                                              mesh_.edges.opposite(triangle)};
        bool moved = false;
        for (const VertexId v : corners) moved = move(v) || moved;
        return moved || split_longest(sides);
    }

    // Halves the longest side, unless that leaves a triangle as bad as before.
    bool split_longest(const std::array<HalfEdge, 3>& sides) {
        const HalfEdge longest = *std::max_element(sides.begin(), sides.end(), [this](HalfEdge a, HalfEdge b) {
            return mesh_.squared_length(a) < mesh_.squared_length(b);
        });
        const double before = mesh_.badness(longest);
        for (const VertexId v : {mesh_.edges.origin(longest), mesh_.edges.target(longest)})
            if (mesh_.holds[v] != Hold::Free) return false;
        const bool faced_out =
            mesh_.faces_out(mesh_.edges.origin(longest), mesh_.edges.target(longest), mesh_.edges.opposite(longest));
        const VertexId middle = mesh_.split(longest);
        project_({&mesh_.points[middle], 1});
        move(middle);
        if (mesh_.worst_round(middle) < before - kGain && (!faced_out || mesh_.all_face_out_round(middle))) return true;
        mesh_.edges.collapse(mesh_.edges.leaving(middle));  // back into the old end
        return false;
    }

    // Takes the place round a vertex whose triangles are best.
    bool move(VertexId v) {
        if (mesh_.holds[v] != Hold::Free) return false;
        const double before = mesh_.worst_round(v);
        SurfacePoint best = mesh_.points[v];
        double least = before;
        for (const SurfacePoint& place : places_round(v)) {
            mesh_.points[v] = place;
            const double worst = mesh_.worst_round(v);
            if (worst >= least || !mesh_.all_face_out_round(v)) continue;
            least = worst;
            best = place;
        }
        mesh_.points[v] = best;
        return least < before - kGain;
    }

    const std::vector<SurfacePoint>& places_round(VertexId v) {
        const SurfacePoint& centre = mesh_.points[v];
        const Vec3 axis = std::abs(centre.normal.x) < 0.6 ? Vec3{1.0, 0.0, 0.0} : Vec3{0.0, 1.0, 0.0};
        const Vec3 u = normalised(cross(centre.normal, axis));
        const Vec3 w = cross(centre.normal, u);
        places_.clear();
        for (const double ring : kRings)
            for (int k = 0; k < kPerRing; ++k) {
                const double angle = 2.0 * std::numbers::pi * k / kPerRing;
                const double step = ring * mesh_.targets[v];
                places_.push_back(centre);
                places_.back().position += step * (std::cos(angle) * u + std::sin(angle) * w);
            }
        project_(places_);
        return places_;
    }

    WorkingMesh& mesh_;
    const SurfaceProjector& project_;
    std::vector<SurfacePoint> places_;
};

}  // namespace

void mend_angles(WorkingMesh& mesh, const SurfaceProjector& project) {
    Mending mending(mesh, project);
    for (int round = 0; round < kRounds && mending.round(); ++round) continue;
}

}  // namespace meniscus
