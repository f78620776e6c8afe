// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Curvatures and areas at the vertices of whole surfaces against the exact ones.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "geometry/accessible_surface.h"
#include "meniscus/structure.h"
#include "meniscus/surface.h"
#include "support/directions.h"
#include "support/test_data.h"

namespace meniscus::testing {
namespace {

// A few spheres, and a probe that gives them wide toroidal and reentrant patches.
struct CurvedSpheres {
    Atoms atoms;
    double probe = 1.4;
};
const CurvedSpheres kTwo{{{{0, 0, 0}, {1.9, 0.8, 1.2}}, {1.7, 1.7}}, 1.4};
const CurvedSpheres kThree{{{{0, 0, 0}, {3.6, 0.1, 0.2}, {1.7, 3.2, -0.1}}, {2.0, 1.9, 1.8}}, 3.0};

// Whether all that is within `margin` of a point belongs to the same patch.
bool is_away_from_borders(const AccessibleSurface& exact, const Vec3& p, double margin) {
    const NearestFeature at = exact.nearest(p);
    for (const Vec3& direction : directions_around()) {
        const NearestFeature beside = exact.nearest(p + margin * normalised(direction));
        if (beside.patch != at.patch || (at.patch == PatchKind::Contact && beside.atom != at.atom)) return false;
    }
    return true;
}

// Largest errors of the vertices' curvatures on one kind of patch.
struct CurvatureErrors {
    int count = 0;
    double mean = 0.0;
    double gaussian = 0.0;
    double shape_index = 0.0;

    void add(const Mesh& mesh, std::size_t v, const NearestFeature& exact) {
        const PrincipalCurvatures k = principal_curvatures(exact.mean_curvature, exact.gaussian_curvature);
        ++count;
        mean = std::max(mean, std::abs(mesh.mean_curvatures[v] - k.mean()));
        gaussian = std::max(gaussian, std::abs(mesh.gaussian_curvatures[v] - k.gaussian()));
        shape_index = std::max(shape_index, std::abs(mesh.shape_indices[v] - k.shape_index()));
    }
};

// By kind of patch, more than 0.5 Å away from where curvatures jump.
std::array<CurvatureErrors, 3> curvature_errors(const CurvedSpheres& arrangement, double spacing) {
    const Surface surface = compute_surface(arrangement.atoms, {.probe = arrangement.probe, .spacing = spacing});
    const AccessibleSurface exact(arrangement.atoms, arrangement.probe);
    std::array<CurvatureErrors, 3> errors;
    for (std::size_t v = 0; v < surface.mesh.vertices.size(); ++v) {
        const Vec3& p = surface.mesh.vertices[v];
        if (!is_away_from_borders(exact, p, 0.5)) continue;
        const NearestFeature at = exact.nearest(p);
        errors[static_cast<std::size_t>(at.patch)].add(surface.mesh, v, at);
    }
    return errors;
}

double median(std::vector<double>& values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

TEST(VertexCurvatures, OfTheFlowAreExactAwayFromBordersWithSecondOrder) {
    for (const CurvedSpheres& arrangement : {kTwo, kThree}) {
        const std::array<CurvatureErrors, 3> coarse = curvature_errors(arrangement, 0.25);
        const std::array<CurvatureErrors, 3> fine = curvature_errors(arrangement, 0.125);
        for (std::size_t patch = 0; patch < arrangement.atoms.size(); ++patch) {
            SCOPED_TRACE(patch);
            EXPECT_GT(coarse[patch].count, 5);
            EXPECT_LT(coarse[patch].mean, 0.015);
            EXPECT_LT(coarse[patch].gaussian, 0.025);
            EXPECT_LT(coarse[patch].shape_index, 0.2);
            EXPECT_GT(std::log2(coarse[patch].mean / fine[patch].mean), 1.8);
            EXPECT_GT(std::log2(coarse[patch].gaussian / fine[patch].gaussian), 1.8);
        }
    }
}

TEST(VertexCurvatures, OfTheExactDistanceAreThoseOfThePatches) {
    for (const CurvedSpheres& arrangement : {kTwo, kThree}) {
        const Surface surface =
            compute_surface(arrangement.atoms, {.method = Method::Direct, .probe = arrangement.probe, .spacing = 0.3});
        const AccessibleSurface exact(arrangement.atoms, arrangement.probe);
        for (std::size_t v = 0; v < surface.mesh.vertices.size(); ++v) {
            const NearestFeature at = exact.nearest(surface.mesh.vertices[v]);
            const PrincipalCurvatures k =
                principal_curvatures(at.mean_curvature, at.gaussian_curvature).capped(1 / 0.3);
            EXPECT_NEAR(surface.mesh.mean_curvatures[v], k.mean(), 1e-6);
            EXPECT_NEAR(surface.mesh.gaussian_curvatures[v], k.gaussian(), 1e-5);
            EXPECT_NEAR(surface.mesh.shape_indices[v], k.shape_index(), 1e-5);
        }
    }
}

TEST(VertexCurvatures, AreFiniteAndCappedAtCusps) {
    const CurvedSpheres arrangements[] = {
        {{{{0, 0, 0}, {5.0, 0.3, 0.1}}, {1.7, 1.7}}, 1.4},                   // a spindle torus
        {{{{0, 0, 0}, {2, 0, 0}, {1, 1.8, 0}}, {1.5, 1.5, 1.5}}, 0.0},       // a ridge between bare spheres
        {{{{0, 0, 0}, {5.8, 0, 0}, {2.9, 4.9, 0}}, {1.5, 1.5, 1.5}}, 1.4}};  // probes that meet between three atoms
    for (const auto& [atoms, probe] : arrangements)
        for (const Method method : {Method::Flow, Method::Direct, Method::Gaussian}) {
            const double spacing = 0.3;
            const Mesh mesh = compute_surface(atoms, {.method = method, .probe = probe, .spacing = spacing}).mesh;
            ASSERT_EQ(mesh.shape_indices.size(), mesh.vertices.size());
            for (std::size_t v = 0; v < mesh.vertices.size(); ++v) {
                EXPECT_LE(std::abs(mesh.mean_curvatures[v]), 1.0001 / spacing);
                EXPECT_LE(std::abs(mesh.gaussian_curvatures[v]), 1.0001 / (spacing * spacing));
                EXPECT_LE(std::abs(mesh.shape_indices[v]), 1.0F);
            }
        }
}

TEST(VertexAreas, OfASurfaceSumToItsArea) {
    for (const Method method : {Method::Flow, Method::Direct, Method::Gaussian}) {
        const Surface surface = compute_surface(kThree.atoms, {.method = method});
        const std::vector<float>& areas = surface.mesh.areas;
        ASSERT_EQ(areas.size(), surface.mesh.vertices.size());
        EXPECT_NEAR(std::accumulate(areas.begin(), areas.end(), 0.0) / surface.measures.area, 1.0, 1e-6);
    }
}

TEST(VertexCurvatures, OnContactPatchesOfCrambinAreWithinOnePercent) {
    MENISCUS_NEED_TEST_DATA();
    const Structure structure = read_structure((*test_data() / "structures/1crn.pdb").string(), {});
    const Surface surface = compute_surface(structure.atoms, {.spacing = 0.25});
    const AccessibleSurface exact(structure.atoms, 1.4);
    std::vector<double> errors;
    for (std::size_t v = 0; v < surface.mesh.vertices.size(); ++v) {
        if (surface.mesh.patches[v] != PatchKind::Contact) continue;
        const double h = exact.nearest(surface.mesh.vertices[v]).mean_curvature;
        errors.push_back(std::abs(surface.mesh.mean_curvatures[v] / h - 1.0));
    }
    ASSERT_GT(errors.size(), 10000U);
    EXPECT_LE(median(errors), 0.01);
}

}  // namespace
}  // namespace meniscus::testing
