// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "pipeline/even_mesh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "meniscus/errors.h"
#include "meniscus/measures.h"
#include "meniscus/mesh_quality.h"
#include "meniscus/structure.h"
#include "meniscus/surface.h"
#include "project/surface_projector.h"
#include "support/arrangements.h"
#include "support/mesh_checks.h"

namespace meniscus::testing {
namespace {

// Necks narrower than half an edge: left to itself, the remesher gives up whole balls behind them.
TEST(EvenMesh, KeepsBulgesBehindNarrowNecks) {
    const Atoms atoms = spheres_with_narrow_necks();
    const AccessibleSurface accessible(atoms, 1.4);
    const double area = measure(atoms).totals.ses_area;
    const SurfaceProjector project = surface_projector(accessible, nullptr, 0.25, Curvatures::LeftOut);
    const Surface grid = compute_surface(atoms, {.method = Method::Direct, .spacing = 0.25});
    Mesh zero_set;
    zero_set.vertices = grid.mesh.vertices;
    zero_set.triangles = grid.mesh.triangles;
    const auto deviation_of = [&](Mesh even, double edge) {
        expect_closed_manifold(even);
        for (const Vec3& p : even.vertices) even.normals.push_back(to_small(accessible.nearest(p).normal));
        return std::abs(corrected_on_surface(even, edge, project).area / area - 1.0);
    };
    double worst_alone = 0.0;
    for (const double edge : {1.7, 1.8, 1.9, 2.0, 2.1, 2.2}) {
        const RemeshOptions wanted{.edge = edge};
        const Mesh even = make_even(zero_set, wanted, project).mesh;
        EXPECT_LT(deviation_of(even, edge), 6e-3) << edge;
        const MeshQuality quality = measure_quality(even);
        EXPECT_GT(quality.smallest_angles.min, 20.0) << edge;
        EXPECT_GT(quality.edges.p5, 0.55 * edge) << edge;
        EXPECT_LT(quality.edges.p95, 1.5 * edge) << edge;
        worst_alone = std::max(worst_alone, deviation_of(remesh(zero_set, wanted, project), edge));
    }
    EXPECT_GT(worst_alone, 0.2);
}

TEST(EvenMesh, FirstLengthIsTakenWhereItIsGoodEnough) {
    const Atoms atoms = two_spheres(2.5);
    const AccessibleSurface accessible(atoms, 1.4);
    const SurfaceProjector project = surface_projector(accessible, nullptr, 0.5, Curvatures::LeftOut);
    Mesh zero_set;
    const Surface grid = compute_surface(atoms, {.method = Method::Direct});
    zero_set.vertices = grid.mesh.vertices;
    zero_set.triangles = grid.mesh.triangles;
    const RemeshOptions wanted{.edge = 1.0};
    EXPECT_EQ(make_even(zero_set, wanted, project).mesh.vertices, remesh(zero_set, wanted, project).vertices);
}

// Spheres of 1.7 Å with creases between all of them leave no room for triangles of 4 Å; mending what the try gives took
// minutes where it ended at all.
TEST(EvenMesh, RefusesEdgesThatAreLongerThanFoldsEverywhere) {
    const Atoms atoms = read_structure(MENISCUS_EXAMPLES "/1ubq.pdb", {}).atoms;
    const auto with_edge = [&](double edge) {
        return compute_surface(atoms, {.surface = SurfaceKind::Vdw, .remesh = {.edge = edge}});
    };
    try {
        with_edge(4.0);
        ADD_FAILURE() << "not refused";
    } catch (const UsageError& error) {
        EXPECT_EQ(std::string(error.what()).rfind("edge 4: ", 0), 0U) << error.what();
    }
    EXPECT_GT(with_edge(1.0).mesh.vertices.size(), 1000U);
}

}  // namespace
}  // namespace meniscus::testing
