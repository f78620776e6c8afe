// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "colours/palettes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "colours/further_colours.h"

namespace meniscus {
namespace {

constexpr std::array<Colour, kDistinctColours> kDistinct{
    rgb(0x77AADD), rgb(0xEE8866), rgb(0xEEDD88), rgb(0xFFAABB), rgb(0x994455), rgb(0x0072B2),
    rgb(0x997700), rgb(0x99DDFF), rgb(0xEE3377), rgb(0xBBCC33), rgb(0x009988), rgb(0xAAAA00),
};

constexpr std::array kRdBu{
    rgb(0x2166AC), rgb(0x4393C3), rgb(0x92C5DE), rgb(0xD1E5F0), rgb(0xF7F7F7),
    rgb(0xFDDBC7), rgb(0xF4A582), rgb(0xD6604D), rgb(0xB2182B),
};
constexpr auto kBuRd = [] {
    auto reversed = kRdBu;
    std::reverse(reversed.begin(), reversed.end());
    return reversed;
}();
constexpr std::array kBrBG{
    rgb(0x01665E), rgb(0x35978F), rgb(0x80CDC1), rgb(0xC7EAE5), rgb(0xF5F5F5),
    rgb(0xF6E8C3), rgb(0xDFC27D), rgb(0xBF812D), rgb(0x8C510A),
};
constexpr std::array kYlOrBr{
    rgb(0xFFFFE5), rgb(0xFFF7BC), rgb(0xFEE391), rgb(0xFEC44F), rgb(0xFE9929),
    rgb(0xEC7014), rgb(0xCC4C02), rgb(0x993404), rgb(0x662506),
};
constexpr std::array kRdPu{
    rgb(0xFFF7F3), rgb(0xFDE0DD), rgb(0xFCC5C0), rgb(0xFA9FB5), rgb(0xF768A1),
    rgb(0xDD3497), rgb(0xAE017E), rgb(0x7A0177), rgb(0x49006A),
};
constexpr std::array kYlGnBu{
    rgb(0xFFFFD9), rgb(0xEDF8B1), rgb(0xC7E9B4), rgb(0x7FCDBB), rgb(0x41B6C4),
    rgb(0x1D91C0), rgb(0x225EA8), rgb(0x253494), rgb(0x081D58),
};

std::uint8_t between(std::uint8_t a, std::uint8_t b, double share) {
    return static_cast<std::uint8_t>(std::lround((1.0 - share) * a + share * b));
}

}  // namespace

Colour distinct_colour(std::size_t n) {
    const std::size_t place = n % kAllColours;
    return place < kDistinct.size() ? kDistinct[place] : further_colours(kDistinct, kAllColours)[place];
}

Colour ramp_colour(std::span<const Colour> ramp, double value) {
    const double place = std::clamp(value, 0.0, 1.0) * static_cast<double>(ramp.size() - 1);
    const std::size_t i = std::min(static_cast<std::size_t>(place), ramp.size() - 2);
    const double share = place - static_cast<double>(i);
    const Colour& a = ramp[i];
    const Colour& b = ramp[i + 1];
    return {between(a.red, b.red, share), between(a.green, b.green, share), between(a.blue, b.blue, share)};
}

std::span<const Colour> diverging_ramp() { return kRdBu; }
std::span<const Colour> potential_ramp() { return kBuRd; }
std::span<const Colour> hydropathy_ramp() { return kBrBG; }
std::span<const Colour> warm_ramp() { return kYlOrBr; }
std::span<const Colour> cold_ramp() { return kYlGnBu; }
std::span<const Colour> passage_ramp() { return kRdPu; }

}  // namespace meniscus
