// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <optional>
#include <stdexcept>

#include "colours/depths.h"
#include "core/parallel.h"
#include "io/png.h"
#include "meniscus/errors.h"
#include "meniscus/page.h"
#include "meniscus/threads.h"
#include "page/html.h"
#include "page/page_data.h"
#include "page/viewer_files.h"
#include "platform/files/atomic_file.h"
#include "render/openness.h"

namespace meniscus {
namespace {

/// The browser counts atoms in single precision.
constexpr std::size_t kMostAtoms = std::size_t{1} << 24U;

/// Of the picture for browsers that cannot draw, pixels.
constexpr int kPictureWidth = 640;
constexpr int kPictureHeight = 480;

template <class T>
void need(const std::vector<T>& values, const Mesh& mesh, const char* name) {
    if (values.size() != mesh.vertices.size())
        throw UsageError(std::string("a page needs one value of '") + name + "' per vertex");
}

template <class T>
void allow(const std::vector<T>& values, const Mesh& mesh, const char* name) {
    if (!values.empty()) need(values, mesh, name);
}

void check(const Mesh& mesh, const Structure& structure) {
    if (structure.atoms.size() > kMostAtoms) throw LimitError("a page cannot hold more than 16,777,216 atoms");
    const std::size_t n = mesh.vertices.size();
    for (const Triangle& t : mesh.triangles)
        if (std::any_of(t.begin(), t.end(), [n](VertexId v) { return v >= n; }))
            throw UsageError("a triangle names a vertex that the mesh does not have");
    need(mesh.normals, mesh, "normal");
    need(mesh.atoms, mesh, "atom");
    need(mesh.patches, mesh, "patch");
    allow(mesh.components, mesh, "component");
    allow(mesh.mean_curvatures, mesh, "mean_curvature");
    allow(mesh.shape_indices, mesh, "shape_index");
    for (const VertexValues& values : mesh.values) need(values.values, mesh, values.name.c_str());
}

std::vector<float> light(const Mesh& mesh, const std::optional<RayScene>& rays) {
    return rays ? openness(mesh, *rays) : std::vector<float>(mesh.vertices.size());
}

/// How the picture is drawn that is seen where scripts or WebGL are missing.
PictureOptions still_picture(const PageOptions& options) {
    return {.width = kPictureWidth,
            .height = kPictureHeight,
            .viewpoint = options.viewpoint,
            .projection = options.projection,
            .background = kTransparent,
            .threads = options.threads};
}

}  // namespace

bool pages_supported() { return !page::kThreeScript.empty(); }

std::string make_page(const Mesh& mesh, const Structure& structure, const PageOptions& options) {
    if (!pages_supported()) throw std::runtime_error("pages need three.js; build with MENISCUS_PAGE=ON");
    check(mesh, structure);
    const ThreadLimit limit(options.threads);
    const std::optional<RayScene> rays = mesh.triangles.empty() ? std::nullopt : std::optional<RayScene>(mesh);
    const ExactSurface exact = options.exact.atoms().empty() ? ExactSurface(structure.atoms) : options.exact;
    const page::VertexExtras extras{.sky = light(mesh, rays), .depth = depths(mesh, exact)};
    const Picture still = draw_picture_by(extras.sky, mesh, rays, colour_vertices(mesh, structure, options.colours),
                                          still_picture(options));
    return page::make_html({.title = structure.name + " · Meniscus",
                            .picture = encode_png(still),
                            .data = page::page_data(mesh, structure, options, extras),
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
