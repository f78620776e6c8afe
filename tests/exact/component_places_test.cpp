// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "exact/component_places.h"

#include <gtest/gtest.h>

#include <cmath>

#include "meniscus/measures.h"

namespace meniscus {
namespace {

// A solid with a hole in its middle: the atoms of a cubic lattice but for the centre.
Atoms block_with_a_hole(const Vec3& shift) {
    Atoms atoms;
    for (int i = 0; i < 125; ++i) {
        const int cell[3] = {i % 5 - 2, i / 5 % 5 - 2, i / 25 - 2};
        const Vec3 at{2.2 * cell[0], 2.2 * cell[1], 2.2 * cell[2]};
        if (norm(at) < 2.3) continue;  // the centre and its six neighbours
        atoms.centres.push_back(at + shift);
        atoms.radii.push_back(1.6);
    }
    return atoms;
}

Box box_round(const Atoms& atoms) {
    Box box;
    for (const Vec3& centre : atoms.centres) box.include(centre);
    return box;
}

std::vector<double> signed_volumes(const SesPatches& patches) {
    std::vector<double> volumes(patches.component_count(), 0.0);
    for (const SesPatch& patch : patches.patches()) volumes[patch.component] += patch.ses.volume;
    return volumes;
}

TEST(ComponentPlaces, EachCavityIsInsideItsOwnBlock) {
    Atoms atoms = block_with_a_hole({});
    const Atoms other = block_with_a_hole({30.0, 4.0, -3.0});
    atoms.centres.insert(atoms.centres.end(), other.centres.begin(), other.centres.end());
    atoms.radii.insert(atoms.radii.end(), other.radii.begin(), other.radii.end());
    const AccessibleSurface surface(atoms, 1.4);
    const SesPatches patches(surface, 0);
    const std::vector<double> volumes = signed_volumes(patches);
    ASSERT_EQ(volumes.size(), 4U);
    const std::vector<std::uint32_t> inside_of = nest_components(surface, patches, volumes);
    for (std::uint32_t c = 0; c < 4; ++c) {
        if (volumes[c] > 0.0) {
            EXPECT_EQ(inside_of[c], kNone);
            continue;
        }
        ASSERT_NE(inside_of[c], kNone);
        EXPECT_GT(volumes[inside_of[c]], 0.0);
    }
    EXPECT_NE(patches.component_at({0, 0, 0}), patches.component_at({30.0, 4.0, -3.0}));
}

TEST(ComponentPlaces, OneOuterPieceHoldsAllCavities) {
    const AccessibleSurface surface(block_with_a_hole({}), 1.4);
    const SesPatches patches(surface, 0);
    const std::vector<double> volumes = signed_volumes(patches);
    ASSERT_EQ(volumes.size(), 2U);
    const std::vector<std::uint32_t> inside_of = nest_components(surface, patches, volumes);
    const std::uint32_t outer = volumes[0] > 0.0 ? 0 : 1;
    EXPECT_EQ(inside_of[outer], kNone);
    EXPECT_EQ(inside_of[1 - outer], outer);
}

// Eight atoms at the corners of a cube: the largest empty sphere around its middle touches all of them.
TEST(ComponentPlaces, InscribedSphereTouchesTheAtomsAroundIt) {
    Atoms atoms;
    for (int i = 0; i < 8; ++i) {
        atoms.centres.push_back({i % 2 == 0 ? -2.0 : 2.0, i / 2 % 2 == 0 ? -2.0 : 2.0, i / 4 == 0 ? -2.0 : 2.0});
        atoms.radii.push_back(1.5);
    }
    const AccessibleSurface surface(atoms, 0.8);
    const Vec3 start{0.6, -0.3, 0.4};
    const InscribedSphere sphere = largest_inscribed_sphere(surface, std::span(&start, 1), box_round(atoms));
    EXPECT_NEAR(sphere.radius, std::sqrt(12.0) - 1.5, 1e-4);
    EXPECT_NEAR(norm(sphere.centre), 0.0, 1e-3);
}

// Found by fuzzing: with a probe of radius 0 the search stepped through the wall of a void of 0.004 Å and out of all
// atoms, where gaps grow for ever.
TEST(ComponentPlaces, InscribedSphereOfATinyVoidStaysInIt) {
    const Atoms atoms{{{-1.5, -3, 0}, {-4, -4, -2}, {-0.5, -3, -3}, {-1.5, -0.5, -3}, {-2, 0, 0}},
                      {1.5, 3, 2, 2.5, 1.5}};
    const Measures measures = measure(atoms, {.probe = 0.0});
    ASSERT_EQ(measures.components.size(), 2U);
    const SurfaceComponent& cavity = measures.components[1];
    EXPECT_EQ(cavity.kind, ComponentKind::Cavity);
    EXPECT_GT(cavity.inscribed_radius, 1e-3);
    EXPECT_LT(cavity.inscribed_radius, 5e-3);
    EXPECT_LT(norm(cavity.inscribed_centre - cavity.centre), 0.02);
}

}  // namespace
}  // namespace meniscus
