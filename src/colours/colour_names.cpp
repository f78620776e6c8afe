// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <charconv>
#include <string>

#include "colours/palettes.h"
#include "meniscus/colours.h"
#include "reading/lower_case.h"

namespace meniscus {
namespace {

struct NamedColour {
    std::string_view name;
    Colour colour;
};

constexpr auto kNamedColours = std::to_array<NamedColour>({
    {"aliceblue", rgb(0xF0F8FF)},
    {"antiquewhite", rgb(0xFAEBD7)},
    {"aqua", rgb(0x00FFFF)},
    {"aquamarine", rgb(0x7FFFD4)},
    {"azure", rgb(0xF0FFFF)},
    {"beige", rgb(0xF5F5DC)},
    {"bisque", rgb(0xFFE4C4)},
    {"black", rgb(0x000000)},
    {"blanchedalmond", rgb(0xFFEBCD)},
    {"blue", rgb(0x0000FF)},
    {"blueviolet", rgb(0x8A2BE2)},
    {"brown", rgb(0xA52A2A)},
    {"burlywood", rgb(0xDEB887)},
    {"cadetblue", rgb(0x5F9EA0)},
    {"chartreuse", rgb(0x7FFF00)},
    {"chocolate", rgb(0xD2691E)},
    {"coral", rgb(0xFF7F50)},
    {"cornflowerblue", rgb(0x6495ED)},
    {"cornsilk", rgb(0xFFF8DC)},
    {"crimson", rgb(0xDC143C)},
    {"cyan", rgb(0x00FFFF)},
    {"darkblue", rgb(0x00008B)},
    {"darkcyan", rgb(0x008B8B)},
    {"darkgoldenrod", rgb(0xB8860B)},
    {"darkgray", rgb(0xA9A9A9)},
    {"darkgreen", rgb(0x006400)},
    {"darkgrey", rgb(0xA9A9A9)},
    {"darkkhaki", rgb(0xBDB76B)},
    {"darkmagenta", rgb(0x8B008B)},
    {"darkolivegreen", rgb(0x556B2F)},
    {"darkorange", rgb(0xFF8C00)},
    {"darkorchid", rgb(0x9932CC)},
    {"darkred", rgb(0x8B0000)},
    {"darksalmon", rgb(0xE9967A)},
    {"darkseagreen", rgb(0x8FBC8F)},
    {"darkslateblue", rgb(0x483D8B)},
    {"darkslategray", rgb(0x2F4F4F)},
    {"darkslategrey", rgb(0x2F4F4F)},
    {"darkturquoise", rgb(0x00CED1)},
    {"darkviolet", rgb(0x9400D3)},
    {"deeppink", rgb(0xFF1493)},
    {"deepskyblue", rgb(0x00BFFF)},
    {"dimgray", rgb(0x696969)},
    {"dimgrey", rgb(0x696969)},
    {"dodgerblue", rgb(0x1E90FF)},
    {"firebrick", rgb(0xB22222)},
    {"floralwhite", rgb(0xFFFAF0)},
    {"forestgreen", rgb(0x228B22)},
    {"fuchsia", rgb(0xFF00FF)},
    {"gainsboro", rgb(0xDCDCDC)},
    {"ghostwhite", rgb(0xF8F8FF)},
    {"gold", rgb(0xFFD700)},
    {"goldenrod", rgb(0xDAA520)},
    {"gray", rgb(0x808080)},
    {"green", rgb(0x008000)},
    {"greenyellow", rgb(0xADFF2F)},
    {"grey", rgb(0x808080)},
    {"honeydew", rgb(0xF0FFF0)},
    {"hotpink", rgb(0xFF69B4)},
    {"indianred", rgb(0xCD5C5C)},
    {"indigo", rgb(0x4B0082)},
    {"ivory", rgb(0xFFFFF0)},
    {"khaki", rgb(0xF0E68C)},
    {"lavender", rgb(0xE6E6FA)},
    {"lavenderblush", rgb(0xFFF0F5)},
    {"lawngreen", rgb(0x7CFC00)},
    {"lemonchiffon", rgb(0xFFFACD)},
    {"lightblue", rgb(0xADD8E6)},
    {"lightcoral", rgb(0xF08080)},
    {"lightcyan", rgb(0xE0FFFF)},
    {"lightgoldenrodyellow", rgb(0xFAFAD2)},
    {"lightgray", rgb(0xD3D3D3)},
    {"lightgreen", rgb(0x90EE90)},
    {"lightgrey", rgb(0xD3D3D3)},
    {"lightpink", rgb(0xFFB6C1)},
    {"lightsalmon", rgb(0xFFA07A)},
    {"lightseagreen", rgb(0x20B2AA)},
    {"lightskyblue", rgb(0x87CEFA)},
    {"lightslategray", rgb(0x778899)},
    {"lightslategrey", rgb(0x778899)},
    {"lightsteelblue", rgb(0xB0C4DE)},
    {"lightyellow", rgb(0xFFFFE0)},
    {"lime", rgb(0x00FF00)},
    {"limegreen", rgb(0x32CD32)},
    {"linen", rgb(0xFAF0E6)},
    {"magenta", rgb(0xFF00FF)},
    {"maroon", rgb(0x800000)},
    {"mediumaquamarine", rgb(0x66CDAA)},
    {"mediumblue", rgb(0x0000CD)},
    {"mediumorchid", rgb(0xBA55D3)},
    {"mediumpurple", rgb(0x9370DB)},
    {"mediumseagreen", rgb(0x3CB371)},
    {"mediumslateblue", rgb(0x7B68EE)},
    {"mediumspringgreen", rgb(0x00FA9A)},
    {"mediumturquoise", rgb(0x48D1CC)},
    {"mediumvioletred", rgb(0xC71585)},
    {"midnightblue", rgb(0x191970)},
    {"mintcream", rgb(0xF5FFFA)},
    {"mistyrose", rgb(0xFFE4E1)},
    {"moccasin", rgb(0xFFE4B5)},
    {"navajowhite", rgb(0xFFDEAD)},
    {"navy", rgb(0x000080)},
    {"oldlace", rgb(0xFDF5E6)},
    {"olive", rgb(0x808000)},
    {"olivedrab", rgb(0x6B8E23)},
    {"orange", rgb(0xFFA500)},
    {"orangered", rgb(0xFF4500)},
    {"orchid", rgb(0xDA70D6)},
    {"palegoldenrod", rgb(0xEEE8AA)},
    {"palegreen", rgb(0x98FB98)},
    {"paleturquoise", rgb(0xAFEEEE)},
    {"palevioletred", rgb(0xDB7093)},
    {"papayawhip", rgb(0xFFEFD5)},
    {"peachpuff", rgb(0xFFDAB9)},
    {"peru", rgb(0xCD853F)},
    {"pink", rgb(0xFFC0CB)},
    {"plum", rgb(0xDDA0DD)},
    {"powderblue", rgb(0xB0E0E6)},
    {"purple", rgb(0x800080)},
    {"rebeccapurple", rgb(0x663399)},
    {"red", rgb(0xFF0000)},
    {"rosybrown", rgb(0xBC8F8F)},
    {"royalblue", rgb(0x4169E1)},
    {"saddlebrown", rgb(0x8B4513)},
    {"salmon", rgb(0xFA8072)},
    {"sandybrown", rgb(0xF4A460)},
    {"seagreen", rgb(0x2E8B57)},
    {"seashell", rgb(0xFFF5EE)},
    {"sienna", rgb(0xA0522D)},
    {"silver", rgb(0xC0C0C0)},
    {"skyblue", rgb(0x87CEEB)},
    {"slateblue", rgb(0x6A5ACD)},
    {"slategray", rgb(0x708090)},
    {"slategrey", rgb(0x708090)},
    {"snow", rgb(0xFFFAFA)},
    {"springgreen", rgb(0x00FF7F)},
    {"steelblue", rgb(0x4682B4)},
    {"tan", rgb(0xD2B48C)},
    {"teal", rgb(0x008080)},
    {"thistle", rgb(0xD8BFD8)},
    {"tomato", rgb(0xFF6347)},
    {"turquoise", rgb(0x40E0D0)},
    {"violet", rgb(0xEE82EE)},
    {"wheat", rgb(0xF5DEB3)},
    {"white", rgb(0xFFFFFF)},
    {"whitesmoke", rgb(0xF5F5F5)},
    {"yellow", rgb(0xFFFF00)},
    {"yellowgreen", rgb(0x9ACD32)},
});

std::optional<Colour> colour_of_digits(std::string_view digits) {
    std::uint32_t code = 0;
    const char* const end = digits.data() + digits.size();
    const auto [stop, error] = std::from_chars(digits.data(), end, code, 16);
    if (digits.size() != 6 || error != std::errc{} || stop != end) return std::nullopt;
    return rgb(code);
}

}  // namespace

std::optional<Colour> colour_of_text(std::string_view text) {
    if (text.starts_with('#')) return colour_of_digits(text.substr(1));
    const std::string name = lower_case(std::string(text));
    const auto* const found = std::find_if(kNamedColours.begin(), kNamedColours.end(),
                                           [&](const NamedColour& named) { return named.name == name; });
    return found == kNamedColours.end() ? std::nullopt : std::optional(found->colour);
}

}  // namespace meniscus
