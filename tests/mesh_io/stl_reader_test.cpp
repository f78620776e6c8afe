// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_io/stl_reader.h"

#include "small_files.h"

namespace meniscus::testing {
namespace {

const std::string kFacets =
    "facet normal 0 0 1\n outer loop\n  vertex 0 0 0\n  vertex 1 0 0\n  vertex 1 1 0\n endloop\nendfacet\n"
    "facet normal nan nan nan\nouter loop\nvertex -0.0 0 0\nvertex 1 1 0\nvertex 0 1 0\nendloop\nendfacet\n";

std::string binary_stl(std::uint32_t count, const std::string& header = "made by hand") {
    std::string bytes = header;
    bytes.resize(80);
    bytes += bytes_of<std::uint32_t>({count});
    for (const Triangle& t : kSquareFan) {
        bytes += bytes_of<float>({0, 0, 1});
        for (const VertexId v : t)
            bytes += bytes_of<float>({static_cast<float>(kSquare[v].x), static_cast<float>(kSquare[v].y), 0});
        bytes += std::string(2, '\0');
    }
    return bytes;
}

TEST(StlReader, TextMergesCorners) {
    expect_square(mesh_of("solid a square\n" + kFacets + "endsolid a square\n", "a.stl"));
    expect_square(mesh_of("solid\n" + kFacets + "endsolid\nsolid nothing\nendsolid nothing\n", "a.stl"));
}

TEST(StlReader, BinaryIsToldByItsSize) {
    expect_square(mesh_of(binary_stl(2), "a.stl"));
    expect_square(mesh_of(binary_stl(2, "solid all the same"), "a.stl"));
}

TEST(StlReader, SaysWhereWhatIsWrong) {
    expect_error(binary_stl(3), "a.stl", "a.stl:byte 84: the header says 3 triangles, but 100 bytes follow");
    expect_error(binary_stl(0xffffffffU), "a.stl", "the header says 4294967295 triangles");
    expect_error("", "a.stl", "a.stl:byte 0: the file ends where the number of triangles should be");
    std::string with_nan = binary_stl(2);
    with_nan.replace(96, 4, bytes_of<float>({std::numeric_limits<float>::quiet_NaN()}));
    expect_error(with_nan, "a.stl", "a.stl:byte 100: the coordinate before it is not a finite number");
    expect_error("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 x\n", "a.stl", "a.stl:4:12: a z coordinate: 'x'");
    expect_error("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nendloop\n", "a.stl",
                 "a.stl:5:1: 'endloop' where vertex should be");
    expect_error("solid a\n" + kFacets, "a.stl", "the file ends where endsolid should be");
}

}  // namespace
}  // namespace meniscus::testing
