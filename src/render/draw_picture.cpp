// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <string>

#include "core/parallel.h"
#include "meniscus/errors.h"
#include "meniscus/picture.h"
#include "meniscus/threads.h"
#include "render/draw_by.h"
#include "render/scene.h"
#include "render/tile.h"

namespace meniscus {
namespace {

/// Small enough to share the work among threads, large enough for its margin not to matter.
constexpr int kTileSize = 64;

void check_mesh(const Mesh& mesh, std::span<const Colour> colours) {
    const std::size_t n = mesh.vertices.size();
    if (mesh.normals.size() != n) throw UsageError("a picture needs one normal per vertex");
    if (colours.size() != n) throw UsageError("a picture needs one colour per vertex");
    const auto is_vertex = [n](VertexId v) { return v < n; };
    for (const Triangle& t : mesh.triangles)
        if (!std::all_of(t.begin(), t.end(), is_vertex))
            throw UsageError("a triangle names a vertex that the mesh does not have");
}

void check_options(const PictureOptions& options) {
    const auto fits = [](int size) { return size >= 1 && size <= kLargestPicture; };
    if (!fits(options.width) || !fits(options.height))
        throw UsageError("a picture is 1 to " + std::to_string(kLargestPicture) + " pixels wide and high");
    if (!(options.depth_cue >= 0.0 && options.depth_cue <= 1.0)) throw UsageError("a depth cue is 0 to 1");
    if (!(options.opacity >= 0.0 && options.opacity <= 1.0)) throw UsageError("an opacity is 0 to 1");
    if (options.viewpoint) frame_of(*options.viewpoint);
}

PixelBox tile_box(std::size_t tile, const PictureOptions& options) {
    const int columns = (options.width + kTileSize - 1) / kTileSize;
    const int x = static_cast<int>(tile) % columns * kTileSize;
    const int y = static_cast<int>(tile) / columns * kTileSize;
    return {x, y, std::min(kTileSize, options.width - x), std::min(kTileSize, options.height - y)};
}

std::size_t tile_count(const PictureOptions& options) {
    const auto tiles = [](int size) { return static_cast<std::size_t>((size + kTileSize - 1) / kTileSize); };
    return tiles(options.width) * tiles(options.height);
}

void check(const Mesh& mesh, std::span<const Colour> colours, const PictureOptions& options) {
    check_mesh(mesh, colours);
    check_options(options);
}

Picture blank(const PictureOptions& options) {
    const std::size_t pixels = static_cast<std::size_t>(options.width) * static_cast<std::size_t>(options.height);
    return {options.width, options.height, std::vector<Colour>(pixels, options.background)};
}

Picture draw(const Scene& scene, const PictureOptions& options) {
    Picture picture = blank(options);
    parallel_for(tile_count(options), 1,
                 [&](std::size_t tile) { Tile(scene, options, tile_box(tile, options)).draw(picture); });
    return picture;
}

}  // namespace

bool pictures_supported() { return true; }

Picture draw_picture(const Mesh& mesh, std::span<const Colour> colours, const PictureOptions& options,
                     const ColourField& exact, const Bodies& beside) {
    check(mesh, colours, options);
    check_mesh(beside.mesh, beside.colours);
    const ThreadLimit limit(options.threads);
    if (mesh.triangles.empty()) return blank(options);
    return draw(Scene({mesh, colours}, RayScene(mesh), options, exact, beside), options);
}

Picture draw_picture_by(std::span<const float> sky, const Mesh& mesh, std::span<const Colour> colours,
                        const PictureOptions& options, const Bodies& beside) {
    check(mesh, colours, options);
    const ThreadLimit limit(options.threads);
    if (mesh.triangles.empty()) return blank(options);
    const ColourField none;
    Scene scene({mesh, colours}, RayScene(mesh), options, none, beside);
    scene.take_sky(sky);
    return draw(scene, options);
}

}  // namespace meniscus
