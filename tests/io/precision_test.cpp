// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/precision.h"

#include <gtest/gtest.h>

#include "meniscus/errors.h"
#include "meniscus/write.h"
#include "support/scratch_folder.h"
#include "support/shapes.h"

namespace meniscus {
namespace {

TEST(Precision, SingleNearTheOrigin) {
    EXPECT_EQ(precision_needed({}), Precision::Single);
    EXPECT_EQ(precision_needed(testing::tetrahedron()), Precision::Single);
}

TEST(Precision, DoubleWhereFloatsAreCoarserThanTenThousandths) {
    Mesh mesh = testing::tetrahedron();
    mesh.vertices[2].z = 1023.99;
    EXPECT_EQ(precision_needed(mesh), Precision::Single);
    mesh.vertices[2].z = -1024.0;
    EXPECT_EQ(precision_needed(mesh), Precision::Double);
}

TEST(Precision, FormatsOfSinglePrecisionEndWhereItIsTooCoarse) {
    const testing::ScratchFolder folder;
    Mesh mesh = testing::tetrahedron();
    mesh.vertices[2].z = 131071.0;
    for (const char* name : {"a.stl", "a.glb", "a.ply"}) write_mesh(folder / name, mesh);
    mesh.vertices[2].z = -131072.0;
    for (const char* name : {"b.stl", "b.glb"}) EXPECT_THROW(write_mesh(folder / name, mesh), LimitError) << name;
    write_mesh(folder / "b.ply", mesh);
    EXPECT_EQ(folder.listing().size(), 4U);
}

TEST(Precision, DoubleWhereRoundingWouldMergeTwoCorners) {
    Mesh mesh = testing::tetrahedron();
    mesh.vertices[0] = mesh.vertices[1] + Vec3{1e-9, 0, 0};
    EXPECT_EQ(precision_needed(mesh), Precision::Double);
    mesh.vertices[0] = mesh.vertices[1] + Vec3{1e-6, 0, 0};
    EXPECT_EQ(precision_needed(mesh), Precision::Single);
}

TEST(Precision, SidesThatAreKnownToBeLongAreNotLookedAt) {
    Mesh mesh = testing::tetrahedron();
    mesh.vertices[0] = mesh.vertices[1];  // had it been looked at, this would need double precision
    EXPECT_EQ(precision_needed(mesh, 0.0), Precision::Double);
    EXPECT_EQ(precision_needed(mesh, 1e-4), Precision::Double);
    EXPECT_EQ(precision_needed(mesh, 0.1), Precision::Single);
    mesh.vertices[2].z = -1024.0;
    EXPECT_EQ(precision_needed(mesh, 0.1), Precision::Double);
}

TEST(Precision, PointsHaveAsManyDigitsAsTheyNeed) {
    const testing::ScratchFolder folder;
    AtomicFile file(folder / "a.txt");
    write_point(file, {0.1, -2.0, 1.0 / 3.0}, Precision::Single);
    file.write('\n');
    write_point(file, {0.1, -2.0, 1.0 / 3.0}, Precision::Double);
    file.commit();
    EXPECT_EQ(testing::read_file(folder / "a.txt"), "0.1 -2 0.33333334\n0.1 -2 0.3333333333333333");
}

}  // namespace
}  // namespace meniscus
