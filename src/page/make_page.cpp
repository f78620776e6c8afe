// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <cstdint>
#include <stdexcept>

#include "io/png.h"
#include "meniscus/ligand_bodies.h"
#include "meniscus/page.h"
#include "page/html.h"
#include "page/page_content.h"
#include "page/viewer_files.h"
#include "platform/files/atomic_file.h"
#include "render/draw_by.h"

namespace meniscus {
namespace {

/// Of the picture for browsers that cannot draw, pixels.
constexpr int kPictureWidth = 640;
constexpr int kPictureHeight = 480;

/// Opacities with which pockets are seen in the molecule; viewer/page.js and viewer/bodies.js have the same.
constexpr double kSeeThrough = 0.35;
constexpr std::uint8_t kBodyAlpha = 191;

/// How the picture is drawn that is seen where scripts or WebGL are missing.
PictureOptions still_picture(const PageOptions& options) {
    return {.width = kPictureWidth,
            .height = kPictureHeight,
            .viewpoint = options.viewpoint,
            .projection = options.projection,
            .background = kTransparent,
            .opacity = options.bodies != nullptr || options.tubes != nullptr ? kSeeThrough : 1.0,
            .threads = options.threads};
}

Bodies bodies_of(const PageOptions& options) {
    if (options.bodies == nullptr) return {};
    Bodies bodies{*options.bodies, {}};
    for (const std::uint32_t pocket : bodies.mesh.components) {
        bodies.colours.push_back(options.pockets[pocket].colour);
        bodies.colours.back().alpha = kBodyAlpha;
    }
    return bodies;
}

/// PNG; empty in a build that draws no pictures.
std::string picture_by(const page::VertexExtras& extras, const Mesh& mesh, const Structure& structure,
                       const PageOptions& options) {
    if (!pictures_supported()) return {};
    const std::vector<Colour> colours = colour_vertices(mesh, structure, options.colours);
    const Bodies ligands =
        options.ligands ? ligand_bodies(structure.ligands, mesh, page::colours_shown(mesh, structure, options.colours))
                        : Bodies{};
    const Bodies tubes = options.tubes != nullptr ? *options.tubes : Bodies{};
    return encode_png(draw_picture_by(extras.sky, mesh, colours, still_picture(options),
                                      joined(joined(ligands, bodies_of(options)), tubes)));
}

}  // namespace

bool pages_supported() { return !page::kThreeScript.empty(); }

std::string make_page(const Mesh& mesh, const Structure& structure, const PageOptions& options) {
    if (!pages_supported()) throw std::runtime_error("pages need three.js; build with MENISCUS_PAGE=ON");
    const page::VertexExtras extras = page::checked_extras(mesh, structure, options);
    PageContent content = page::content_by(extras, mesh, structure, options);
    return page::make_html({.title = std::move(content.title),
                            .picture = picture_by(extras, mesh, structure, options),
                            .data = std::move(content.data),
                            .tables = page::tables_of(options.rows),
                            .description = structure.name});
}

void write_page(const std::string& path, const Mesh& mesh, const Structure& structure, const PageOptions& options) {
    const std::string html = make_page(mesh, structure, options);
    AtomicFile file(path);
    file.write(html);
    file.commit();
}

}  // namespace meniscus
