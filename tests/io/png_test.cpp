// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/png.h"

#include <gtest/gtest.h>
#include <png.h>

#include <algorithm>
#include <filesystem>

#include "meniscus/errors.h"
#include "meniscus/write.h"
#include "support/scratch_folder.h"

namespace meniscus {
namespace {

using testing::ScratchFolder;

Picture gradient(int width, int height, int least_alpha) {
    Picture picture{width, height};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            picture.pixels.push_back({static_cast<std::uint8_t>(3 * x), static_cast<std::uint8_t>(7 * y),
                                      static_cast<std::uint8_t>(x * y),
                                      static_cast<std::uint8_t>(std::max(least_alpha, 255 - x))});
    return picture;
}

/// Reads RGBA back through libpng; format is what the file says it holds.
Picture decoded(const std::string& content, png_uint_32& format) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_memory(&image, content.data(), content.size()), 0) << image.message;
    format = image.format;
    image.format = PNG_FORMAT_RGBA;
    Picture picture{static_cast<int>(image.width), static_cast<int>(image.height)};
    picture.pixels.resize(std::size_t{image.width} * image.height);
    EXPECT_NE(png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr), 0) << image.message;
    return picture;
}

TEST(Png, EveryPixelReadsBack) {
    const Picture picture = gradient(37, 21, 0);
    png_uint_32 format = 0;
    const Picture read = decoded(encode_png(picture), format);
    EXPECT_EQ(read.width, 37);
    EXPECT_EQ(read.height, 21);
    EXPECT_EQ(read.pixels, picture.pixels);
    EXPECT_NE(format & PNG_FORMAT_FLAG_ALPHA, 0U);
}

TEST(Png, OpaquePicturesHaveNoAlphaChannel) {
    const Picture picture = gradient(5, 4, 255);
    png_uint_32 format = 0;
    EXPECT_EQ(decoded(encode_png(picture), format).pixels, picture.pixels);
    EXPECT_EQ(format & PNG_FORMAT_FLAG_ALPHA, 0U);
}

TEST(Png, PicturesWithoutTheirPixelsAreRefused) {
    EXPECT_THROW(encode_png({}), UsageError);
    EXPECT_THROW(encode_png({2, 2, std::vector<Colour>(3)}), UsageError);
    EXPECT_THROW(encode_png({-1, -4, std::vector<Colour>(4)}), UsageError);
}

TEST(Png, WrittenWholeOrNotAtAll) {
    const ScratchFolder folder;
    write_picture(folder / "a.png", gradient(9, 9, 0));
    png_uint_32 format = 0;
    EXPECT_EQ(decoded(testing::read_file(folder / "a.png"), format).width, 9);
    EXPECT_THROW(write_picture(folder / "none/a.png", gradient(2, 2, 0)), OutputError);
    EXPECT_THROW(write_picture("/dev/full", gradient(2, 2, 0)), OutputError);
    EXPECT_FALSE(std::filesystem::exists(folder / "none"));
}

}  // namespace
}  // namespace meniscus
