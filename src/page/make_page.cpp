// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <stdexcept>

#include "core/parallel.h"
#include "io/atomic_file.h"
#include "io/png.h"
#include "meniscus/errors.h"
#include "meniscus/page.h"
#include "page/html.h"
#include "page/page_data.h"
#include "page/viewer_files.h"
#include "render/openness.h"

namespace meniscus {
namespace {

/// The browser counts atoms in single precision.
constexpr std::size_t kMostAtoms = std::size_t{1} << 24U;

/// Of the picture for browsers that cannot draw, pixels.
constexpr int kPictureWidth = 960;
constexpr int kPictureHeight = 720;

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
    if (mesh.triangles.empty()) throw UsageError("a page needs a mesh with triangles");
    if (structure.atoms.size() > kMostAtoms) throw LimitError("a page cannot hold more than 16,777,216 atoms");
    need(mesh.normals, mesh, "normal");
    need(mesh.atoms, mesh, "atom");
    need(mesh.patches, mesh, "patch");
    allow(mesh.components, mesh, "component");
    allow(mesh.mean_curvatures, mesh, "mean_curvature");
    allow(mesh.shape_indices, mesh, "shape_index");
}

std::vector<double> depths(const Mesh& mesh, const Structure& structure) {
    std::vector<double> depth = signed_distance(AccessibleSurface(structure.atoms, kDepthProbe), mesh.vertices);
    for (double& d : depth) d = std::max(0.0, -d);
    return depth;
}

/// What is seen where scripts or WebGL are missing.
std::string draw(const Mesh& mesh, const Structure& structure, const PageOptions& options) {
    return encode_png(draw_picture(mesh, colour_vertices(mesh, structure, options.colours),
                                   {.width = kPictureWidth,
                                    .height = kPictureHeight,
                                    .viewpoint = options.viewpoint,
                                    .projection = options.projection,
                                    .background = kTransparent,
                                    .threads = options.threads}));
}

}  // namespace

bool pages_supported() { return !page::kThreeScript.empty(); }

std::string make_page(const Mesh& mesh, const Structure& structure, const PageOptions& options) {
    if (!pages_supported()) throw std::runtime_error("pages need three.js; build with MENISCUS_PAGE=ON");
    check(mesh, structure);
    const ThreadLimit limit(options.threads);
    return page::make_html(
        {.title = structure.name + " · Meniscus",
         .picture = draw(mesh, structure, options),
         .data = page::page_data(mesh, structure, options, {.sky = openness(mesh), .depth = depths(mesh, structure)}),
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
