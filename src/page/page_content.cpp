// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "page/page_content.h"

#include <algorithm>

#include "colours/depths.h"
#include "colours/palettes.h"
#include "meniscus/errors.h"
#include "meniscus/legend.h"
#include "meniscus/threads.h"
#include "page/page_data.h"
#include "render/openness.h"

namespace meniscus {
namespace page {
namespace {

/// The browser counts atoms in single precision.
constexpr std::size_t kMostAtoms = std::size_t{1} << 24U;

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

std::vector<float> light(const Mesh& mesh) {
    return mesh.triangles.empty() ? std::vector<float>(mesh.vertices.size()) : openness(mesh);
}

}  // namespace

VertexExtras checked_extras(const Mesh& mesh, const Structure& structure, const PageOptions& options) {
    check(mesh, structure);
    const ThreadLimit limit(options.threads);
    const ExactSurface exact = options.exact.atoms().empty() ? ExactSurface(structure.atoms) : options.exact;
    return {.sky = light(mesh), .depth = depths(mesh, exact)};
}

std::vector<Colour> colours_shown(const Mesh& mesh, const Structure& structure, const ColourOptions& options) {
    const Legend legend = make_legend(mesh, structure, options);
    std::vector<Colour> colours = legend.ramp;
    for (const LegendEntry& entry : legend.entries) colours.push_back(entry.colour);
    if (colours.empty()) colours.push_back(options.colour.value_or(kPlain));
    return colours;
}

PageContent content_by(const VertexExtras& extras, const Mesh& mesh, const Structure& structure,
                       const PageOptions& options) {
    return {.title = structure.name + " · Meniscus", .data = page_data(mesh, structure, options, extras)};
}

}  // namespace page

PageContent page_content(const Mesh& mesh, const Structure& structure, const PageOptions& options) {
    return page::content_by(page::checked_extras(mesh, structure, options), mesh, structure, options);
}

}  // namespace meniscus
