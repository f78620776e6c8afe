// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A whole flow on a few spheres, from the blocks to the level set, and exact points to judge it by.
#pragma once

#include <algorithm>
#include <cmath>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "band/distance_band.h"
#include "band/surface_blocks.h"
#include "flow/evolution.h"
#include "flow/gaussian_density.h"
#include "meniscus/level_set.h"
#include "support/arrangements.h"
#include "support/sampled_field.h"

namespace meniscus::testing {

inline constexpr std::size_t kNoLimit = 1'000'000;

/// The band of an arrangement, on blocks that also hold its Gaussian starts from any of the C of the tests.
struct FlowProblem {
    FlowProblem(const Atoms& atoms, double probe, double h)
        : surface(atoms, probe),
          margin((FlowOptions{}.half_width + kBandRim) * h),
          grid(std::make_shared<const BlockGrid>(h, origin(h), blocks(h))),
          band(sample_distance(surface, *grid, margin)) {}

    NodeField start(double c) const { return GaussianDensity(surface, c).sample(*grid, margin); }

    EvolutionResult evolve(double c, const FlowOptions& options = {}) const {
        return meniscus::evolve(*grid, {band, start(c)}, options, {});
    }
    LevelSet level_set(const EvolutionResult& result) const { return {grid, result.state.coefficients}; }

    static Vec3 origin(double h) { return 0.3819660 * h * Vec3{1.0, 0.9, 0.8}; }
    std::vector<BlockCoord> blocks(double h) const {
        const Lattice lattice{.spacing = h, .origin = origin(h)};
        std::vector<BlockCoord> all = blocks_near_surface(surface, lattice, margin, kNoLimit);
        for (const double c : {-4.0, -0.2}) {
            const auto more = GaussianDensity(surface, c).blocks_near_surface(lattice, margin, kNoLimit);
            std::vector<BlockCoord> both;
            std::set_union(all.begin(), all.end(), more.begin(), more.end(), std::back_inserter(both));
            all = std::move(both);
        }
        return all;
    }

    AccessibleSurface surface;
    double margin;
    std::shared_ptr<const BlockGrid> grid;
    DistanceBand band;
};

/// Points of the solvent-excluded surface, to 1e-9 Å.
inline std::vector<NearestFeature> features_on_surface(const AccessibleSurface& surface, std::vector<Vec3>& points) {
    std::vector<NearestFeature> features;
    std::vector<Vec3> kept;
    for (Vec3 p : points) {
        NearestFeature at = surface.nearest(p);
        if (std::abs(at.signed_distance) > 1.0) continue;
        for (int step = 0; step < 3; ++step) {
            p = p - at.signed_distance * at.normal;
            at = surface.nearest(p);
        }
        if (std::abs(at.signed_distance) > 1e-9) continue;
        kept.push_back(p);
        features.push_back(at);
    }
    points = std::move(kept);
    return features;
}

struct SurfaceErrors {
    double mean_distance = 0.0;  ///< |Φ|/|∇Φ| at exact points, Å
    double max_distance = 0.0;
    double mean_curvature = 0.0;  ///< |H of the level set - exact H|, Å^-1
    double max_curvature = 0.0;
    int count = 0;
};

/// Of a level set at random points of the exact surface where `counts(feature)`.
template <class Counts>
SurfaceErrors errors_on_surface(const FlowProblem& problem, const LevelSet& level_set, const Atoms& atoms,
                                const Counts& counts) {
    std::vector<Vec3> points = random_points_around(atoms, 6000, 3.0);
    const std::vector<NearestFeature> features = features_on_surface(problem.surface, points);
    SurfaceErrors errors;
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!counts(features[i], points[i])) continue;
        const LevelSetSample at = level_set.sample(points[i]);
        const double distance = std::abs(at.value) / norm(at.gradient);
        const double curvature = std::abs(at.mean_curvature() - features[i].mean_curvature);
        errors.mean_distance += distance;
        errors.max_distance = std::max(errors.max_distance, distance);
        errors.mean_curvature += curvature;
        errors.max_curvature = std::max(errors.max_curvature, curvature);
        ++errors.count;
    }
    errors.mean_distance /= std::max(1, errors.count);
    errors.mean_curvature /= std::max(1, errors.count);
    return errors;
}

inline SurfaceErrors errors_on_surface(const FlowProblem& problem, const LevelSet& level_set, const Atoms& atoms) {
    return errors_on_surface(problem, level_set, atoms, [](const NearestFeature&, const Vec3&) { return true; });
}

}  // namespace meniscus::testing
