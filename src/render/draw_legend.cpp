// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Legends: swatches with labels in columns, or a bar of colours with a scale.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <span>
#include <string>
#include <vector>

#include "meniscus/errors.h"
#include "meniscus/legend.h"
#include "meniscus/picture.h"
#include "render/font.h"

namespace meniscus {
namespace {

constexpr Colour kInk{40, 40, 40, 255};
constexpr Colour kChalk{235, 235, 235, 255};

// Of the font's size.
constexpr double kLine = 1.5;
constexpr double kSwatch = 0.9;
constexpr double kGap = 0.5;           // between a swatch and its label
constexpr double kBorder = 1.2;        // around everything
constexpr double kWidestTitle = 11.0;  // longer ones are broken
constexpr double kWidestLabel = 12.0;  // longer ones end in an ellipsis
constexpr double kBarWidth = 1.3;
constexpr double kBarHeight = 13.0;
constexpr double kCapHeight = 0.73;

constexpr double kSizeShare = 1.0 / 42.0;  // of the picture's height
constexpr double kSmallestSize = 9.0;      // pixels; below, text cannot be read
constexpr double kShrinking = 0.93;

std::string number_text(double value) {
    std::array<char, 32> text{};
    std::snprintf(text.data(), text.size(), "%.3g", value == 0.0 ? 0.0 : value);
    const std::string plain = text.data();
    return plain.starts_with('-') ? "\u2212" + plain.substr(1) : plain;
}

/// Dark on what is light or transparent, light on what is dark.
Colour ink_for(const Colour& background) {
    const double brightness = 0.3 * background.red + 0.6 * background.green + 0.1 * background.blue;
    return background.alpha > 0 && brightness < 110.0 ? kChalk : kInk;
}

/// Words in as few lines as fit into a width; a word that is too long ends in an ellipsis.
std::vector<std::string> broken(const Font& font, const std::string& text, double width) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find(' ', begin), text.size());
        const std::string word = text.substr(begin, end - begin);
        if (!lines.empty() && font.width(lines.back() + ' ' + word) <= width)
            lines.back() += ' ' + word;
        else
            lines.push_back(font.fitted(word, width));
        begin = end + 1;
    }
    return lines;
}

/// Everything about a legend in one size of font.
class Layout {
public:
    /// shown   as many entries; how many there are beyond is told in one more line
    Layout(const Legend& legend, const LegendStyle& style, double size, std::size_t shown)
        : legend_(legend),
          style_(style),
          font_(size),
          title_(broken(font_, legend.title, kWidestTitle * size)),
          shown_(shown) {
        for (const LegendEntry& entry : std::span(legend.entries).first(shown))
            labels_.push_back(font_.fitted(entry.label, kWidestLabel * size));
        const std::size_t beyond = legend.entries.size() - shown;
        if (beyond > 0) labels_.push_back("and " + std::to_string(beyond) + " more");
        for (const std::string& label : labels_) label_width_ = std::max(label_width_, font_.width(label));
        const double line = kLine * size;
        const double bar = has_bar() ? (kBarHeight + kLine) * size : 0.0;
        const double head = line * static_cast<double>(title_.size()) + (title_.empty() ? 0.0 : kGap * size) + bar;
        const double rows = std::floor((style.height - 2.0 * kBorder * size - head) / line);
        rows_ = static_cast<int>(std::clamp(rows, 0.0, static_cast<double>(labels_.size())));
        if (rows_ > 0) columns_ = (static_cast<int>(labels_.size()) + rows_ - 1) / rows_;
        if (columns_ > 0) rows_ = (static_cast<int>(labels_.size()) + columns_ - 1) / columns_;
        height_ = head + line * rows_;
    }

    bool fits() const {
        const double available = style_.height - 2.0 * kBorder * font_.size();
        return height_ <= available && width() <= style_.width && (labels_.empty() || rows_ > 0);
    }

    int width() const { return static_cast<int>(std::ceil(content_width() + kBorder * font_.size())); }

    Picture draw() const {
        Picture picture{width(), style_.height, {}};
        picture.pixels.assign(static_cast<std::size_t>(picture.width) * picture.height, style_.background);
        double y = std::floor(0.5 * (style_.height - height_));
        for (const std::string& line : title_) draw_text(picture, {0.0, y += kLine * font_.size()}, line);
        if (!title_.empty()) y += kGap * font_.size();
        if (has_bar()) y = draw_bar(picture, y);
        draw_entries(picture, y);
        return picture;
    }

private:
    bool has_bar() const { return !legend_.ramp.empty(); }

    double column_width() const { return (kSwatch + kGap + kBorder) * font_.size() + label_width_; }

    double content_width() const {
        double width = columns_ * column_width() - (columns_ > 0 ? kBorder * font_.size() : 0.0);
        for (const std::string& line : title_) width = std::max(width, font_.width(line));
        if (has_bar())
            for (const double value : scale())
                width = std::max(width, (kBarWidth + kGap) * font_.size() + font_.width(number_text(value)));
        return width;
    }

    /// Values at the bar, from its top.
    std::array<double, 5> scale() const {
        const auto [low, high] = legend_.range;
        std::array<double, 5> values;
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = high - (high - low) * static_cast<double>(i) / (values.size() - 1.0);
        return values;
    }

    Colour ink() const { return ink_for(style_.background); }

    void draw_text(Picture& picture, const TextPlace& place, const std::string& text) const {
        font_.draw(picture, place, text, ink());
    }

    /// A rectangle of pixels with a faint edge; colour_of(share) of its height from the top.
    template <class ColourOf>
    void draw_box(Picture& picture, const TextPlace& corner, const std::array<double, 2>& size,
                  const ColourOf& colour_of) const {
        const int left = static_cast<int>(std::lround(corner.x));
        const int top = static_cast<int>(std::lround(corner.y));
        const int right = std::min(picture.width, left + static_cast<int>(std::lround(size[0])));
        const int bottom = std::min(picture.height, top + static_cast<int>(std::lround(size[1])));
        constexpr double kEdge = 0.35;
        for (int y = std::max(0, top); y < bottom; ++y)
            for (int x = left; x < right; ++x) {
                const bool edge = x == left || y == top || x == right - 1 || y == bottom - 1;
                Colour& pixel = picture.pixels[static_cast<std::size_t>(y) * picture.width + x];
                pixel = blended(colour_of((y - top + 0.5) / (bottom - top)), ink(), edge ? kEdge : 0.0);
            }
    }

    Colour on_bar(double share) const {
        const double place = (1.0 - share) * static_cast<double>(legend_.ramp.size() - 1);
        const auto i = static_cast<std::size_t>(place);
        const std::size_t next = std::min(i + 1, legend_.ramp.size() - 1);
        return blended(legend_.ramp[i], legend_.ramp[next], place - static_cast<double>(i));
    }

    /// Returns where what follows begins.
    double draw_bar(Picture& picture, double y) const {
        const double size = font_.size();
        const double height = kBarHeight * size;
        y += 0.5 * kGap * size;
        draw_box(picture, {0.0, y}, {kBarWidth * size, height}, [this](double share) { return on_bar(share); });
        const auto values = scale();
        for (std::size_t i = 0; i < values.size(); ++i) {
            const double at = y + height * static_cast<double>(i) / (values.size() - 1.0);
            const double inside = std::clamp(at, y + 0.5 * kCapHeight * size, y + height - 0.5 * kCapHeight * size);
            draw_text(picture, {(kBarWidth + kGap) * size, inside + 0.5 * kCapHeight * size}, number_text(values[i]));
        }
        return y + height + kGap * size;
    }

    void draw_entries(Picture& picture, double y) const {
        const double size = font_.size();
        for (std::size_t i = 0; i < labels_.size(); ++i) {
            const std::size_t column = i / static_cast<std::size_t>(rows_);
            const std::size_t row = i % static_cast<std::size_t>(rows_);
            const double x = static_cast<double>(column) * column_width();
            const double baseline = y + kLine * size * (static_cast<double>(row) + 0.75);
            draw_text(picture, {x + (kSwatch + kGap) * size, baseline}, labels_[i]);
            if (i >= shown_) continue;
            const Colour colour = legend_.entries[i].colour;
            const double top = baseline - 0.5 * (kCapHeight + kSwatch) * size;
            draw_box(picture, {x, top}, {kSwatch * size, kSwatch * size}, [&colour](double) { return colour; });
        }
    }

    const Legend& legend_;
    const LegendStyle& style_;
    Font font_;
    std::vector<std::string> title_;   // lines
    std::size_t shown_;                // entries
    std::vector<std::string> labels_;  // theirs, and how many there are more
    double label_width_ = 0.0;         // pixels
    int rows_ = 0;
    int columns_ = 0;
    double height_ = 0.0;  // of everything, pixels
};

/// How many entries have room in the smallest letters.
std::size_t most_entries(const Legend& legend, const LegendStyle& style) {
    const auto fits = [&](std::size_t shown) { return Layout(legend, style, kSmallestSize, shown).fits(); };
    std::size_t low = 0;
    std::size_t high = legend.entries.size();
    if (fits(high)) return high;
    while (high - low > 1) {
        const std::size_t middle = low + (high - low) / 2;
        (fits(middle) ? low : high) = middle;
    }
    return low;
}

}  // namespace

Picture draw_legend(const Legend& legend, const LegendStyle& style) {
    if (style.height < 1 || style.height > kLargestPicture)
        throw UsageError("a legend is 1 to " + std::to_string(kLargestPicture) + " pixels high");
    if (legend.entries.empty() && legend.ramp.empty()) return {0, style.height, {}};
    const std::size_t all = legend.entries.size();
    for (double size = std::max(kSmallestSize, kSizeShare * style.height); size > kSmallestSize; size *= kShrinking) {
        const Layout layout(legend, style, size, all);
        if (layout.fits()) return layout.draw();
    }
    const Layout layout(legend, style, kSmallestSize, most_entries(legend, style));
    if (!layout.fits()) throw UsageError("the picture is too small for its legend; choose a larger size");
    return layout.draw();
}

Picture side_by_side(const Picture& left, const Picture& right) {
    if (left.height != right.height) throw UsageError("only pictures of the same height can stand side by side");
    Picture both{left.width + right.width, left.height, {}};
    both.pixels.reserve(left.pixels.size() + right.pixels.size());
    for (int y = 0; y < both.height; ++y)
        for (const Picture* part : {&left, &right}) {
            const auto row = part->pixels.begin() + std::ptrdiff_t{y} * part->width;
            both.pixels.insert(both.pixels.end(), row, row + part->width);
        }
    return both;
}

}  // namespace meniscus
