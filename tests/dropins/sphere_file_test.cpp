// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "dropins/sphere_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "meniscus/errors.h"
#include "support/scratch_folder.h"

namespace meniscus::dropins {
namespace {

using testing::ScratchFolder;

SphereFile read_spheres(const std::string& text) {
    const ScratchFolder folder;
    std::ofstream(folder / "tmpx1") << text;  // without a suffix, as Biopython names it
    return read_sphere_file(folder / "tmpx1");
}

TEST(SphereFile, NumbersInAnyFormAndWithoutNames) {
    const SphereFile spheres = read_spheres("# a\n\n1.5e+00\t-2  +3 1.400000000000000022e+00\r\n 0 0 0 2.0\n");
    ASSERT_EQ(spheres.atoms.size(), 2U);
    EXPECT_EQ(spheres.atoms.centres[0], (Vec3{1.5, -2.0, 3.0}));
    EXPECT_EQ(spheres.atoms.radii[0], 1.4);
    EXPECT_TRUE(spheres.names.empty());
}

TEST(SphereFile, NamesAreKeptAsTheyAre) {
    const SphereFile spheres =
        read_spheres("0 0 0 1.5 1 A_15_x_ASN_HD22_Blue\n1 0 0 1.5 0 lower\n2 0 0 1.5 bare\n3 0 0 1 1\n");
    EXPECT_EQ(spheres.names, (std::vector<std::string>{"A_15_x_ASN_HD22_Blue", "lower", "bare", "-"}));
    EXPECT_EQ(spheres.collision_only, 1U);
}

TEST(SphereFile, SpheresWithoutARadiusKeepTheirPlace) {
    const SphereFile spheres = read_spheres("0 0 0 0\n1 0 0 1.5\n2 0 0 0.0\n3 0 0 1.2\n");
    EXPECT_EQ(spheres.solid_places(), (std::vector<std::uint32_t>{1, 3}));
    EXPECT_EQ(spheres.solid().centres[1], (Vec3{3.0, 0.0, 0.0}));
    EXPECT_EQ(without_radius(spheres, 1.2).atoms.size(), 3U);
}

TEST(SphereFile, WhatIsNoSphereIsToldWithItsPlace) {
    for (const char* wrong :
         {"", "# none\n", "0 0 0 0\n", "0 0 0\n", "0 0 0 -1\n", "0 0 0 x\n", "0 nan 0 1\n", "0 0 0 1.5x\n"})
        EXPECT_THROW(read_spheres(wrong), InputError) << wrong;
    try {
        read_spheres("0 0 0 1\n0 0  inf 1\n");
        FAIL();
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(":2:6: "), std::string::npos) << error.what();
    }
}

}  // namespace
}  // namespace meniscus::dropins
