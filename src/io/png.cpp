// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/png.h"

#include <png.h>

#include <algorithm>
#include <array>
#include <csetjmp>
#include <cstring>
#include <stdexcept>
#include <string>
#include <vector>

#include "meniscus/errors.h"

namespace meniscus {
namespace {

bool is_opaque(const Picture& picture) {
    return std::all_of(picture.pixels.begin(), picture.pixels.end(), [](const Colour& c) { return c.alpha == 255; });
}

std::vector<std::uint8_t> packed_channels(const Picture& picture, bool opaque) {
    std::vector<std::uint8_t> bytes;
    bytes.reserve(4 * picture.pixels.size());
    for (const Colour& c : picture.pixels) {
        bytes.insert(bytes.end(), {c.red, c.green, c.blue});
        if (!opaque) bytes.push_back(c.alpha);
    }
    return bytes;
}

void check(const Picture& picture) {
    const bool has_size = picture.width > 0 && picture.height > 0;
    if (!has_size || picture.pixels.size() != static_cast<std::size_t>(picture.width) * picture.height)
        throw UsageError("a picture needs width times height pixels, at least one");
}

// What libpng may at most need for a picture.
std::size_t most_bytes(const Picture& picture, bool opaque) {
    png_image image{};
    image.width = static_cast<png_uint_32>(picture.width);
    image.height = static_cast<png_uint_32>(picture.height);
    image.format = opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
    return PNG_IMAGE_PNG_SIZE_MAX(image);
}

// libpng leaves a function that fails by longjmp(), and its own are C: what it is given allocates nothing, throws
// nothing and has no destructor.
struct PngSink {
    std::string* content;  // with room for all
    std::array<char, 128> message{};
};

void append(png_structp png, png_bytep bytes, std::size_t size) {
    std::string& content = *static_cast<PngSink*>(png_get_io_ptr(png))->content;
    if (size > content.capacity() - content.size()) png_error(png, "more bytes than foreseen");
    content.append(reinterpret_cast<const char*>(bytes), size);
}

void flush(png_structp /*png*/) {}

[[noreturn]] void note_and_leave(png_structp png, png_const_charp message) {
    std::array<char, 128>& noted = static_cast<PngSink*>(png_get_error_ptr(png))->message;
    std::strncpy(noted.data(), message, noted.size() - 1);
    png_longjmp(png, 1);
}

void ignore(png_structp /*png*/, png_const_charp /*warning*/) {}

// False if libpng failed.
bool write_all(png_structp png, png_infop info, const Picture& picture, int colour_type, const std::uint8_t* bytes) {
    // Instead of zlib's default of 6: a twentieth more bytes for a third of the time.
    constexpr int kLevel = 4;
    if (setjmp(png_jmpbuf(png)) != 0) return false;
    png_set_IHDR(png, info, static_cast<png_uint_32>(picture.width), static_cast<png_uint_32>(picture.height), 8,
                 colour_type, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_set_sRGB(png, info, PNG_sRGB_INTENT_PERCEPTUAL);
    png_set_compression_level(png, kLevel);
    png_write_info(png, info);
    const std::size_t row_size = png_get_rowbytes(png, info);
    for (int row = 0; row < picture.height; ++row) png_write_row(png, bytes + static_cast<std::size_t>(row) * row_size);
    png_write_end(png, nullptr);
    return true;
}

}  // namespace

std::string encode_png(const Picture& picture) {
    check(picture);
    const bool opaque = is_opaque(picture);
    const std::vector<std::uint8_t> bytes = packed_channels(picture, opaque);
    std::string content;
    content.reserve(most_bytes(picture, opaque));
    PngSink sink{&content};
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, &sink, note_and_leave, ignore);
    png_infop info = png == nullptr ? nullptr : png_create_info_struct(png);
    if (info != nullptr) png_set_write_fn(png, &sink, append, flush);
    const int colour_type = opaque ? PNG_COLOR_TYPE_RGB : PNG_COLOR_TYPE_RGB_ALPHA;
    const bool done = info != nullptr && write_all(png, info, picture, colour_type, bytes.data());
    png_destroy_write_struct(&png, &info);
    if (!done) throw std::runtime_error(std::string("PNG: ") + sink.message.data());
    return content;
}

}  // namespace meniscus
