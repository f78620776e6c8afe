// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Text in pictures, in a font that is part of the program. The only pair of files that names FreeType.
#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "meniscus/picture.h"

namespace meniscus {

/// Where a line of text begins: left end and baseline, pixels from the picture's upper left corner.
struct TextPlace {
    double x = 0.0;
    double y = 0.0;
};

/// DejaVu Sans in one size. Text is UTF-8, from left to right, one glyph per character; what is no character is shown
/// as U+FFFD, characters that the font lacks as its empty box.
class Font {
public:
    /// size     of the em square, pixels
    /// throws   std::runtime_error if FreeType is not installed or does not work
    explicit Font(double size);

    double size() const { return size_; }

    /// From the beginning of a text to where the next would follow, pixels.
    double width(std::string_view text) const;

    /// The text, or as much of its beginning as fits with an ellipsis.
    std::string fitted(std::string_view text, double width) const;

    /// Draws over what is there; what lies outside the picture is left out.
    void draw(Picture& picture, const TextPlace& place, std::string_view text, const Colour& colour) const;

private:
    struct Handles;

    double advance(char32_t code) const;

    double size_;
    std::shared_ptr<Handles> handles_;
};

/// The characters of UTF-8 text; U+FFFD for bytes that are no UTF-8 and for control characters.
std::u32string characters_of(std::string_view text);

/// A colour over another, of which it covers a share; both may be transparent.
Colour blended(const Colour& below, const Colour& colour, double share);

}  // namespace meniscus
