// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include "geometry/accessible_surface.h"
#include "meniscus/draw_surface.h"
#include "meniscus/field.h"
#include "meniscus/page.h"
#include "meniscus/sample.h"
#include "meniscus/surface.h"
#include "support/small_structures.h"

namespace meniscus {
namespace {

TEST(BuiltOnce, IsTheGeometryOfEverythingThatOneRunGives) {
    const Structure structure = testing::two_atoms();
    const std::size_t before = accessible_surfaces_built();
    const Surface surface = mesh(ExactSurface(structure.atoms), {.method = Method::Direct, .exact = true});
    const VolumeGrid grid = enclosing_grid(surface.exact, 2.0);
    for (const ApbsMap map : {ApbsMap::DielectricX, ApbsMap::DielectricY, ApbsMap::DielectricZ, ApbsMap::Kappa})
        apbs_map(surface, grid, map);
    sample_surface(surface);
    const ColourOptions by_chain{.scheme = ColourScheme::Chain};
    draw_surface(surface, structure, {surface.mesh, colour_vertices(surface.mesh, structure, by_chain)},
                 {.picture = {.width = 32, .height = 24}, .scheme = by_chain});
    depth_values(surface.mesh, surface.exact);
    if (pages_supported())
        make_page(surface.mesh, structure,
                  {.rows = page_rows(structure, surface, surface.exact.measures()), .exact = surface.exact});
    // The excluded surface, the atoms enlarged by the ions of the map of their accessibility, and that of a large
    // probe.
    EXPECT_EQ(accessible_surfaces_built() - before, 3U);
}

}  // namespace
}  // namespace meniscus
