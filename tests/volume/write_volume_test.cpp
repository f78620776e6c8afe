// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "volume/mrc_header.h"
#include "volume/writers.h"
#include "volume_files.h"

namespace meniscus::testing {
namespace {

const VolumeGrid kWrittenGrid{{3, 4, 5}, {-1.25, 0.5, 100.0}, {0.5, 0.25, 2.0}};

Volume example() {
    return volume_of(kWrittenGrid, [](const Vec3& p) { return 0.1 * p.x - std::sqrt(p.y) + 1e-3 * p.z * p.z; });
}

void expect_same(const Volume& a, const Volume& b) {
    EXPECT_EQ(a.grid, b.grid);
    EXPECT_EQ(a.values, b.values);
}

TEST(WriteVolume, IsReadBackAsItWas) {
    const ScratchFolder folder;
    for (const char* name : {"a.dx", "a.mrc"}) {
        write_volume(folder / name, example(), VolumeContent::Distance);
        expect_same(read_volume(folder / name), example());
        EXPECT_EQ(read_volume_grid(folder / name), kWrittenGrid);
    }
}

TEST(WriteVolume, DxHasTheLinesOfApbs) {
    const ScratchFolder folder;
    write_volume(folder / "a.dx", {{{1, 2, 2}, {0, 0.5, -1}, {1, 1, 0.5}}, {1.5F, -2.0F, 0.1F, 1e-9F}},
                 VolumeContent::Distance);
    const std::string text = read_file(folder / "a.dx");
    EXPECT_EQ(text.substr(text.find("# Signed")),
              "# Signed distance to the surface, Angstrom, inside positive\n"
              "object 1 class gridpositions counts 1 2 2\norigin 0 0.5 -1\n"
              "delta 1 0 0\ndelta 0 1 0\ndelta 0 0 0.5\n"
              "object 2 class gridconnections counts 1 2 2\n"
              "object 3 class array type double rank 0 items 4 data follows\n"
              "1.5 -2 0.1\n1e-09\n"
              "attribute \"dep\" string \"positions\"\n"
              "object \"regular positions regular connections\" class field\n"
              "component \"positions\" value 1\ncomponent \"connections\" value 2\ncomponent \"data\" value 3\n");
}

TEST(WriteVolume, MrcHasTheHeaderOfTheStandard) {
    const ScratchFolder folder;
    const Volume volume = example();
    write_volume(folder / "a.mrc", volume, VolumeContent::Distance);
    const std::string bytes = read_file(folder / "a.mrc");
    ASSERT_EQ(bytes.size(), 1024 + 4 * volume.values.size());
    MrcHeader header;
    std::memcpy(&header, bytes.data(), sizeof header);
    EXPECT_EQ(header.n, (std::array<std::int32_t, 3>{3, 4, 5}));
    EXPECT_EQ(header.mode, 2);
    EXPECT_EQ(header.cell, (std::array<float, 3>{1.5F, 1.0F, 10.0F}));
    EXPECT_EQ(header.origin, (std::array<float, 3>{-1.25F, 0.5F, 100.0F}));
    EXPECT_EQ(header.version, 20140);
    EXPECT_EQ(header.least, *std::min_element(volume.values.begin(), volume.values.end()));
    EXPECT_EQ(header.most, *std::max_element(volume.values.begin(), volume.values.end()));
    EXPECT_EQ(header.label_count, 2);
    EXPECT_EQ(std::string(header.labels[1].data(), 59), "Signed distance to the surface, Angstrom, inside positive  ");
    float second = 0.0F;  // along x
    std::memcpy(&second, bytes.data() + 1028, sizeof second);
    EXPECT_EQ(second, volume.values[kWrittenGrid.index(1, 0, 0)]);
}

TEST(WriteVolume, TheHeaderSaysWhatTheValuesMean) {
    EXPECT_EQ(header_lines(VolumeContent::Mask)[1], "Mask: 1 inside, 0 outside");
    EXPECT_NE(header_lines(VolumeContent::Ions)[1].find("accessibility"), std::string::npos);
    EXPECT_NE(header_lines(VolumeContent::Dielectric)[1].find("dielectric"), std::string::npos);
}

TEST(WriteVolume, RefusesWhatItCannotWrite) {
    const ScratchFolder folder;
    Volume volume = example();
    EXPECT_THROW(write_volume(folder / "a.cube", volume, VolumeContent::Mask), UsageError);
    EXPECT_THROW(write_volume(folder / "no/a.dx", volume, VolumeContent::Mask), OutputError);
    EXPECT_THROW(write_volume(folder / "a.vdb", volume, VolumeContent::Mask), UsageError);  // spacings differ
    volume.values.pop_back();
    EXPECT_THROW(write_volume(folder / "a.dx", volume, VolumeContent::Mask), UsageError);
    EXPECT_TRUE(folder.listing().empty());
}

TEST(WriteVolume, VdbIsWrittenWhereOpenVdbIs) {
    const ScratchFolder folder;
    const VolumeGrid grid{{40, 40, 40}, {-10, -10, -10}, {0.5, 0.5, 0.5}};
    const Volume ball = volume_of(grid, [](const Vec3& p) { return 4.0 - norm(p); });
    if (!vdb_supported()) {
        EXPECT_THROW(write_volume(folder / "a.vdb", ball, VolumeContent::Distance), UsageError);
        EXPECT_TRUE(folder.listing().empty());
        GTEST_SKIP() << "this build has no OpenVDB";
    }
    write_volume(folder / "a.vdb", ball, VolumeContent::Distance);
    const std::string bytes = read_file(folder / "a.vdb");
    EXPECT_EQ(bytes.substr(0, 4), " BDV");
    EXPECT_NE(bytes.find("inside negative"), std::string::npos);
    EXPECT_NE(bytes.find("level set"), std::string::npos);
    EXPECT_LT(bytes.size(), sizeof(float) * grid.size());  // sparse
    EXPECT_EQ(folder.listing(), std::vector<std::string>{"a.vdb"});
}

}  // namespace
}  // namespace meniscus::testing
