// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A rectangle of the picture: looked at once per pixel, and again where that is not enough.
#pragma once

#include <span>
#include <vector>

#include "meniscus/picture.h"
#include "render/scene.h"

namespace meniscus {

/// Pixels of a picture: from the corner (x, y), inclusive.
struct PixelBox {
    int x = 0;
    int y = 0;
    int width = 0;
    int height = 0;
};

/// Draws the pixels of a box. One that differs from a neighbour gets the mean light of up to sixteen fixed places in
/// it.
class Tile {
public:
    Tile(const Scene& scene, const PictureOptions& options, const PixelBox& box);

    /// Precondition: the picture has the size of the options. Writes no pixel outside the box.
    void draw(Picture& picture) const;

private:
    std::size_t place(int x, int y) const;
    void look_at_centres();
    void find_sections();
    float section_share(int x, int y) const;
    bool may_have_line(std::size_t pixel, const Glimpse& seen) const;
    double line_towards(std::size_t pixel, double distance, const Glimpse& seen) const;
    double lines_near(double x, double y, const Glimpse& seen) const;
    Light with_lines(const Glimpse& seen, double x, double y) const;
    int samples_needed(int x, int y) const;
    Colour mean_colour(std::span<const Glimpse> seen, std::span<const Spot> spots) const;
    void draw_part(const PixelBox& part, Picture& picture) const;

    const Scene& scene_;
    PixelBox box_;           // with a margin, in which neighbours of its pixels lie
    double radius_;          // of lines where depth jumps, pixels; 0 for none
    double section_radius_;  // of lines around sections, pixels
    int reach_;              // of the wider ones, pixels
    int margin_;             // pixels
    double jump_;            // of depth that makes a line, Å
    float background_opacity_;
    std::vector<Glimpse> centres_;
    std::vector<float> sections_;    // how much of each pixel is section; empty without a cut
    std::vector<Light> lights_;      // of the centres, with lines
    std::vector<Light> brightness_;  // of these lights
};

}  // namespace meniscus
