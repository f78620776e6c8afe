// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/font.h"

#include <ft2build.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>
#include FT_FREETYPE_H

#include "platform/files/loaded_library.h"
#include "render/font_file.h"

namespace meniscus {
namespace {

constexpr char32_t kReplacement = 0xFFFD;
constexpr std::u32string_view kEllipsis = U"…";
constexpr double kUnits = 64.0;  // FreeType's, per pixel

/// The functions of FreeType that are used here, under their names without "FT_". Loaded with the first text, as Embree
/// is with the first picture: few runs draw any.
struct FreeType {
    decltype(&::FT_Init_FreeType) init;
    decltype(&::FT_Done_FreeType) done;
    decltype(&::FT_New_Memory_Face) new_memory_face;
    decltype(&::FT_Done_Face) done_face;
    decltype(&::FT_Set_Char_Size) set_char_size;
    decltype(&::FT_Set_Transform) set_transform;
    decltype(&::FT_Load_Char) load_char;
};

FreeType load_free_type() {
    const std::optional<LoadedLibrary> library = LoadedLibrary::load("libfreetype.so.6");
    if (!library) throw std::runtime_error("text needs FreeType 2 (Debian package libfreetype6); install it");
    FreeType found{};
    MENISCUS_FIND(library, FT_Init_FreeType, found.init);
    MENISCUS_FIND(library, FT_Done_FreeType, found.done);
    MENISCUS_FIND(library, FT_New_Memory_Face, found.new_memory_face);
    MENISCUS_FIND(library, FT_Done_Face, found.done_face);
    MENISCUS_FIND(library, FT_Set_Char_Size, found.set_char_size);
    MENISCUS_FIND(library, FT_Set_Transform, found.set_transform);
    MENISCUS_FIND(library, FT_Load_Char, found.load_char);
    return found;
}

/// throws   std::runtime_error where the library is not installed, and as LoadedLibrary
const FreeType& free_type() {
    static const FreeType functions = load_free_type();
    return functions;
}

/// Bytes of the character that begins with this one; 0 for one that begins none.
std::size_t length_of(unsigned char first) {
    if (first < 0x80) return 1;
    if (first >= 0xC2 && first < 0xE0) return 2;
    if (first >= 0xE0 && first < 0xF0) return 3;
    return first >= 0xF0 && first < 0xF5 ? 4 : 0;
}

/// The character at the beginning of a text, and its bytes; U+FFFD and 1 if there is none.
std::pair<char32_t, std::size_t> first_character(std::string_view text) {
    constexpr std::array<char32_t, 5> kSmallest{0, 0, 0x80, 0x800, 0x10000};
    const std::size_t length = length_of(static_cast<unsigned char>(text.front()));
    if (length == 0 || length > text.size()) return {kReplacement, 1};
    const unsigned char first = static_cast<unsigned char>(text.front());
    char32_t code = length == 1 ? first : first & (0x7FU >> length);
    for (const char c : text.substr(1, length - 1)) {
        const auto byte = static_cast<unsigned char>(c);
        if ((byte & 0xC0U) != 0x80U) return {kReplacement, 1};
        code = (code << 6U) | (byte & 0x3FU);
    }
    const bool surrogate = code >= 0xD800 && code < 0xE000;
    if (code < kSmallest[length] || code > 0x10FFFF || surrogate) return {kReplacement, 1};
    return {code, length};
}

double in_pixels(FT_GlyphSlot glyph) { return static_cast<double>(glyph->linearHoriAdvance) / 65536.0; }

bool is_control(char32_t code) { return code < 0x20 || (code >= 0x7F && code < 0xA0); }

void check(FT_Error error) {
    if (error != 0) throw std::runtime_error("text cannot be drawn: FreeType error " + std::to_string(error));
}

}  // namespace

struct Font::Handles {
    explicit Handles(double size) {
        const FreeType& ft = free_type();
        check(ft.init(&library));
        const FT_Error error = ft.new_memory_face(library, reinterpret_cast<const FT_Byte*>(kFontFile.data()),
                                                  static_cast<FT_Long>(kFontFile.size()), 0, &face);
        if (error != 0) ft.done(library);
        check(error);
        ft.set_char_size(face, std::lround(size * kUnits), 0, 72, 72);
    }
    ~Handles() {
        free_type().done_face(face);
        free_type().done(library);
    }
    Handles(const Handles&) = delete;
    Handles& operator=(const Handles&) = delete;

    /// Loads a glyph as it is without hints, so that text has the same shape and width everywhere.
    /// x   of its origin within a pixel
    FT_GlyphSlot load(char32_t code, double x, FT_Int32 flags) {
        FT_Vector shift{std::lround(x * kUnits), 0};
        free_type().set_transform(face, nullptr, &shift);
        check(free_type().load_char(face, code, FT_LOAD_NO_HINTING | flags));
        return face->glyph;
    }

    FT_Library library = nullptr;
    FT_Face face = nullptr;
};

Font::Font(double size) : size_(size), handles_(std::make_shared<Handles>(size)) {}

double Font::advance(char32_t code) const { return in_pixels(handles_->load(code, 0.0, FT_LOAD_DEFAULT)); }

double Font::width(std::string_view text) const {
    double width = 0.0;
    for (const char32_t code : characters_of(text)) width += advance(code);
    return width;
}

/// Stops at the first character that does not fit: texts may be long.
std::string Font::fitted(std::string_view text, double width) const {
    const double room_beside_ellipsis = width - advance(kEllipsis.front());
    double used = 0.0;
    std::size_t with_ellipsis = 0;  // bytes that would fit beside it
    for (std::size_t i = 0; i < text.size();) {
        const auto [code, length] = first_character(text.substr(i));
        used += advance(is_control(code) ? kReplacement : code);
        if (used > width) return std::string(text.substr(0, with_ellipsis)) + "…";
        i += length;
        if (used <= room_beside_ellipsis) with_ellipsis = i;
    }
    return std::string(text);
}

void Font::draw(Picture& picture, const TextPlace& place, std::string_view text, const Colour& colour) const {
    double x = place.x;
    for (const char32_t code : characters_of(text)) {
        const double whole = std::floor(x);
        const FT_GlyphSlot glyph = handles_->load(code, x - whole, FT_LOAD_RENDER);
        const FT_Bitmap& bitmap = glyph->bitmap;
        const int left = static_cast<int>(whole) + glyph->bitmap_left;
        const int top = static_cast<int>(std::lround(place.y)) - glyph->bitmap_top;
        for (int j = 0; j < static_cast<int>(bitmap.rows); ++j)
            for (int i = 0; i < static_cast<int>(bitmap.width); ++i) {
                if (left + i < 0 || left + i >= picture.width || top + j < 0 || top + j >= picture.height) continue;
                Colour& pixel = picture.pixels[static_cast<std::size_t>(top + j) * picture.width + left + i];
                pixel = blended(pixel, colour, bitmap.buffer[j * bitmap.pitch + i] / 255.0);
            }
        x += in_pixels(glyph);
    }
}

std::u32string characters_of(std::string_view text) {
    std::u32string characters;
    while (!text.empty()) {
        const auto [code, length] = first_character(text);
        characters += is_control(code) ? kReplacement : code;
        text.remove_prefix(length);
    }
    return characters;
}

Colour blended(const Colour& below, const Colour& colour, double share) {
    const double over = share * colour.alpha / 255.0;
    const double under = (1.0 - over) * below.alpha / 255.0;
    const double alpha = over + under;
    if (alpha <= 0.0) return below;
    const auto mix = [&](std::uint8_t a, std::uint8_t b) {
        return static_cast<std::uint8_t>(std::lround((over * a + under * b) / alpha));
    };
    return {mix(colour.red, below.red), mix(colour.green, below.green), mix(colour.blue, below.blue),
            static_cast<std::uint8_t>(std::lround(255.0 * alpha))};
}

}  // namespace meniscus
