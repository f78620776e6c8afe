// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <limits>

#include "volume/mrc_header.h"
#include "volume/readers.h"
#include "volume_files.h"

namespace meniscus::testing {
namespace {

// 2 x 3 x 4 values along x, y, z in a frame of its own.
MrcHeader usual_header() {
    MrcHeader header;
    header.n = {2, 3, 4};
    header.m = {2, 3, 4};
    header.cell = {1.0F, 3.0F, 8.0F};
    header.angles = {90, 90, 90};
    header.axes = {1, 2, 3};
    header.origin = {-1.0F, 0.5F, 2.0F};
    header.map = {'M', 'A', 'P', ' '};
    header.machine = {0x44, 0x44, 0, 0};
    return header;
}

template <class T>
std::string bytes_of(const std::vector<T>& values) {
    std::string bytes(values.size() * sizeof(T), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

std::string bytes_of(const MrcHeader& header) { return bytes_of(std::vector<MrcHeader>{header}); }

// Value 100 i + 10 j + k at node (i, j, k), in the order of the file, the axes being what `header` says.
template <class T>
std::string content(const MrcHeader& header) {
    std::vector<T> values;
    for (int s = 0; s < header.n[2]; ++s)
        for (int r = 0; r < header.n[1]; ++r)
            for (int c = 0; c < header.n[0]; ++c) {
                constexpr std::array kFactors{100, 10, 1};
                const int value = c * kFactors[header.axes[0] - 1] + r * kFactors[header.axes[1] - 1] +
                                  s * kFactors[header.axes[2] - 1];
                values.push_back(static_cast<T>(value));
            }
    return bytes_of(header) + bytes_of(values);
}

void expect_numbered(const Volume& volume) {
    ASSERT_EQ(volume.grid.counts, (std::array<std::size_t, 3>{2, 3, 4}));
    for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            for (std::size_t k = 0; k < 4; ++k)
                EXPECT_EQ(volume.values[volume.grid.index(i, j, k)], static_cast<float>(100 * i + 10 * j + k));
}

std::string complaint_of(const MrcHeader& header) { return complaint(content<float>(header), "a.mrc"); }

TEST(ReadMrc, ReadsTheFrameAndTheValues) {
    const Volume volume = read_content(content<float>(usual_header()), "a.mrc");
    EXPECT_EQ(volume.grid, (VolumeGrid{{2, 3, 4}, {-1.0, 0.5, 2.0}, {0.5, 1.0, 2.0}}));
    expect_numbered(volume);
}

TEST(ReadMrc, ReadsAllModes) {
    MrcHeader header = usual_header();
    header.mode = 1;
    expect_numbered(read_content(content<std::int16_t>(header), "a.map"));
    header.mode = 6;
    expect_numbered(read_content(content<std::uint16_t>(header), "a.ccp4"));
    header.mode = 0;
    expect_numbered(read_content(content<std::int8_t>(header), "a.mrc"));
    header.mode = 4;
    EXPECT_EQ(complaint(content<float>(header), "a.mrc"),
              "a.mrc:byte 12 (MODE): mode 4 is not supported; write the map in mode 2 (32-bit numbers)");
}

TEST(ReadMrc, ReadsTheOtherByteOrder) {
    std::string bytes = content<float>(usual_header());
    for (std::size_t i = 0; i < bytes.size(); i += 4)
        if (i != offsetof(MrcHeader, map)) std::reverse(bytes.begin() + i, bytes.begin() + i + 4);
    const Volume volume = read_content(bytes, "a.mrc");
    EXPECT_EQ(volume.grid.origin, (Vec3{-1.0, 0.5, 2.0}));
    expect_numbered(volume);
}

TEST(ReadMrc, ReadsAnyOrderOfTheAxes) {
    std::array<std::int32_t, 3> axes{1, 2, 3};
    do {
        MrcHeader header = usual_header();
        header.axes = axes;
        for (std::size_t along = 0; along < 3; ++along) header.n[along] = usual_header().n[axes[along] - 1];
        const Volume volume = read_content(content<float>(header), "a.mrc");
        EXPECT_EQ(volume.grid.spacing, (Vec3{0.5, 1.0, 2.0}));
        expect_numbered(volume);
    } while (std::next_permutation(axes.begin(), axes.end()));
}

TEST(ReadMrc, TheStartCountsWhereThereIsNoOrigin) {
    MrcHeader header = usual_header();
    header.origin = {};
    header.axes = {3, 2, 1};
    header.n = {4, 3, 2};
    header.start = {-3, 2, 5};
    EXPECT_EQ(read_content(content<float>(header), "a.mrc").grid.origin, (Vec3{2.5, 2.0, -6.0}));
}

TEST(ReadMrc, SkipsTheExtendedHeader) {
    MrcHeader header = usual_header();
    header.extended_size = 160;
    std::string bytes = content<float>(header);
    bytes.insert(sizeof header, 160, 'x');
    expect_numbered(read_content(bytes, "a.mrc"));
    EXPECT_NE(complaint(bytes.substr(0, 1100), "a.mrc"), "");
}

TEST(ReadMrc, NamesTheFieldThatIsWrong) {
    MrcHeader header = usual_header();
    header.angles[1] = 100.5F;
    EXPECT_EQ(complaint_of(header),
              "a.mrc:byte 56 (CELLB beta): 100.5 must be 90 (skew cells are not supported); correct the header");
    header = usual_header();
    header.cell[2] = std::numeric_limits<float>::quiet_NaN();
    EXPECT_EQ(complaint_of(header), "a.mrc:byte 48 (CELLA z): nan must be a positive length; correct the header");
    header = usual_header();
    header.m[0] = 0;
    EXPECT_EQ(complaint_of(header), "a.mrc:byte 28 (MX): 0 must be a positive count; correct the header");
    header = usual_header();
    header.space_group = 401;
    EXPECT_EQ(complaint_of(header), "a.mrc:byte 88 (ISPG): a stack of volumes; write one volume per file");
    header = usual_header();
    header.map = {};
    EXPECT_EQ(complaint_of(header), "a.mrc:byte 208 (MAP): 'MAP ' is missing; this is not an MRC or CCP4 map");
    std::string bytes = content<float>(usual_header());
    bytes.replace(offsetof(MrcHeader, axes) + 8, 4, std::string("\2\0\0\0", 4));
    EXPECT_EQ(complaint(bytes, "a.mrc"),
              "a.mrc:byte 64 (MAPC MAPR MAPS): 1 2 2 are not the axes 1, 2 and 3 in some order; correct them");
    bytes = content<float>(usual_header());
    bytes.replace(1024 + 4 * 5, 4, std::string("\0\0\xc0\x7f", 4));
    EXPECT_EQ(complaint(bytes, "a.mrc"), "a.mrc:byte 1044 (value): is not a finite number; correct it");
}

TEST(ReadMrc, RefusesFilesOfAnotherLength) {
    const std::string bytes = content<float>(usual_header());
    EXPECT_EQ(complaint(bytes.substr(0, 1000), "a.mrc"),
              "a.mrc: is shorter than the 1024 bytes of an MRC header; it is cut off or not such a map");
    EXPECT_NE(complaint(bytes.substr(0, bytes.size() - 1), "a.mrc").find("too short for 2 x 3 x 4"), std::string::npos);
    EXPECT_EQ(complaint(bytes + "x", "a.mrc"), "a.mrc: the file is longer than its header says; write it again");
    MrcHeader vast = usual_header();
    vast.n = {2'000'000'000, 2'000'000'000, 2'000'000'000};
    EXPECT_NE(complaint(bytes_of(vast), "a.mrc").find("too short"), std::string::npos);
}

}  // namespace
}  // namespace meniscus::testing
