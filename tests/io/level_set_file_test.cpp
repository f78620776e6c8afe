// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/level_set_file.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <random>

#include "meniscus/errors.h"
#include "support/level_sets.h"
#include "support/scratch_folder.h"

namespace meniscus::testing {
namespace {

constexpr std::size_t kBlocksOffset = 24;
constexpr std::size_t kSpacingOffset = 32;
constexpr std::size_t kFirstBlockOffset = 64;

LevelSet ball() {
    return narrow_spline_of(
        0.3, {-3, -3, -3}, {3, 3, 3}, [](const Vec3& p) { return norm(p) - 2.5; }, 0.5);
}

std::string bytes_of_file(const LevelSet& level_set) {
    const ScratchFolder folder;
    write_level_set(folder / "a.mls", level_set);
    return read_file(folder / "a.mls");
}

// What the reader says of some content; empty if it takes it.
std::string complaint(const std::string& content) {
    const ScratchFolder folder;
    write_file(folder / "a.mls", content);
    try {
        read_level_set(folder / "a.mls");
        return "";
    } catch (const InputError& error) {
        return error.what();
    }
}

template <class T>
std::string with(std::string content, std::size_t offset, T value) {
    std::memcpy(content.data() + offset, &value, sizeof value);
    return content;
}

// The same with a checksum that fits.
std::string resealed(std::string content) {
    const std::size_t size = content.size() - 4;
    const auto sum =
        static_cast<std::uint32_t>(::crc32(0, reinterpret_cast<const Bytef*>(content.data()), static_cast<uInt>(size)));
    return with(std::move(content), size, sum);
}

void expect_same(const LevelSet& a, const LevelSet& b) {
    EXPECT_EQ(a.spacing(), b.spacing());
    EXPECT_EQ(a.grid().origin(), b.grid().origin());
    EXPECT_TRUE(std::ranges::equal(a.grid().coords(), b.grid().coords()));
    ASSERT_EQ(a.coefficients().size(), b.coefficients().size());
    EXPECT_EQ(std::memcmp(a.coefficients().data(), b.coefficients().data(), a.coefficients().size_bytes()), 0);
}

TEST(LevelSetFile, ReadsBackBitByBit) {
    const ScratchFolder folder;
    for (const LevelSet& level_set : {ball(), rough_level_set(0.1)}) {
        write_level_set(folder / "a.mls", level_set);
        const LevelSet again = read_level_set(folder / "a.mls");
        expect_same(level_set, again);
        write_level_set(folder / "again.mls", again);
        EXPECT_EQ(read_file(folder / "again.mls"), read_file(folder / "a.mls"));
        for (const Vec3& p : random_points(50, 2.7))
            EXPECT_TRUE(again.value(p) == level_set.value(p) || std::isnan(level_set.value(p)));
    }
    EXPECT_EQ(folder.listing(), (std::vector<std::string>{"a.mls", "again.mls"}));
}

TEST(LevelSetFile, NumbersThatAreNoneComeBackToo) {
    BlockGrid grid(0.1, {1e9, -1.0 / 3.0, 0.0}, {{.z = -5, .y = 1 << 30, .x = 7}});
    NodeField coefficients(kBlockNodes, std::numeric_limits<float>::quiet_NaN());
    coefficients[1] = -0.0F;
    coefficients[2] = std::numeric_limits<float>::denorm_min();
    const LevelSet odd(std::make_shared<const BlockGrid>(std::move(grid)), std::move(coefficients));
    const ScratchFolder folder;
    write_level_set(folder / "a.mls", odd);
    expect_same(odd, read_level_set(folder / "a.mls"));
}

TEST(LevelSetFile, AnEmptyOneIsAValidFile) {
    const LevelSet empty(std::make_shared<const BlockGrid>(0.5, Vec3{}, std::vector<BlockCoord>{}), {});
    EXPECT_EQ(bytes_of_file(empty).size(), 68U);
    EXPECT_EQ(complaint(bytes_of_file(empty)), "");
}

TEST(LevelSetFile, EveryCutIsRefused) {
    const std::string whole = bytes_of_file(ball());
    for (std::size_t size = 0; size < whole.size(); size += size < 80 ? 1 : 9973)
        EXPECT_NE(complaint(whole.substr(0, size)), "") << size;
    EXPECT_NE(complaint(whole.substr(0, whole.size() - 1)).find("is cut off"), std::string::npos);
    EXPECT_NE(complaint(whole + '\0').find("is longer than its header says"), std::string::npos);
}

TEST(LevelSetFile, EveryChangedByteIsRefused) {
    const std::string whole = bytes_of_file(ball());
    std::mt19937 random(1);
    for (std::size_t n = 0; n < 150; ++n) {
        const std::size_t at = n < 80 ? n : random() % whole.size();
        std::string changed = whole;
        changed[at] = static_cast<char>(changed[at] ^ (1 << (n % 8)));
        EXPECT_NE(complaint(changed), "") << at;
    }
}

TEST(LevelSetFile, ForeignFilesAreNamedAsSuch) {
    for (const std::string& content : {std::string("ply\nformat ascii 1.0\n"), std::string("x"), std::string(),
                                       std::string(5000, '\0'), std::string(5000, 'a')})
        EXPECT_NE(complaint(content).find("a.mls: is not a level-set file; "), std::string::npos);
}

TEST(LevelSetFile, EveryComplaintSaysWhatIsWrong) {
    const std::string whole = bytes_of_file(ball());
    const auto expect = [](const std::string& content, const std::string& words) {
        const std::string said = complaint(resealed(content));
        EXPECT_NE(said.find(words), std::string::npos) << said;
        EXPECT_EQ(said.find('\n'), std::string::npos);
    };
    expect(with(whole, 8, std::uint32_t{2}), "has version 2 of the format");
    expect(with(whole, 12, std::uint32_t{0x04030201}), "in another byte order");
    expect(with(whole, 16, std::uint32_t{16}), "has blocks of another size");
    expect(with(whole, kBlocksOffset, std::numeric_limits<std::uint64_t>::max()), "is cut off");
    expect(with(whole, kBlocksOffset, std::uint64_t{1} << 55U), "is cut off");
    expect(with(whole, kSpacingOffset, -0.5), "has a spacing that is not between 1e-9 and 1e9 Å");
    expect(with(whole, kSpacingOffset, 1e-50), "has a spacing");  // found by fuzzing: cells were counted beyond 64 bits
    expect(with(whole, kSpacingOffset, std::numeric_limits<double>::quiet_NaN()), "has a spacing");
    expect(with(whole, kSpacingOffset + 16, std::numeric_limits<double>::infinity()), "has an origin");
    expect(with(whole, kSpacingOffset + 8, -1e10), "has an origin that is farther away than 1e9 Å");
    expect(with(whole, kFirstBlockOffset, std::numeric_limits<std::int32_t>::min()), "too far away");
    expect(with(whole, kFirstBlockOffset + 8, std::int32_t{1000}), "has blocks out of order");
    EXPECT_NE(complaint(with(whole, 100, std::int32_t{9})).find("its checksum does not match"), std::string::npos);
}

TEST(LevelSetFile, WhatCannotBeOpenedIsAnInputError) {
    const ScratchFolder folder;
    EXPECT_THROW(read_level_set(folder / "none.mls"), InputError);
    std::filesystem::create_directory(folder / "sub");
    EXPECT_THROW(read_level_set(folder / "sub"), InputError);
    EXPECT_THROW(write_level_set(folder / "none/a.mls", ball()), OutputError);
    EXPECT_THROW(write_level_set(folder / "sub", ball()), OutputError);
    EXPECT_EQ(folder.listing(), std::vector<std::string>{"sub"});
}

}  // namespace
}  // namespace meniscus::testing
