// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <numbers>

#include "meniscus/tables.h"
#include "support/small_molecule.h"

namespace meniscus {
namespace {

using testing::SmallMolecule;

SurfaceComponent cavity_at(const Vec3& centre, double volume) {
    SurfaceComponent cavity;
    cavity.kind = ComponentKind::Cavity;
    cavity.ses_area = 10.0;
    cavity.ses_volume = volume;
    cavity.centre = centre;
    cavity.atoms = {1};
    return cavity;
}

TEST(Cavities, WithoutMeasuresThoseOfTheMeshAreListed) {
    const SmallMolecule molecule;
    const auto listed = list_cavities(molecule.mesh, molecule.structure, {});
    ASSERT_EQ(listed.size(), 1U);
    EXPECT_EQ(listed[0].component, 1U);
    const double r = molecule.structure.atoms.radii[1];
    EXPECT_NEAR(listed[0].volume, 4.0 / 3.0 * std::numbers::pi * r * r * r, 0.4 * r * r * r);
    EXPECT_NEAR(norm(listed[0].centre - molecule.structure.atoms.centres[1]), 0.0, 0.1);
}

TEST(Cavities, ExactOnesFindTheirWallsInTheMesh) {
    const SmallMolecule molecule;
    const std::vector components{cavity_at({500.0, 0.0, 0.0}, 20.0),
                                 cavity_at(molecule.structure.atoms.centres[1] + Vec3{0.2, 0, 0}, 14.0),
                                 SurfaceComponent{}};
    const auto listed = list_cavities(molecule.mesh, molecule.structure, components);
    ASSERT_EQ(listed.size(), 2U);
    EXPECT_EQ(listed[0].volume, 20.0);
    EXPECT_EQ(listed[0].component, kNone) << "nothing of the mesh is there";
    EXPECT_EQ(listed[1].component, 1U);
    EXPECT_EQ(listed[1].lining, "A-2:HOH101");
}

TEST(Cavities, AMeshWithoutComponentsHasNone) {
    SmallMolecule molecule;
    molecule.mesh.components.clear();
    EXPECT_TRUE(list_cavities(molecule.mesh, molecule.structure, {}).empty());
}

}  // namespace
}  // namespace meniscus
