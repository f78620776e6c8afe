// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/surface_mesh.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>
#include <vector>

#include "core/parallel.h"
#include "geometry/local_features.h"
#include "grid/spline_cursor.h"
#include "measure/vertex_areas.h"
#include "mesh/components.h"
#include "mesh/extract.h"

namespace meniscus {
namespace {

void label_and_choose(Mesh& mesh, Pieces pieces) {
    const std::vector<MeshComponent> components = label_components(mesh);
    if (pieces == Pieces::All) return;
    std::vector<bool> keep(components.size());
    for (std::size_t c = 0; c < keep.size(); ++c) keep[c] = (components[c].volume > 0.0) == (pieces == Pieces::Outer);
    keep_components(mesh, keep);
}

// Moves points onto the exact surface. A step along the distance ends there, but next to ridges the distance is a
// lower bound and a step can fall short: a few are taken.
class ExactProjector {
public:
    explicit ExactProjector(const AccessibleSurface& surface) : surface_(surface), local_(surface, kMargin) {}

    // Moves neighbouring points and fills in their nearest features where they have come to lie.
    void project(std::span<Vec3> points, std::span<NearestFeature> features) {
        Box box;
        for (const Vec3& p : points) box.include(p);
        if (points.size() > 1 && norm(box.high - box.low) > kLargestBox) {
            const std::size_t half = points.size() / 2;
            project(points.first(half), features.first(half));
            return project(points.subspan(half), features.subspan(half));
        }
        box_ = box.grown(kRoom);
        local_.gather(box_);
        nearest_features(local_, points, features);
        for (int step = 0; step < kSteps && move(points, features); ++step) find_where_moved(points, features);
    }

private:
    static constexpr double kLargestBox = 12.0;   // Å, its diagonal; larger groups are split
    static constexpr double kRoom = 0.1;          // Å around a group: most points move less
    static constexpr double kMargin = 0.5;        // Å: points of a mesh are far nearer to the surface than this
    static constexpr double kCloseEnough = 1e-9;  // Å
    static constexpr int kSteps = 3;

    // Moves those that do not lie on the surface yet; returns whether there were any.
    bool move(std::span<Vec3> points, std::span<const NearestFeature> features) {
        moved_.clear();
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!(std::abs(features[i].signed_distance) > kCloseEnough)) continue;
            points[i] = points[i] - features[i].signed_distance * features[i].normal;
            moved_.push_back(i);
        }
        return !moved_.empty();
    }

    void find_where_moved(std::span<const Vec3> points, std::span<NearestFeature> features) {
        const auto left = std::partition(moved_.begin(), moved_.end(),
                                         [&](std::size_t i) { return box_.squared_distance(points[i]) == 0.0; });
        std::for_each(left, moved_.end(), [&](std::size_t i) { features[i] = surface_.nearest(points[i]); });
        moved_.erase(left, moved_.end());
        places_.clear();
        for (const std::size_t i : moved_) places_.push_back(points[i]);
        found_.resize(places_.size());
        nearest_features(local_, places_, found_);
        for (std::size_t k = 0; k < moved_.size(); ++k) features[moved_[k]] = found_[k];
    }

    const AccessibleSurface& surface_;
    LocalFeatures local_;
    Box box_;
    std::vector<std::size_t> moved_;  // of a group, those that the last step moved
    std::vector<Vec3> places_;        // theirs
    std::vector<NearestFeature> found_;
};

DistanceSummary summarise(std::vector<double>& distances) {
    if (distances.empty()) return {};
    DistanceSummary summary;
    for (const double d : distances) summary.mean += d;
    summary.mean /= static_cast<double>(distances.size());
    const auto p99 = distances.begin() + static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(distances.size() - 1));
    std::nth_element(distances.begin(), p99, distances.end());
    summary.p99 = *p99;
    summary.max = *std::max_element(p99, distances.end());
    return summary;
}

// Moves the vertices to where they stay and gives them what is known of the surface there.
class VertexFinisher {
public:
    VertexFinisher(const AccessibleSurface& accessible, const LevelSet* level_set, double spacing, Mesh& mesh)
        : accessible_(accessible),
          level_set_(level_set),
          spacing_(spacing),
          mesh_(mesh),
          distances_(mesh.vertices.size()) {
        const std::size_t n = mesh.vertices.size();
        mesh.normals.resize(n);
        mesh.atoms.resize(n);
        mesh.patches.resize(n);
        mesh.mean_curvatures.resize(n);
        mesh.gaussian_curvatures.resize(n);
        mesh.shape_indices.resize(n);
    }

    // Returns the distances to the exact surface.
    std::vector<double> run() {
        parallel_chunks(mesh_.vertices.size(), kChunk, [&](std::size_t begin, std::size_t end) {
            if (level_set_ != nullptr)
                finish_on_level_set(begin, end);
            else
                finish_on_exact_surface(begin, end);
        });
        return std::move(distances_);
    }

private:
    static constexpr std::size_t kChunk = 1024;  // vertices per task

    std::span<Vec3> vertices(std::size_t begin, std::size_t end) const {
        return std::span(mesh_.vertices).subspan(begin, end - begin);
    }

    void finish_on_level_set(std::size_t begin, std::size_t end) {
        SplineCursor cursor(level_set_->grid(), level_set_->coefficients());
        for (std::size_t v = begin; v < end; ++v) {
            const auto [point, at] = land_on_zero_set(cursor, mesh_.vertices[v], spacing_);
            mesh_.vertices[v] = point;
            mesh_.normals[v] = squared_norm(at.gradient) > 0.0 ? normalised(at.gradient) : Vec3{0.0, 0.0, 1.0};
            set_curvatures(v, at.principal_curvatures());
        }
        const std::vector<NearestFeature> features = nearest_features(accessible_, vertices(begin, end));
        for (std::size_t v = begin; v < end; ++v) label(v, features[v - begin]);
    }

    void finish_on_exact_surface(std::size_t begin, std::size_t end) {
        std::vector<NearestFeature> features(end - begin);
        ExactProjector(accessible_).project(vertices(begin, end), features);
        for (std::size_t v = begin; v < end; ++v) {
            const NearestFeature& at = features[v - begin];
            mesh_.normals[v] = at.normal;
            set_curvatures(v, principal_curvatures(at.mean_curvature, at.gaussian_curvature));
            label(v, at);
        }
    }

    // A grid cannot tell more than 1/spacing, and at cusps of the exact surface there is no limit.
    void set_curvatures(std::size_t v, const PrincipalCurvatures& k) {
        const PrincipalCurvatures capped = k.capped(1.0 / spacing_);
        mesh_.mean_curvatures[v] = static_cast<float>(capped.mean());
        mesh_.gaussian_curvatures[v] = static_cast<float>(capped.gaussian());
        mesh_.shape_indices[v] = static_cast<float>(capped.shape_index());
    }

    void label(std::size_t v, const NearestFeature& feature) {
        mesh_.atoms[v] = feature.atom;
        mesh_.patches[v] = feature.patch;
        distances_[v] = std::abs(feature.signed_distance);
    }

    const AccessibleSurface& accessible_;
    const LevelSet* level_set_;
    double spacing_;
    Mesh& mesh_;
    std::vector<double> distances_;
};

}  // namespace

SurfaceMesh mesh_surface(const AccessibleSurface& accessible, const BlockGrid& grid, std::span<const float> values,
                         const LevelSet* level_set, Pieces pieces) {
    SurfaceMesh result{extract_zero_set(grid, values), {}};
    label_and_choose(result.mesh, pieces);
    std::vector<double> distances = VertexFinisher(accessible, level_set, grid.spacing(), result.mesh).run();
    result.distance = summarise(distances);
    result.mesh.areas = vertex_areas(result.mesh);
    return result;
}

}  // namespace meniscus
