// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "meniscus/draw_surface.h"

#include "meniscus/errors.h"
#include "meniscus/legend.h"
#include "meniscus/ligand_bodies.h"

namespace meniscus {
namespace {

Picture legend_of(const Mesh& mesh, const Structure& structure, const DrawOptions& options) {
    const PictureOptions& picture = options.picture;
    if (!options.legend) return {0, picture.height, {}};
    if (!options.scheme)
        throw UsageError("legend: explains a scheme of colours, and there is none for colours given one by one");
    return draw_legend(make_legend(options.whole != nullptr ? *options.whole : mesh, structure, *options.scheme),
                       {.width = picture.width / 2, .height = picture.height, .background = picture.background});
}

}  // namespace

Picture draw_surface(const Surface& surface, const Structure& structure, const ColouredMesh& drawn,
                     const DrawOptions& options) {
    const Picture legend = legend_of(drawn.mesh, structure, options);
    PictureOptions picture = options.picture;
    picture.width -= legend.width;
    const Bodies ligands = options.ligands ? ligand_bodies(structure.ligands, drawn.mesh, drawn.colours) : Bodies{};
    const Bodies beside = joined(ligands, options.beside);
    const auto draw = [&](const ColourField& field) {
        return side_by_side(draw_picture(drawn.mesh, drawn.colours, picture, field, beside), legend);
    };
    if (!options.scheme) return draw({});
    if (surface.level_set)
        if (const ColourField field = colour_by_level_set(*surface.level_set, *options.scheme)) return draw(field);
    return draw(colour_by_feature(surface.exact, structure, *options.scheme));
}

}  // namespace meniscus
