// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "project/surface_projector.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/parallel.h"
#include "grid/spline_cursor.h"

namespace meniscus {
namespace {

double largest_curvature(PrincipalCurvatures k, double spacing) {
    k = k.capped(1.0 / spacing);
    return std::max(std::abs(k.largest), std::abs(k.smallest));
}

// Steps towards the exact surface end on it, but beside ridges the distance is a lower bound and they fall short: there
// many are taken, all in one place.
class ExactSurfaceProjector {
public:
    ExactSurfaceProjector(const AccessibleSurface& accessible, double spacing, Curvatures curvatures)
        : accessible_(accessible), spacing_(spacing), curvatures_(curvatures) {}

    void operator()(std::span<SurfacePoint> points) const {
        std::vector<Vec3> places;
        places.reserve(points.size());
        for (const SurfacePoint& point : points) places.push_back(point.position);
        const std::vector<SurfaceStep> steps = steps_to_surface(accessible_, places);
        LocalFeatures near(accessible_, kMargin);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const SurfaceStep& step = steps[i];
            Vec3& place = points[i].position;
            fill_in(step.feature, points[i]);
            if (!(squared_norm(step.point - place) > kOnSurface * kOnSurface)) continue;
            place = step.point;
            if (step.settled) continue;
            near.gather(Box{place, place}.grown(kRoom));
            fill_in(walk_to_surface(near, place, 1), points[i]);
        }
    }

private:
    void fill_in(const NearestFeature& at, SurfacePoint& point) const {
        point.normal = at.normal;
        if (curvatures_ == Curvatures::FilledIn)
            point.curvature =
                largest_curvature(principal_curvatures(at.mean_curvature, at.gaussian_curvature), spacing_);
    }

    static constexpr double kMargin = 0.5;  // Å from the surface: one step later points are nearer
    static constexpr double kRoom = 0.3;    // Å that most points walk at most

    const AccessibleSurface& accessible_;
    double spacing_;
    Curvatures curvatures_;
};

// Newton's method leads to the zero set from within about a spacing; points farther off go near it first.
class LevelSetProjector {
public:
    LevelSetProjector(const AccessibleSurface& accessible, const LevelSet& level_set, double spacing,
                      Curvatures curvatures)
        : accessible_(accessible), level_set_(level_set), spacing_(spacing), curvatures_(curvatures) {}

    void operator()(std::span<SurfacePoint> points) const {
        SplineCursor cursor(level_set_.grid(), level_set_.coefficients());
        for (SurfacePoint& point : points)
            if (!project(cursor, point, point.position)) {
                const NearestFeature at = accessible_.nearest(point.position);
                project(cursor, point, point.position - at.signed_distance * at.normal);
            }
    }

private:
    bool project(SplineCursor& cursor, SurfacePoint& point, const Vec3& from) const {
        const bool curved = curvatures_ == Curvatures::FilledIn;
        const auto [place, at] = curved ? project_to_zero_set(cursor, from, spacing_)
                                        : project_to_zero_set_first_order(cursor, from, spacing_);
        if (!(std::abs(at.value) < kOnZeroSet * spacing_) || squared_norm(at.gradient) == 0.0) return false;
        point = {place, normalised(at.gradient),
                 curved ? largest_curvature(at.principal_curvatures(), spacing_) : point.curvature};
        return true;
    }

    static constexpr double kOnZeroSet = 1e-3;  // of a spacing

    const AccessibleSurface& accessible_;
    const LevelSet& level_set_;
    double spacing_;
    Curvatures curvatures_;
};

}  // namespace

NearestFeature walk_to_surface(const LocalFeatures& near, Vec3& point, int taken) {
    return walk_from(near, point, near.nearest(point), taken);
}

NearestFeature walk_from(const LocalFeatures& near, Vec3& point, NearestFeature at, int taken) {
    for (; taken < kStepsToSurface && std::abs(at.signed_distance) > kOnSurface; ++taken) {
        point = point - at.signed_distance * at.normal;
        at = near.nearest(point);
    }
    return at;
}

void put_on_surface(std::span<Vec3> points, const SurfaceProjector& project) {
    constexpr std::size_t kChunk = 512;  // projected at once
    parallel_chunks(points.size(), kChunk, [&](std::size_t begin, std::size_t end) {
        std::vector<SurfacePoint> moved(end - begin);
        for (std::size_t i = begin; i < end; ++i) moved[i - begin].position = points[i];
        project(moved);
        for (std::size_t i = begin; i < end; ++i) points[i] = moved[i - begin].position;
    });
}

SurfaceProjector surface_projector(const AccessibleSurface& accessible, const LevelSet* level_set, double spacing,
                                   Curvatures curvatures) {
    if (level_set != nullptr) return LevelSetProjector(accessible, *level_set, spacing, curvatures);
    return ExactSurfaceProjector(accessible, spacing, curvatures);
}

}  // namespace meniscus
