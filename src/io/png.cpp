// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "io/png.h"

#include <png.h>

#include <algorithm>
#include <stdexcept>

#include "io/atomic_file.h"
#include "meniscus/errors.h"
#include "meniscus/write.h"

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

}  // namespace

std::string encode_png(const Picture& picture) {
    check(picture);
    const bool opaque = is_opaque(picture);
    const std::vector<std::uint8_t> bytes = packed_channels(picture, opaque);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(picture.width);
    image.height = static_cast<png_uint_32>(picture.height);
    image.format = opaque ? PNG_FORMAT_RGB : PNG_FORMAT_RGBA;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::string content(size, '\0');
    if (png_image_write_to_memory(&image, content.data(), &size, 0, bytes.data(), 0, nullptr) == 0)
        throw std::runtime_error(std::string("PNG: ") + image.message);
    content.resize(size);
    return content;
}

void write_picture(const std::string& path, const Picture& picture) {
    const std::string content = encode_png(picture);
    AtomicFile file(path);
    file.write(content);
    file.commit();
}

}  // namespace meniscus
