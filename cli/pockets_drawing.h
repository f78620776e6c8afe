// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Pockets for the eye: bodies, and the surface in their colours.
#pragma once

#include <string>
#include <vector>

#include "meniscus/describe_pockets.h"
#include "meniscus/page.h"
#include "meniscus/picture.h"
#include "meniscus/pockets.h"
#include "meniscus/surface.h"
#include "picture_options.h"
#include "pockets_tunnels.h"

namespace meniscus::cli {

/// A surface in the colours of its pockets, their bodies, and tunnels as tubes. Pictures and pages show it clear and
/// the others in it.
class DrawnPockets {
public:
    /// A mesh of the surface at its usual spacing, with the values kPocketValues.
    ///
    /// exact, pockets, structure, ways   of the same atoms
    DrawnPockets(const ExactSurface& exact, const Pockets& pockets, const Structure& structure,
                 const FoundTunnels& ways, const RunOptions& run);

    Picture picture(const Structure& structure, const PictureRequest& request, int threads) const;
    /// Pages as HTML.
    std::string page(const Structure& structure, const PictureRequest& request,
                     const std::vector<DescribedPocket>& described, int threads) const;
    /// The surface, with a node for each pocket, tunnel and pore, and one for ligands.
    void write_glb(const std::string& path, const Structure& structure, bool with_ligands, int threads) const;

private:
    Surface surface_;
    Bodies bodies_;
    std::vector<PageWay> ways_;
    Bodies tubes_;                 // of the ways, whose indices are the components
    std::vector<Colour> colours_;  // of the surface's vertices
};

}  // namespace meniscus::cli
