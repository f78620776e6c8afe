// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Pages: a surface to turn, cut and ask, in one HTML file that opens in a browser without network or server.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meniscus/colours.h"
#include "meniscus/measures.h"
#include "meniscus/mesh.h"
#include "meniscus/picture.h"
#include "meniscus/structure.h"
#include "meniscus/surface.h"

namespace meniscus {

/// A number that a page shows beside the surface, such as {"Exact", "area", "4613.9 Å²"}.
struct PageRow {
    std::string section;  ///< rows of one section follow each other under its name
    std::string label;
    std::string value;
};

/// The numbers of a surface as pages show them: exact ones, the mesh's, how it was made, its checks.
///
/// structure  that the surface is of; its file, if it has one, is named without folders
/// exact      measures of the same atoms and probe
std::vector<PageRow> page_rows(const Structure& structure, const Surface& surface, const Measures& exact);

/// The same without exact numbers.
std::vector<PageRow> page_rows(const Structure& structure, const Surface& surface);

struct PageOptions {
    ColourOptions colours{};               ///< shown first; a range holds for its scheme wherever the page shows it
    std::optional<Viewpoint> viewpoint{};  ///< at first; nothing: as pictures have it
    Projection projection = Projection::Orthographic;
    std::vector<PageRow> rows{};
    /// Exact pieces of the surface, of the same atoms: cavities are listed with their areas and volumes. Nothing: those
    /// of the mesh, with the plain sums over its triangles.
    std::span<const SurfaceComponent> components{};
    ExactSurface exact{};  ///< of the structure's atoms, where there is one already: nothing of it is built again
    int threads = 0;       ///< 0: all cores; the page does not depend on it
};

/// True unless the library was built without three.js (CMake's MENISCUS_PAGE=OFF).
bool pages_supported();

/// The page, as HTML.
///
/// It holds the mesh, rounded to 1/512 Å, the atoms, the colours of every scheme that the structure has something for,
/// and a picture for browsers without WebGL 2 (docs/conventions.md). Whatever the structure calls its atoms is text
/// there, never markup.
///
/// mesh     with normals, atoms and patches; curvatures are shown if it has them; without triangles the atoms alone
/// throws   UsageError for arrays that are missing or whose sizes do not match, an atom that the structure does not
///          have, options as of draw_picture() and colour_vertices(); LimitError for more than 2^24 atoms;
///          std::runtime_error without three.js
/// cost     O(n log n); most of it goes into depth_values() and into light
std::string make_page(const Mesh& mesh, const Structure& structure, const PageOptions& options = {});

/// Writes a page, as write_mesh() writes meshes: whole or not at all.
/// throws   as make_page(); OutputError
void write_page(const std::string& path, const Mesh& mesh, const Structure& structure, const PageOptions& options = {});

}  // namespace meniscus
