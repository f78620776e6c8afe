// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>
#include <zlib.h>

#include "volume/readers.h"
#include "volume_files.h"

namespace meniscus::testing {
namespace {

// As APBS 3.4.1 writes it.
const std::string kDx =
    "# Data from APBS 3.4.1\n# \n# POTENTIAL (kT/e)\n# \n"
    "object 1 class gridpositions counts 2 1 3\n"
    "origin -8.000000e+00 1.500000e+00 0.000000e+00\n"
    "delta 5.000000e-01 0.000000e+00 0.000000e+00\n"
    "delta 0.000000e+00 2.500000e-01 0.000000e+00\n"
    "delta 0.000000e+00 0.000000e+00 1.000000e+00\n"
    "object 2 class gridconnections counts 2 1 3\n"
    "object 3 class array type double rank 0 items 6         data follows\n"
    "1.270420e-01 -2.000000e+00 3.000000e+00 \n4.000000e+00 5.000000e+00 6.000000e+00 \n"
    "attribute \"dep\" string \"positions\"\n"
    "object \"regular positions regular connections\"         class field\n"
    "component \"positions\" value 1\ncomponent \"connections\" value 2\ncomponent \"data\" value 3\n";

std::string with(const std::string& old, const std::string& text) {
    std::string content = kDx;
    return content.replace(content.find(old), old.size(), text);
}

std::string complaint_with(const std::string& old, const std::string& text) {
    return complaint(with(old, text), "a.dx");
}

TEST(ReadDx, ReadsWhatApbsWrites) {
    const Volume volume = read_content(kDx, "a.dx");
    EXPECT_EQ(volume.grid, (VolumeGrid{{2, 1, 3}, {-8.0, 1.5, 0.0}, {0.5, 0.25, 1.0}}));
    EXPECT_EQ(volume.values, (std::vector<float>{0.127042F, -2, 3, 4, 5, 6}));
    EXPECT_EQ(volume.grid.index(1, 0, 1), 4U);
    EXPECT_EQ(volume.grid.node(1, 0, 2), (Vec3{-7.5, 1.5, 2.0}));
}

TEST(ReadDx, TakesOtherArrangements) {
    const std::vector<float> expected = read_content(kDx, "a.dx").values;
    EXPECT_EQ(read_content(with("-2.000000e+00 3.000000e+00 \n", "-2\n# three\n\t+3.0 "), "a.dx").values, expected);
    EXPECT_EQ(read_content(with("type double", "type \"float\""), "a.dx").values, expected);
    EXPECT_EQ(read_content(kDx.substr(0, kDx.find("attribute")), "a.dx").values, expected);
    EXPECT_EQ(read_content(with("object 2 class gridconnections counts 2 1 3\n", ""), "a.dx").values, expected);
    std::string crlf;
    for (const char c : kDx) crlf.append(c == '\n' ? "\r\n" : std::string(1, c));
    EXPECT_EQ(read_content(crlf, "a.dx").values, expected);
}

TEST(ReadDx, ReadsGzippedFilesAndGridsAlone) {
    const ScratchFolder folder;
    const gzFile file = ::gzopen((folder / "a.dx.gz").c_str(), "wb");
    ::gzwrite(file, kDx.data(), static_cast<unsigned>(kDx.size()));
    ::gzclose(file);
    EXPECT_EQ(read_volume(folder / "a.dx.gz").values.size(), 6U);
    write_file(folder / "cut.dx", kDx.substr(0, kDx.find("1.270420")));
    EXPECT_EQ(read_volume_grid(folder / "cut.dx").counts, (std::array<std::size_t, 3>{2, 1, 3}));
}

TEST(ReadDx, NamesThePlaceOfWhatIsWrong) {
    EXPECT_EQ(complaint_with("counts 2 1 3", "counts 2 1"),
              "a.dx:5:40: count along z is missing; the line ends too early");
    EXPECT_EQ(complaint_with("counts 2 1 3", "counts 2 0 3"),
              "a.dx:5:39: count along y '0' is not a number of nodes; correct it");
    EXPECT_EQ(complaint_with("1.500000e+00", "nan"), "a.dx:6:22: origin y 'nan' is not a finite number; correct it");
    EXPECT_EQ(complaint_with("-2.000000e+00", "-2,0"),
              "a.dx:12:14: value '-2,0' is not a number within single precision; correct it");
    EXPECT_EQ(complaint_with("-2.000000e+00", "1e39"),
              "a.dx:12:14: value '1e39' is not a number within single precision; correct it");
    EXPECT_EQ(complaint_with("6.000000e+00 \n", "\n"),
              "a.dx:14:1: the data end after 5 of 6 values; the file is cut off, fetch or write it again");
    EXPECT_EQ(complaint_with("6.000000e+00 \n", "6\n7\n"),
              "a.dx:14:1: more values than the 6 of the grid; correct the counts");
    EXPECT_EQ(complaint_with("items 6", "items 7"), "a.dx:11:47: 7 items for a grid of 6 nodes; correct one of them");
    EXPECT_EQ(complaint_with("data follows", "lsb ieee data follows"),
              "a.dx:11:57: binary data are not supported; write them as text");
    EXPECT_EQ(complaint_with("rank 0", "rank 1"), "a.dx:11:39: data with several values per node; write one (rank 0)");
    EXPECT_EQ(complaint_with("origin", "orgin"),
              "a.dx:6:1: 'orgin' cannot begin a line of an OpenDX header; expected object, origin or delta");
}

TEST(ReadDx, RefusesSkewAndBackwardGrids) {
    EXPECT_EQ(
        complaint_with("delta 5.000000e-01 0.000000e+00", "delta 5.000000e-01 1.000000e-02"),
        "a.dx:7:20: delta y '1.000000e-02' makes a skew grid, which is not supported; steps must be along x, y and "
        "z, in this order");
    EXPECT_EQ(complaint_with("2.500000e-01", "-2.500000e-01"),
              "a.dx:8:20: delta y '-2.500000e-01' is not positive; write the grid with positive steps");
}

TEST(ReadDx, RefusesWhatIsMissing) {
    for (const char* line : {"object 1 ", "origin ", "delta 0.000000e+00 0.000000e+00 1.0"}) {
        const std::size_t begin = kDx.find(line);
        std::string content = kDx;
        content.erase(begin, kDx.find('\n', begin) + 1 - begin);
        EXPECT_NE(complaint(content, "a.dx").find("before them; write"), std::string::npos) << line;
    }
    EXPECT_EQ(complaint("", "a.dx"),
              "a.dx:1:1: the file ends before its data; it is cut off or not an OpenDX grid, fetch or write it again");
    EXPECT_NE(complaint(std::string(5000, 'x'), "a.dx"), "");
}

TEST(ReadDx, AllocatesNothingThatTheFileIsTooShortToHold) {
    const std::string vast = "2000000000 100 1000";
    std::string content = with("gridpositions counts 2 1 3", "gridpositions counts " + vast);
    content.replace(content.find("gridconnections counts 2 1 3"), 28, "gridconnections");
    content.replace(content.find("items 6"), 7, "items 200000000000000");
    EXPECT_NE(complaint(content, "a.dx").find("too short for 200000000000000 values"), std::string::npos);
    EXPECT_NE(complaint_with("counts 2 1 3", "counts 100000000000 100000000000 3"), "");
}

}  // namespace
}  // namespace meniscus::testing
