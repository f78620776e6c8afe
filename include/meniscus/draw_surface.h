// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A surface as a picture, with sharp borders between its colours and a legend.
#pragma once

#include <optional>
#include <span>

#include "meniscus/colours.h"
#include "meniscus/picture.h"
#include "meniscus/structure.h"
#include "meniscus/surface.h"

namespace meniscus {

/// References to a mesh and to one colour per vertex, which the caller keeps.
struct ColouredMesh {
    const Mesh& mesh;
    std::span<const Colour> colours;
};

/// How a surface is drawn.
struct DrawOptions {
    PictureOptions picture{};               ///< width and height include the legend
    std::optional<ColourOptions> scheme{};  ///< the scheme that the colours come from; nothing: another source
    bool legend = false;                    ///< draw a legend at the right, in up to half the width; needs a scheme
    bool ligands = true;                    ///< draw Structure::ligands, as sticks and balls
    Bodies beside{};                        ///< more than ligands, drawn beside the surface
    const Mesh* whole = nullptr;            ///< the mesh that the legend describes; nullptr: the drawn one
};

/// Draws a surface, or a part of it. Borders between colours are sharp if a scheme gives a colour to every point;
/// otherwise they follow the colours of the vertices.
///
/// surface    computed from the structure's atoms
/// drawn      the mesh of the surface or a part of that mesh, possibly with further values
/// throws     UsageError for colours that do not match the mesh or a legend without a scheme, and whatever
///            make_legend() and draw_picture() throw
/// cost       that of draw_picture()
Picture draw_surface(const Surface& surface, const Structure& structure, const ColouredMesh& drawn,
                     const DrawOptions& options = {});

}  // namespace meniscus
