// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "mesh_io/msms_reader.h"

#include "small_files.h"

namespace meniscus::testing {
namespace {

const std::string kVertices =
    "    0.000     0.000     0.000     0.000     0.000     1.000       0       1  2 CA_GLY_1\n"
    "    1.000     0.000     0.000     0.000     0.000     1.000       0       1  2\n"
    "    1.000     1.000     0.000     0.000     0.000     1.000       0       1  2\n"
    "    0.000     1.000     0.000     0.000     0.000     1.000       0       1  2\n";
const std::string kFaces = "     1      2      3  1      1\n     1      3      4  1      1\n";
const std::string kVertexHeader =
    "# MSMS solvent excluded surface vertices for a.xyzr\n#vertex #sphere density probe_r\n    4   1  1.00  1.50\n";
const std::string kFaceHeader =
    "# MSMS solvent excluded surface faces for a.xyzr\n#faces  #sphere density probe_r\n    2   1  1.00  1.50\n";

struct Pair {
    std::string vertices;
    std::string faces;
};

Mesh read_pair(const Pair& pair, const std::string& name = "a.vert") {
    const ScratchFolder folder;
    write_file(folder / "a.vert", pair.vertices);
    write_file(folder / "a.face", pair.faces);
    return read_mesh(folder / name);
}

void expect_pair_error(const Pair& pair, const std::string& part) {
    try {
        read_pair(pair);
        ADD_FAILURE() << "no error: " << part;
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
    }
}

TEST(MsmsReader, WithHeadersAndWithoutByEitherName) {
    for (const char* name : {"a.vert", "a.face"}) {
        expect_square(read_pair({kVertexHeader + kVertices, kFaceHeader + kFaces}, name));
        expect_square(read_pair({kVertices, kFaces}, name));
    }
}

TEST(MsmsReader, NanoShapersHeaderCountsAlone) {
    expect_square(read_pair({"# a\n# b\n4\n" + kVertices, "# a\n# b\n2\n" + kFaces}));
    expect_pair_error({"5\n" + kVertices, kFaces}, "the header says 5, but there are 4");
}

TEST(MsmsReader, SaysWhereWhatIsWrong) {
    expect_pair_error({kVertexHeader + kVertices + kVertices, kFaces}, "the header says 4, but there are 8");
    expect_pair_error({kVertices, kFaceHeader}, "the header says 2, but there are 0");
    expect_pair_error({kVertices, "1 2 5 1 1\n"}, "a.face:1:5: a corner names vertex 5 of 4");
    expect_pair_error({kVertices, "0 1 2 1 1\n"}, "a.face:1:1: a corner names vertex 0 of 4");
    expect_pair_error({kVertices, "1 2\n"}, "a.face:1:4: a face has at least 3 words");
    expect_pair_error({"0 0 inf 0 0 1 0 1 2\n", kFaces}, "a.vert:1:5: 'inf' is not a finite number");
    const ScratchFolder folder;
    write_file(folder / "b.vert", kVertices);
    EXPECT_THROW(read_mesh(folder / "b.vert"), InputError);
}

}  // namespace
}  // namespace meniscus::testing
