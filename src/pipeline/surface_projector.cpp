// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/surface_projector.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/local_features.h"
#include "grid/spline_cursor.h"

namespace meniscus {
namespace {

double largest_curvature(PrincipalCurvatures k, double spacing) {
    k = k.capped(1.0 / spacing);
    return std::max(std::abs(k.largest), std::abs(k.smallest));
}

void project_onto_exact(const AccessibleSurface& accessible, double spacing, Curvatures curvatures,
                        std::span<SurfacePoint> points) {
    std::vector<std::size_t> moving(points.size());
    for (std::size_t i = 0; i < moving.size(); ++i) moving[i] = i;
    std::vector<Vec3> places;
    for (int taken = 0; taken <= kStepsToSurface && !moving.empty(); ++taken) {
        places.clear();
        for (const std::size_t i : moving) places.push_back(points[i].position);
        const std::vector<SurfaceStep> steps = steps_to_surface(accessible, places);
        std::vector<std::size_t> left;
        for (std::size_t k = 0; k < moving.size(); ++k) {
            SurfacePoint& point = points[moving[k]];
            const NearestFeature& at = steps[k].feature;
            point.normal = at.normal;
            if (curvatures == Curvatures::FilledIn)
                point.curvature =
                    largest_curvature(principal_curvatures(at.mean_curvature, at.gaussian_curvature), spacing);
            const Vec3 move = steps[k].point - point.position;
            if (!(squared_norm(move) > kOnSurface * kOnSurface) || taken == kStepsToSurface) continue;
            point.position = steps[k].point;
            if (!steps[k].settled) left.push_back(moving[k]);
        }
        moving = std::move(left);
    }
}

// Newton's method leads to the zero set from within about a spacing; points farther off go near it first.
class LevelSetProjector {
public:
    LevelSetProjector(const AccessibleSurface& accessible, const LevelSet& level_set, double spacing,
                      Curvatures curvatures)
        : accessible_(accessible), level_set_(level_set), spacing_(spacing), curvatures_(curvatures) {}

    void operator()(std::span<SurfacePoint> points) const {
        SplineCursor cursor(level_set_.grid(), level_set_.coefficients());
        for (SurfacePoint& point : points)
            if (!land(cursor, point, point.position)) {
                const NearestFeature at = accessible_.nearest(point.position);
                land(cursor, point, point.position - at.signed_distance * at.normal);
            }
    }

private:
    bool land(SplineCursor& cursor, SurfacePoint& point, const Vec3& from) const {
        const bool curved = curvatures_ == Curvatures::FilledIn;
        const auto [place, at] =
            curved ? land_on_zero_set(cursor, from, spacing_) : land_on_zero_set_first_order(cursor, from, spacing_);
        if (!(std::abs(at.value) < kLanded * spacing_) || squared_norm(at.gradient) == 0.0) return false;
        point = {place, normalised(at.gradient),
                 curved ? largest_curvature(at.principal_curvatures(), spacing_) : point.curvature};
        return true;
    }

    static constexpr double kLanded = 1e-3;  // of a spacing

    const AccessibleSurface& accessible_;
    const LevelSet& level_set_;
    double spacing_;
    Curvatures curvatures_;
};

}  // namespace

SurfaceProjector surface_projector(const AccessibleSurface& accessible, const LevelSet* level_set, double spacing,
                                   Curvatures curvatures) {
    if (level_set != nullptr) return LevelSetProjector(accessible, *level_set, spacing, curvatures);
    return [&accessible, spacing, curvatures](std::span<SurfacePoint> points) {
        project_onto_exact(accessible, spacing, curvatures, points);
    };
}

}  // namespace meniscus
