// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "render/tile.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace meniscus {
namespace {

/// Looks at a pixel where the surface ends, and at one where only its colour or light changes.
constexpr int kSamples = 16;
constexpr int kFewSamples = 8;

/// Rows of pixels whose samples are looked at together: enough of them, in little memory.
constexpr int kRowsAtOnce = 8;

/// Neighbours that differ by more are looked at again: a step that the eye sees, on a scale where white is 1.
constexpr float kVisibleStep = 0.03F;

/// Lines are this share of the picture's width wide, but not below kThinnestLine pixels, and appear where depth jumps
/// by this share of all.
constexpr double kLineShare = 1.0 / 800.0;
constexpr double kThinnestLine = 1.0;
constexpr double kSectionLine = 1.8;  // times as wide: it is all that tells a section from paper
constexpr double kJumpShare = 0.02;
constexpr double kSmallestJump = 1e-3;  // Å; for what is flat
constexpr float kLineDarkness = 0.85F;

/// Of a pixel, from its corner.
constexpr double kMiddle = 0.5;

/// Points of a (0, 2)-sequence (van der Corput and Sobol), scrambled by constants so that few already balance.
std::array<Spot, kSamples> make_sample_places() {
    std::array<Spot, kSamples> places;
    for (unsigned i = 0; i < kSamples; ++i) {
        unsigned x = 0;
        unsigned y = 0;
        unsigned direction = kSamples / 2;
        for (unsigned bit = 0; 1U << bit < kSamples; ++bit) {
            if ((i >> bit & 1U) != 0) {
                x ^= unsigned{kSamples / 2} >> bit;
                y ^= direction;
            }
            direction ^= direction >> 1U;
        }
        places[i] = {((x ^ 1U) + 0.5) / kSamples, ((y ^ 1U) + 0.5) / kSamples};
    }
    return places;
}

const std::array<Spot, kSamples>& sample_places() {
    static const auto places = make_sample_places();
    return places;
}

/// Adds the places by which a pixel is looked at.
void add_samples(int x, int y, int count, std::vector<Spot>& spots) {
    for (const Spot& place : std::span(sample_places()).first(static_cast<std::size_t>(count)))
        spots.push_back({x + place.x, y + place.y});
}

/// About as the eye sees it: twice the light is not twice as bright.
Light brightness(const Light& light) { return {std::sqrt(light.red), std::sqrt(light.green), std::sqrt(light.blue)}; }

bool differ(const Light& a, const Light& b) {
    return std::abs(a.red - b.red) > kVisibleStep || std::abs(a.green - b.green) > kVisibleStep ||
           std::abs(a.blue - b.blue) > kVisibleStep;
}

PixelBox grown(const PixelBox& box, int margin) {
    return {box.x - margin, box.y - margin, box.width + 2 * margin, box.height + 2 * margin};
}

double line_radius(const PictureOptions& options) { return std::max(kThinnestLine, kLineShare * options.width); }

}  // namespace

Tile::Tile(const Scene& scene, const PictureOptions& options, const PixelBox& box)
    : scene_(scene),
      box_(box),
      radius_(options.outline ? line_radius(options) : 0.0),
      section_radius_(options.cut ? kSectionLine * line_radius(options) : 0.0),
      reach_(static_cast<int>(std::ceil(std::max(radius_, section_radius_)))),
      margin_(reach_ + (options.cut ? 2 : 1)),
      jump_(std::max(kSmallestJump, kJumpShare * scene.camera().depth_range())),
      background_opacity_(static_cast<float>(options.background.alpha) / 255.0F) {
    look_at_centres();
    if (options.cut) find_sections();
    lights_.resize(centres_.size());
    brightness_.resize(centres_.size());
    const PixelBox neighbours = grown(box, 1);
    for (int y = neighbours.y; y < neighbours.y + neighbours.height; ++y)
        for (int x = neighbours.x; x < neighbours.x + neighbours.width; ++x) {
            const std::size_t here = place(x, y);
            lights_[here] = with_lines(centres_[here], x + kMiddle, y + kMiddle);
            brightness_[here] = brightness(lights_[here]);
        }
}

void Tile::look_at_centres() {
    const PixelBox all = grown(box_, margin_);
    std::vector<Spot> spots;
    spots.reserve(static_cast<std::size_t>(all.width) * static_cast<std::size_t>(all.height));
    for (int y = all.y; y < all.y + all.height; ++y)
        for (int x = all.x; x < all.x + all.width; ++x) spots.push_back({x + kMiddle, y + kMiddle});
    centres_ = scene_.look(spots);
}

/// Of a pixel of the box or its margin among the centres.
std::size_t Tile::place(int x, int y) const {
    const int columns = box_.width + 2 * margin_;
    const int row = y - box_.y + margin_;
    const int column = x - box_.x + margin_;
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) + static_cast<std::size_t>(column);
}

/// Counts samples along the edges of sections: lines around them would have steps otherwise.
void Tile::find_sections() {
    sections_.assign(centres_.size(), 0.0F);
    const PixelBox known = grown(box_, margin_ - 1);
    for (int y = known.y; y < known.y + known.height; ++y)
        for (int x = known.x; x < known.x + known.width; ++x) sections_[place(x, y)] = section_share(x, y);
}

float Tile::section_share(int x, int y) const {
    const auto is_section = [](const Glimpse& seen) { return seen.kind == Glimpse::Kind::Section; };
    const bool here = is_section(centres_[place(x, y)]);
    bool mixed = false;
    for (int j = y - 1; j <= y + 1; ++j)
        for (int i = x - 1; i <= x + 1; ++i) mixed = mixed || is_section(centres_[place(i, j)]) != here;
    if (!mixed) return here ? 1.0F : 0.0F;
    std::vector<Spot> spots;
    add_samples(x, y, kSamples, spots);
    const std::vector<Glimpse> seen = scene_.look(spots);
    return static_cast<float>(std::count_if(seen.begin(), seen.end(), is_section)) / kSamples;
}

/// How far a pixel close to a glimpse calls for a line there, 0 to 1: if it shows something much farther away, or no
/// section beside one. So lines lie on the nearer side of a jump and do not widen the silhouette.
double Tile::line_towards(std::size_t pixel, double distance, const Glimpse& seen) const {
    const auto nearness = [distance](double radius) { return std::clamp(radius + kMiddle - distance, 0.0, 1.0); };
    double line = 0.0;
    if (seen.kind == Glimpse::Kind::Section) line = nearness(section_radius_) * (1.0 - sections_[pixel]);
    if (radius_ == 0.0) return line;
    const double jump = (centres_[pixel].depth - seen.depth) / jump_;
    return std::max(line, nearness(radius_) * std::clamp(jump - 1.0, 0.0, 1.0));
}

/// False where line_towards() is 0 at any distance, as it is in most places.
bool Tile::may_have_line(std::size_t pixel, const Glimpse& seen) const {
    return (seen.kind == Glimpse::Kind::Section && sections_[pixel] < 1.0F) ||
           (radius_ > 0.0 && centres_[pixel].depth - seen.depth > jump_);
}

/// How much of a line is at a place, 0 to 1.
double Tile::lines_near(double x, double y, const Glimpse& seen) const {
    const int column = static_cast<int>(std::floor(x));
    const int row = static_cast<int>(std::floor(y));
    double strongest = 0.0;
    for (int j = row - reach_; j <= row + reach_; ++j)
        for (int i = column - reach_; i <= column + reach_; ++i) {
            if (!may_have_line(place(i, j), seen)) continue;
            const double distance = std::hypot(i + kMiddle - x, j + kMiddle - y);
            strongest = std::max(strongest, line_towards(place(i, j), distance, seen));
        }
    return strongest;
}

Light Tile::with_lines(const Glimpse& seen, double x, double y) const {
    if (reach_ == 0 || seen.is_background()) return seen.light;
    return (1.0F - kLineDarkness * static_cast<float>(lines_near(x, y, seen))) * seen.light;
}

/// How often a pixel must be looked at, beyond its centre.
int Tile::samples_needed(int x, int y) const {
    const std::size_t here = place(x, y);
    int needed = 0;
    for (int j = y - 1; j <= y + 1; ++j)
        for (int i = x - 1; i <= x + 1; ++i) {
            const std::size_t there = place(i, j);
            if (centres_[here].kind != centres_[there].kind) return kSamples;
            if (std::abs(centres_[here].depth - centres_[there].depth) > jump_) return kSamples;
            if (differ(brightness_[here], brightness_[there])) needed = kFewSamples;
        }
    return needed;
}

/// Means are taken of light times opacity, so that a transparent background has no colour.
Colour Tile::mean_colour(std::span<const Glimpse> seen, std::span<const Spot> spots) const {
    Light sum;
    float opacity = 0.0F;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const float share = seen[i].is_background() ? background_opacity_ : 1.0F;
        sum += share * with_lines(seen[i], spots[i].x, spots[i].y);
        opacity += share;
    }
    return to_colour(opacity > 0.0F ? (1.0F / opacity) * sum : sum, opacity / static_cast<float>(seen.size()));
}

void Tile::draw_part(const PixelBox& part, Picture& picture) const {
    std::vector<std::size_t> counts;
    std::vector<Spot> spots;
    for (int y = part.y; y < part.y + part.height; ++y)
        for (int x = part.x; x < part.x + part.width; ++x) {
            const int count = samples_needed(x, y);
            counts.push_back(static_cast<std::size_t>(count));
            add_samples(x, y, count, spots);
        }
    const std::vector<Glimpse> seen = scene_.look(spots);
    std::size_t pixel = 0;
    std::size_t first = 0;
    for (int y = part.y; y < part.y + part.height; ++y)
        for (int x = part.x; x < part.x + part.width; ++x) {
            const std::size_t here = place(x, y);
            const std::size_t count = counts[pixel++];
            const float opacity = centres_[here].is_background() ? background_opacity_ : 1.0F;
            picture.pixels[static_cast<std::size_t>(y) * picture.width + x] =
                count > 0 ? mean_colour(std::span(seen).subspan(first, count), std::span(spots).subspan(first, count))
                          : to_colour(lights_[here], opacity);
            first += count;
        }
}

void Tile::draw(Picture& picture) const {
    for (int y = 0; y < box_.height; y += kRowsAtOnce)
        draw_part({box_.x, box_.y + y, box_.width, std::min(kRowsAtOnce, box_.height - y)}, picture);
}

}  // namespace meniscus
