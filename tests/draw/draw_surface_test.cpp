// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/draw_surface.h"

#include <gtest/gtest.h>

#include "meniscus/errors.h"
#include "support/small_ligand.h"

namespace meniscus {
namespace {

/// Two atoms that touch, of two elements.
Structure pair() {
    Structure structure;
    structure.atoms = {{{-1, 0, 0}, {1, 0, 0}}, {1.7, 1.7}};
    structure.labels.resize(2);
    structure.labels[0].element = "C";
    structure.labels[1].element = "O";
    structure.residues.resize(1);
    return structure;
}

class DrawSurface : public ::testing::Test {
protected:
    Picture draw(const DrawOptions& options, std::span<const Colour> colours) const {
        DrawOptions small = options;
        small.picture.width = 64;
        small.picture.height = 48;
        small.picture.viewpoint = Viewpoint{{0, 0, 1}, {0, 1, 0}};
        return draw_surface(surface, structure, {surface.mesh, colours}, small);
    }

    Structure structure = pair();
    Surface surface = compute_surface(structure.atoms);
    std::vector<Colour> by_element = colour_vertices(surface.mesh, structure, {.scheme = ColourScheme::Element});
};

TEST_F(DrawSurface, IsThePictureOfTheFieldOfItsScheme) {
    const ColourOptions scheme{.scheme = ColourScheme::Element};
    const Picture expected = draw_picture(surface.mesh, by_element,
                                          {.width = 64, .height = 48, .viewpoint = Viewpoint{{0, 0, 1}, {0, 1, 0}}},
                                          colour_by_feature(surface.exact, structure, scheme));
    EXPECT_EQ(draw({.scheme = scheme}, by_element).pixels, expected.pixels);
    EXPECT_NE(draw({}, by_element).pixels, expected.pixels) << "borders of vertices are less sharp";
}

TEST_F(DrawSurface, LigandsAreDrawnUnlessLeftOutAndNothingChangesWithoutThem) {
    const Picture without = draw({}, by_element);
    structure.ligands = testing::carbon_monoxide({-0.5, 0.0, 3.0});
    EXPECT_EQ(draw({.ligands = false}, by_element).pixels, without.pixels);
    EXPECT_NE(draw({}, by_element).pixels, without.pixels);
    structure.ligands = testing::carbon_monoxide({-0.5, 0.0, 30.0});
    EXPECT_EQ(draw({}, by_element).pixels, without.pixels) << "it is far away";
}

TEST_F(DrawSurface, ALegendTakesFromTheWidth) {
    DrawOptions options{.scheme = ColourOptions{.scheme = ColourScheme::Element}, .legend = true};
    options.picture.width = 640;
    options.picture.height = 480;
    const Picture picture = draw_surface(surface, structure, {surface.mesh, by_element}, options);
    EXPECT_EQ(picture.width, 640);
    EXPECT_EQ(picture.height, 480);
}

TEST_F(DrawSurface, ALegendNeedsAScheme) { EXPECT_THROW(draw({.legend = true}, by_element), UsageError); }

}  // namespace
}  // namespace meniscus
