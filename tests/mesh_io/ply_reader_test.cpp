// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_io/ply_reader.h"

#include "small_files.h"

namespace meniscus::testing {
namespace {

std::string header(const std::string& format, const std::string& counts = "int") {
    return "ply\nformat " + format +
           " 1.0\ncomment by hand\nobj_info nothing\nelement material 1\nproperty uchar red\n"
           "element vertex 4\nproperty uchar label\nproperty double y\nproperty float x\n"
           "property list uchar short more\nproperty float32 z\nelement face 1\nproperty float quality\n"
           "property list uchar " +
           counts + " vertex_indices\nend_header\n";
}

std::string binary_square(bool turned) {
    std::string bytes = "\x07";
    for (const Vec3& p : kSquare)
        bytes += "\x01" + bytes_of<double>({p.y}, turned) + bytes_of<float>({static_cast<float>(p.x)}, turned) +
                 "\x02" + bytes_of<std::int16_t>({5, 6}, turned) + bytes_of<float>({0.0F}, turned);
    return bytes + bytes_of<float>({0.5F}, turned) + "\x04" + bytes_of<std::int32_t>({0, 1, 2, 3}, turned);
}

TEST(PlyReader, PropertiesOfAnyTypeAndOrderInEveryCoding) {
    expect_square(
        mesh_of(header("ascii") + "7\n1 0 0 2 5 6 0\n1 0 1 0 0\n1 1 1 0 0\n1 1 0 0 0\n0.5 4 0 1 2 3\n", "a.ply"));
    expect_square(mesh_of(header("binary_little_endian") + binary_square(false), "a.ply"));
    expect_square(mesh_of(header("binary_big_endian") + binary_square(true), "a.ply"));
}

const std::string kPlain =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_index\nend_header\n";
const std::string kPoints = "0 0 0\n1 0 0\n0 1 0\n";

TEST(PlyReader, SaysWhereWhatIsWrong) {
    EXPECT_EQ(mesh_of(kPlain + kPoints + "3 0 1 2\n", "a.ply").triangles.size(), 1U);
    expect_error(kPlain + kPoints + "3 0 1 3\n", "a.ply", "a.ply:13:7: a corner of a face names a vertex");
    expect_error(kPlain + kPoints + "3 0 1 -1\n", "a.ply", "a.ply:13:7: a corner of a face");
    expect_error(kPlain + kPoints + "3 0 1 0.5\n", "a.ply", "a.ply:13:7: a corner of a face");
    expect_error(kPlain + kPoints + "2 0 1\n", "a.ply", "fewer than three corners");
    expect_error(kPlain + kPoints + "200 0 1 2\n", "a.ply", "a list of a length that does not fit");
    expect_error(kPlain + kPoints + "3 0 1 2 5\n", "a.ply", "continues after its last element");
    expect_error(kPlain + "0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n", "a.ply", "a.ply:10:5: a coordinate is not a finite");
    expect_error(kPlain + "0 0 x\n1 0 0\n0 1 0\n3 0 1 2\n", "a.ply", "a.ply:10:5: 'x' is not a number");
    expect_error(kPlain + kPoints, "a.ply", "ends where a number should be");
    expect_error("solid a\n", "a.ply", "a.ply:1:1: the file does not begin with ply");
    expect_error("ply\nformat xml 1.0\n", "a.ply", "a.ply:2:8: format 'xml' is unknown");
    expect_error("ply\nformat ascii 1.0\nelement vertex -3\n", "a.ply", "a.ply:3:16: the number of elements '-3'");
    expect_error("ply\nformat ascii 1.0\nproperty float x\n", "a.ply", "a property before the first element");
    expect_error("ply\nformat ascii 1.0\n", "a.ply", "ends within its header");
}

TEST(PlyReader, NumbersThatAFileCannotHoldAreNotBelieved) {
    for (const char* format : {"ascii", "binary_little_endian"}) {
        const std::string start = std::string("ply\nformat ") + format + " 1.0\nelement vertex 99999999999999\n";
        expect_error(start + "property float x\nproperty float y\nproperty float z\nend_header\n1", "a.ply",
                     "do not fit");
        expect_error(start + "end_header\n1", "a.ply", "do not fit");
        expect_error(start + "property float x\nend_header", "a.ply", "do not fit");
    }
}

TEST(PlyReader, BinaryFilesNameTheByte) {
    const std::string whole = header("binary_little_endian") + binary_square(false);
    expect_error(whole.substr(0, whole.size() - 3), "a.ply", "a list of a length that does not fit into this file");
    std::string wrong = whole;
    wrong[whole.size() - 4] = 9;
    expect_error(wrong, "a.ply", "a.ply:byte " + std::to_string(whole.size()) + ": a corner of a face");
}

}  // namespace
}  // namespace meniscus::testing
