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

/// A mesh and a colour for each of its vertices; both must outlive it.
struct ColouredMesh {
    const Mesh& mesh;
    std::span<const Colour> colours;
};

struct DrawOptions {
    PictureOptions picture{};               ///< its size is that with the legend
    std::optional<ColourOptions> scheme{};  ///< that the colours come from; nothing: from elsewhere
    bool legend = false;                    ///< at the right, in up to half of the width; of a scheme alone
    const Mesh* whole = nullptr;            ///< what the legend is of, where a part of it is drawn
};

/// Draws a surface, or a part of it. Where a scheme gives a colour to every point, borders are drawn where they are on
/// the surface, else as the colours of the vertices have them.
///
/// surface    of the structure's atoms
/// drawn      the mesh of the surface, or a part of it, perhaps with more values
/// throws     UsageError for colours that do not match the mesh, a legend without a scheme, and as make_legend() and
///            draw_picture()
/// cost       of draw_picture()
Picture draw_surface(const Surface& surface, const Structure& structure, const ColouredMesh& drawn,
                     const DrawOptions& options = {});

}  // namespace meniscus
