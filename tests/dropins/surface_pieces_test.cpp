// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "dropins/surface_pieces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "meniscus/surface.h"

namespace meniscus::dropins {
namespace {

/// A hollow cube of spheres, and a single one beside it: an outer piece, a cavity, a small outer piece.
Atoms hollow_cube_and_ball() {
    Atoms atoms;
    for (int x = 0; x < 5; ++x)
        for (int y = 0; y < 5; ++y)
            for (int z = 0; z < 5; ++z) {
                const auto inside = [](int i) { return i > 0 && i < 4; };
                if (inside(x) && inside(y) && inside(z)) continue;
                atoms.centres.push_back({2.4 * x, 2.4 * y, 2.4 * z});
                atoms.radii.push_back(1.7);
            }
    atoms.centres.push_back({30.0, 0.0, 0.0});
    atoms.radii.push_back(1.5);
    return atoms;
}

TEST(SurfacePieces, EveryPieceOfTheMeshFindsItsExactComponent) {
    const Atoms atoms = hollow_cube_and_ball();
    const Measures exact = measure(atoms, {.probe = 1.4, .patches = true});
    SurfaceOptions options;
    options.method = Method::Direct;
    const Surface surface = compute_surface(atoms, options);
    ASSERT_EQ(exact.components.size(), 3U);
    ASSERT_EQ(surface.measures.components.size(), 3U);
    const std::vector<std::uint32_t> matches = match_components(surface.mesh, surface.measures, exact.components);
    EXPECT_EQ(matches, (std::vector<std::uint32_t>{0, 1, 2}));
    std::size_t vertices = 0;
    for (std::uint32_t c = 0; c < 3; ++c) {
        const Mesh piece = piece_of(surface.mesh, c);
        const MeshMeasures measured = measure_mesh(piece);
        vertices += piece.vertices.size();
        EXPECT_TRUE(measured.closed);
        EXPECT_NEAR(measured.area, exact.components[c].ses_area, 0.03 * exact.components[c].ses_area);
    }
    EXPECT_EQ(vertices, surface.mesh.vertices.size());
}

TEST(SurfacePieces, SharesOfAtomsSumToTheComponentsAndToTheAtoms) {
    const Measures exact = measure(hollow_cube_and_ball(), {.probe = 1.4, .patches = true});
    std::vector<double> per_atom(exact.atoms.size(), 0.0);
    for (std::uint32_t c = 0; c < exact.components.size(); ++c) {
        double ses = 0.0;
        double sas = 0.0;
        const std::vector<AtomShare> shares = shares_of_atoms(exact, c);
        for (std::size_t i = 0; i < shares.size(); ++i) {
            ses += shares[i].ses;
            sas += shares[i].sas;
            per_atom[i] += shares[i].ses;
        }
        EXPECT_NEAR(ses, exact.components[c].ses_area, 1e-9 * ses);
        EXPECT_NEAR(sas, exact.components[c].sas_area, 1e-9 * sas);
    }
    for (std::size_t i = 0; i < per_atom.size(); ++i) EXPECT_NEAR(per_atom[i], exact.atoms[i].ses_area(), 1e-9);
}

TEST(SurfacePieces, ACavityIsPreferredAmongThePiecesThatAtomsTouch) {
    const Measures exact = measure(hollow_cube_and_ball(), {.probe = 1.4, .patches = true});
    const std::vector<std::uint32_t>& lining = exact.components[1].atoms;
    ASSERT_EQ(exact.components[1].kind, ComponentKind::Cavity);
    const std::vector<std::uint32_t> corner{0};
    const std::vector<std::uint32_t> ball{98};
    const std::vector<std::uint32_t> both{0, 98};
    const std::vector<std::uint32_t> two{lining[0], lining[1]};
    EXPECT_EQ(component_touching(exact.components, two), 1U);
    EXPECT_EQ(component_touching(exact.components, corner), 0U);
    EXPECT_EQ(component_touching(exact.components, ball), 2U);
    EXPECT_EQ(component_touching(exact.components, both), kNone);
}

}  // namespace
}  // namespace meniscus::dropins
