// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_io/obj_reader.h"

#include "small_files.h"

namespace meniscus::testing {
namespace {

const std::string kCorners = "v 0 0 0\nv 1 0 0 1.0\nv 1 1 0 0.5 0.5 0.5\nv 0 1 0\n";

TEST(ObjReader, AllWaysToNameCorners) {
    for (const char* face : {"f 1 2 3 4", "f 1/1 2/1 3/1 4/1", "f 1//1 2//1 3//1 4//1", "f 1/1/1 2/1/1 3/1/1 4/1/1",
                             "f -4 -3 -2 -1", "f 1 2 3\nf 1 3 4 # two"})
        expect_square(
            mesh_of("# by hand\nmtllib a.mtl\no a\n" + kCorners + "vt 0 0\nvn 0 0 1\ns off\n" + face + "\n", "a.obj"));
    expect_square(mesh_of("v 0 0 0\r\nv 1 0 0\r\nv 1 1 0\r\nv 0 1 0\r\nf 1 2 3 4\r\n", "a.obj"));
}

TEST(ObjReader, VerticesBetweenFacesAsPyMOLWritesThem) {
    const Mesh mesh = mesh_of("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\nv 0 0 0\nv 1 1 0\nv 0 1 0\nf 4 5 6\n", "a.obj");
    EXPECT_EQ(mesh.vertices.size(), 6U);
    EXPECT_EQ(mesh.triangles, (std::vector<Triangle>{{0, 1, 2}, {3, 4, 5}}));
}

TEST(ObjReader, SaysWhereWhatIsWrong) {
    expect_error(kCorners + "f 1 2 5\n", "a.obj", "a.obj:5:7: corner '5' names a vertex that is not among the 4");
    expect_error(kCorners + "f 1 2 -5\n", "a.obj", "a.obj:5:7: corner '-5'");
    expect_error(kCorners + "f 0 1 2\n", "a.obj", "a.obj:5:3: corner '0' is not the number of a vertex");
    expect_error(kCorners + "f 1 2\n", "a.obj", "fewer than three corners");
    expect_error("v 0 0\n", "a.obj", "a.obj:1:6: coordinate '' is not a finite number");
    expect_error("v 0 0 1e999\n", "a.obj", "a.obj:1:7: coordinate '1e999'");
    expect_error("ATOM 1\n", "a.obj", "a.obj:1:1: 'ATOM' is not a keyword of a mesh in OBJ");
}

}  // namespace
}  // namespace meniscus::testing
