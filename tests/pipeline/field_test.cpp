// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/field.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "meniscus/errors.h"

namespace meniscus::testing {
namespace {

constexpr double kRadius = 3.0;
const Atoms kBall{{{0.1, -0.2, 0.3}}, {kRadius}};
const VolumeGrid kGrid{{21, 17, 33}, {-4.9, -4.1, -8.2}, {0.5, 0.55, 0.5}};

// A shell of atoms on a sphere: one outer surface and one cavity.
Atoms wide_shell() {
    Atoms atoms;
    for (int i = 0; i < 90; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / 90;
        const double angle = 2.399963229728653 * i;
        const double r = std::sqrt(1.0 - z * z);
        atoms.centres.push_back({6.5 * r * std::cos(angle), 6.5 * r * std::sin(angle), 6.5 * z});
        atoms.radii.push_back(1.7);
    }
    return atoms;
}

template <class Check>
void at_all_nodes(const Volume& volume, const Check& check) {
    ASSERT_EQ(volume.values.size(), volume.grid.size());
    const auto& [nx, ny, nz] = volume.grid.counts;
    for (std::size_t i = 0; i < nx; ++i)
        for (std::size_t j = 0; j < ny; ++j)
            for (std::size_t k = 0; k < nz; ++k)
                check(volume.grid.node(i, j, k), static_cast<double>(volume.values[volume.grid.index(i, j, k)]));
}

double depth_in_ball(const Vec3& p) { return kRadius - norm(p - kBall.centres[0]); }

double sum(const Volume& volume) {
    double total = 0.0;
    for (const float v : volume.values) total += static_cast<double>(v);
    return total;
}

// Å³ per node
double cell(const VolumeGrid& grid) { return grid.spacing.x * grid.spacing.y * grid.spacing.z; }

TEST(Field, OfTheExactDistanceIsTheDistanceEverywhere) {
    const Surface surface = compute_surface(kBall, {.method = Method::Direct});
    at_all_nodes(surface_field(surface, kGrid),
                 [](const Vec3& p, double value) { EXPECT_NEAR(value, depth_in_ball(p), 1e-5); });
}

TEST(Field, OfAFlowIsTheLevelSetNearItsSurfaceAndADistanceBeyond) {
    const Surface surface = compute_surface(kBall, {.method = Method::Flow});
    at_all_nodes(surface_field(surface, kGrid), [&](const Vec3& p, double value) {
        const double depth = depth_in_ball(p);
        EXPECT_NEAR(value, depth, 0.03);
        if (std::abs(depth) < 0.9) {
            EXPECT_NEAR(value, -surface.level_set->value(p), 1e-5);
        }
        if (std::abs(depth) > 1.6) {
            EXPECT_NEAR(value, depth, 1e-5);
        }
    });
}

TEST(Field, OfAGaussianHasTheSignOfItsSurfaceEverywhere) {
    const Surface surface = compute_surface(kBall, {.method = Method::Gaussian});
    at_all_nodes(surface_field(surface, kGrid), [&](const Vec3& p, double value) {
        const double depth = depth_in_ball(p);
        if (std::abs(depth) > 0.1) {
            EXPECT_EQ(value > 0.0, depth > 0.0);
        }
        if (std::abs(depth) > 2.0) {
            EXPECT_GT(std::abs(value), 1.0);
        }
    });
}

TEST(Field, MaskAndDielectricFollowTheSign) {
    for (const Method method : {Method::Direct, Method::Flow}) {
        const Atoms atoms = wide_shell();
        const Surface surface = compute_surface(atoms, {.method = method});
        const VolumeGrid grid = enclosing_grid(ExactSurface(atoms), 0.7);
        const Volume distance = surface_field(surface, grid);
        const Volume mask = surface_field(surface, grid, {.content = VolumeContent::Mask});
        const Volume epsilon = surface_field(
            surface, grid, {.content = VolumeContent::Dielectric, .inner_dielectric = 4.0, .outer_dielectric = 80.0});
        for (std::size_t n = 0; n < grid.size(); ++n) {
            const bool inside = distance.values[n] > 0.0F;
            EXPECT_EQ(mask.values[n], inside ? 1.0F : 0.0F);
            EXPECT_EQ(epsilon.values[n], inside ? 4.0F : 80.0F);
        }
        EXPECT_NEAR(sum(mask) * cell(grid), surface.measures.volume, 0.02 * surface.measures.volume);
    }
}

TEST(Field, IonsStayAwayFromTheAtoms) {
    const Atoms atoms{{{0, 0, 0}, {4, 0, 0}}, {1.5, 1.0}};
    const Surface surface = compute_surface(atoms);
    at_all_nodes(surface_field(surface, kGrid, {.content = VolumeContent::Ions, .ion_radius = 1.1}),
                 [](const Vec3& p, double value) {
                     const bool free = norm(p) > 2.6 && norm(p - Vec3{4, 0, 0}) > 2.1;
                     EXPECT_EQ(value, free ? 1.0 : 0.0);
                 });
}

TEST(Field, MapsOfApbsAreHalfASpacingBesideTheNodes) {
    const Surface surface = compute_surface(kBall, {.method = Method::Direct});
    const FieldOptions options{.inner_dielectric = 1.0, .outer_dielectric = 80.0, .ion_radius = 0.0};
    const Vec3 halves[] = {{0.25, 0, 0}, {0, 0.275, 0}, {0, 0, 0.25}};
    const ApbsMap maps[] = {ApbsMap::DielectricX, ApbsMap::DielectricY, ApbsMap::DielectricZ};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const Volume map = apbs_map(surface, kGrid, maps[axis], options);
        EXPECT_EQ(map.grid.origin, kGrid.origin + halves[axis]);
        EXPECT_EQ(map.grid.spacing, kGrid.spacing);
        at_all_nodes(map, [](const Vec3& p, double value) { EXPECT_EQ(value, depth_in_ball(p) > 0.0 ? 1.0 : 80.0); });
    }
    const Volume kappa = apbs_map(surface, kGrid, ApbsMap::Kappa, options);
    EXPECT_EQ(kappa.grid, kGrid);
    at_all_nodes(kappa, [](const Vec3& p, double value) { EXPECT_EQ(value, depth_in_ball(p) > 0.0 ? 0.0 : 1.0); });
}

TEST(Field, FilledCavitiesAreInsideInEveryField) {
    const Atoms atoms = wide_shell();
    EXPECT_THROW(enclosing_grid(ExactSurface(), 0.6), std::invalid_argument);
    const VolumeGrid grid = enclosing_grid(ExactSurface(atoms), 0.6);
    for (const Method method : {Method::Direct, Method::Flow}) {
        const Surface open = compute_surface(atoms, {.method = method});
        ASSERT_EQ(open.measures.components.size(), 2U);
        const double volume = -open.measures.components[1].volume;
        const Surface kept = compute_surface(atoms, {.method = method, .fill_cavities = 0.99 * volume});
        EXPECT_EQ(kept.filled.cavities, 0U);
        EXPECT_EQ(surface_field(kept, grid).values, surface_field(open, grid).values);

        const Surface filled = compute_surface(atoms, {.method = method, .fill_cavities = 1.01 * volume});
        EXPECT_EQ(filled.filled.cavities, 1U);
        EXPECT_NEAR(filled.filled.volume, volume, 0.02 * volume);
        EXPECT_EQ(filled.measures.components.size(), 1U);
        // An atom in the middle that reaches to no probe outside leaves the same outer surface, and no cavity.
        Atoms solid = atoms;
        solid.centres.push_back({0, 0, 0});
        solid.radii.push_back(6.4);
        const Volume expected = surface_field(compute_surface(solid, {.method = method}), grid);
        const Volume found = surface_field(filled, grid);
        for (std::size_t n = 0; n < grid.size(); ++n) {
            // Triangles of 0.5 Å cut the creases off, by up to 0.16 Å here.
            EXPECT_NEAR(found.values[n], expected.values[n], 0.2);
            EXPECT_EQ(found.values[n] > 0.0F, expected.values[n] > 0.0F);
        }
        at_all_nodes(surface_field(filled, grid, {.content = VolumeContent::Ions}), [](const Vec3& p, double value) {
            if (norm(p) < 8.5) {
                EXPECT_EQ(value, 0.0);
            }
        });
        const Volume mask = surface_field(filled, grid, {.content = VolumeContent::Mask});
        EXPECT_NEAR(sum(mask) * cell(grid), filled.measures.volume, 0.01 * filled.measures.volume);
    }
}

TEST(Field, CavitiesThatTheMeshLeavesOutStayOutside) {
    const Atoms atoms = wide_shell();
    const Surface outer = compute_surface(atoms, {.pieces = Pieces::Outer, .min_cavity = 1000.0});
    const VolumeGrid middle{{1, 1, 1}, {0, 0, 0}, {1, 1, 1}};
    EXPECT_LT(surface_field(outer, middle).values[0], 0.0F);
}

TEST(Field, DoesNotDependOnTheThreads) {
    const Atoms atoms = wide_shell();
    const Surface surface = compute_surface(atoms);
    EXPECT_EQ(surface_field(surface, kGrid, {.threads = 1}).values,
              surface_field(surface, kGrid, {.threads = 4}).values);
}

TEST(Field, TheUsualGridEnclosesTheAtoms) {
    const Atoms atoms{{{0.3, 0, 0}, {5, 1, -2}}, {1.5, 1.0}};
    const VolumeGrid grid = enclosing_grid(ExactSurface(atoms), 0.5);
    EXPECT_EQ(grid.origin, (Vec3{-3.5, -3.5, -5.0}));
    EXPECT_EQ(grid.counts, (std::array<std::size_t, 3>{24, 16, 18}));
    EXPECT_EQ(grid.spacing, (Vec3{0.5, 0.5, 0.5}));
}

TEST(Field, RefusesWhatMakesNoSenseAndWhatDoesNotFit) {
    const Surface surface = compute_surface(kBall);
    const auto field = [&](const VolumeGrid& grid, const FieldOptions& options = {}) {
        return surface_field(surface, grid, options);
    };
    const double nan = std::numeric_limits<double>::quiet_NaN();
    EXPECT_THROW(field({{0, 1, 1}, {}, {1, 1, 1}}), UsageError);
    EXPECT_THROW(field({{1, 1, 1}, {}, {1, 0, 1}}), UsageError);
    EXPECT_THROW(field({{1, 1, 1}, {nan, 0, 0}, {1, 1, 1}}), UsageError);
    EXPECT_THROW(field(kGrid, {.inner_dielectric = 0.0}), UsageError);
    EXPECT_THROW(field(kGrid, {.ion_radius = -1.0}), UsageError);
    EXPECT_THROW(field(kGrid, {.threads = -1}), UsageError);
    const std::size_t vast = 2'000'000'000;
    EXPECT_THROW(field({{vast, vast, vast}, {}, {1, 1, 1}}), LimitError);
    EXPECT_THROW(refuse_grid_that_would_not_fit({{1000, 1000, 100}, {}, {1, 1, 1}}, 1, {}, 300), LimitError);
    EXPECT_NO_THROW(refuse_grid_that_would_not_fit({{1000, 1000, 100}, {}, {1, 1, 1}}, 1, {}, 400));
}

}  // namespace
}  // namespace meniscus::testing
