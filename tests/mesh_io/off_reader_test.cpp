// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_io/off_reader.h"

#include "small_files.h"

namespace meniscus::testing {
namespace {

TEST(OffReader, PolygonsBecomeFans) {
    expect_square(mesh_of("OFF\n4 1 4\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n", "a.off"));
}

TEST(OffReader, CommentsColoursNormalsAndCountsBesideTheKeyword) {
    expect_square(
        mesh_of("# made by hand\r\nCOFF 4 2 0\r\n\r\n0 0 0 255 0 0 255\r\n1 0 0 1 1 1 1 # here\r\n"
                "1 1 0 0 0 0 0\r\n0 1 0 0 0 0 0\r\n3 0 1 2 255 0 0\r\n3 0 2 3\r\n",
                "a.OFF"));
    expect_square(mesh_of("NOFF\n4 1\n0 0 0 0 0 1\n1 0 0 0 0 1\n1 1 0 0 0 1\n0 1 0 0 0 1\n4 0 1 2 3", "a.off"));
}

TEST(OffReader, SaysWhereWhatIsWrong) {
    EXPECT_EQ(mesh_error_of("PLY\n", "a.off"),
              "a.off:1:1: the file does not begin with OFF, COFF or NOFF; give it the suffix of its format");
    expect_error("OFF\n3 1 0\n0 0 0\n1 0 nan\n", "a.off", "a.off:4:5: a z coordinate: 'nan' is not a finite number");
    expect_error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n", "a.off", "a.off:6:7: a corner names vertex 3");
    expect_error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n", "a.off", "a.off:6:7: a corner: '-1'");
    expect_error("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n", "a.off", "fewer than three corners");
    expect_error("OFF\n3 1 0\n0 0 0\n1 0 0\n", "a.off", "a.off:5:1: the file ends where an x coordinate should be");
    expect_error("OFF\n99999999999 1 0\n0 0 0\n", "a.off", "do not fit into this file");
    expect_error("OFF\n0 0 0\n7\n", "a.off", "a.off:3:1: '7' after the last face");
    expect_error("", "a.off", "a.off:1:1: the file ends where OFF should be");
}

}  // namespace
}  // namespace meniscus::testing
