// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Pockets for the eye: their bodies and tunnels, and the surface in their colours.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meniscus/describe_pockets.h"
#include "meniscus/describe_tunnels.h"
#include "meniscus/page.h"
#include "meniscus/picture.h"
#include "meniscus/pockets.h"
#include "meniscus/surface.h"

namespace meniscus {

/// Tunnels and a pore, to be drawn beside pockets.
struct PocketWays {
    std::vector<DescribedTunnel> tunnels{};
    std::optional<DescribedWay> pore{};
};

/// How pockets are drawn.
struct DrawPocketsOptions {
    PictureOptions picture{};  ///< of pages only viewpoint and projection. Without a viewpoint a pore stands upright
    bool legend = false;       ///< of pictures
    bool ligands = true;       ///< draw Structure::ligands, as sticks and balls
    int threads = 0;           ///< 0: all cores
};

/// A surface in the colours of its pockets, their bodies, and tunnels and pores as tubes in the colours of their radii.
/// Pictures and pages show the surface clear, with the others in it.
class DrawnPockets {
public:
    /// A mesh of the surface at its usual spacing, with the values kPocketValues.
    ///
    /// exact, pockets, structure, ways   of the same atoms
    /// cost                              that of mesh() for the surface, and for each tube
    DrawnPockets(const ExactSurface& exact, const Pockets& pockets, const Structure& structure, const PocketWays& ways,
                 const RunOptions& run = {});

    /// throws   as draw_surface()
    Picture picture(const Structure& structure, const DrawPocketsOptions& options = {}) const;

    /// An HTML page with a list of the pockets and ways.
    ///
    /// described   the pockets
    /// throws      as make_page()
    std::string page(const Structure& structure, std::span<const DescribedPocket> described,
                     const DrawPocketsOptions& options = {}) const;

    /// Writes glTF: the surface, with a node for each pocket, tunnel and pore, and one for ligands.
    ///
    /// throws   as write_mesh()
    void write_glb(const std::string& path, const Structure& structure, const DrawPocketsOptions& options = {}) const;

private:
    Surface surface_;
    Bodies bodies_;
    std::vector<PageWay> ways_;
    Bodies tubes_;                 // of the ways, whose indices are the components
    std::vector<Colour> colours_;  // of the surface's vertices
};

}  // namespace meniscus
