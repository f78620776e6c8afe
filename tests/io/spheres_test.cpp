// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "meniscus/errors.h"
#include "meniscus/write.h"
#include "support/scratch_folder.h"
#include "support/small_structures.h"

namespace meniscus {
namespace {

using testing::ScratchFolder;

TEST(Spheres, FourNumbersPerLine) {
    const ScratchFolder folder;
    write_spheres(folder / "a.xyzr", testing::two_atoms());
    EXPECT_EQ(testing::read_file(folder / "a.xyzr"), "1.5 -2.25 0.1 1.7\n1000.001 0 -3 1.52\n");
}

TEST(Spheres, NamesFollowTheRadius) {
    const ScratchFolder folder;
    write_spheres(folder / "a.xyzrn", testing::two_atoms());
    EXPECT_EQ(testing::read_file(folder / "a.xyzrn"),
              "1.5 -2.25 0.1 1.7 1 CA_GLY_-3B_A\n1000.001 0 -3 1.52 1 O5'_HOH_101_A-2\n");
}

TEST(Spheres, NamesAreOneWordAlways) {
    const ScratchFolder folder;
    Structure s = testing::two_atoms();
    s.labels[0].name = " C A";
    s.labels[1].name = "";
    s.residues.clear();
    write_spheres(folder / "a.xyzrn", s);
    EXPECT_EQ(testing::read_file(folder / "a.xyzrn"), "1.5 -2.25 0.1 1.7 1 _C_A_-_0_-\n1000.001 0 -3 1.52 1 -_-_0_-\n");
}

TEST(Spheres, UnknownSuffixesAndBrokenStructuresAreRefused) {
    const ScratchFolder folder;
    EXPECT_THROW(write_spheres(folder / "a.xyz", testing::two_atoms()), UsageError);
    Structure s = testing::two_atoms();
    s.atoms.radii.pop_back();
    EXPECT_THROW(write_spheres(folder / "a.xyzr", s), UsageError);
    EXPECT_THROW(write_spheres(folder / "none/a.xyzr", testing::two_atoms()), OutputError);
    EXPECT_TRUE(folder.listing().empty());
}

}  // namespace
}  // namespace meniscus
