// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Pages: one HTML file in which a browser shows a surface, to turn, cut and inspect, without network or server.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meniscus/colours.h"
#include "meniscus/describe_pockets.h"
#include "meniscus/measures.h"
#include "meniscus/mesh.h"
#include "meniscus/picture.h"
#include "meniscus/structure.h"
#include "meniscus/surface.h"

namespace meniscus {

/// A number that a page shows beside the surface, such as {"Exact", "area", "4613.9 Å²"}.
struct PageRow {
    std::string section;  ///< heading above consecutive rows of the same section
    std::string label;
    std::string value;
};

/// The numbers of a surface for PageOptions::rows: exact measures, measures of the mesh, its origin, its checks.
///
/// structure  the atoms of the surface; its file, if there is one, is named without folders
/// exact      measures of the same atoms and probe
std::vector<PageRow> page_rows(const Structure& structure, const Surface& surface, const Measures& exact);

/// The same numbers without the exact measures.
std::vector<PageRow> page_rows(const Structure& structure, const Surface& surface);

/// A pocket in the list of a page.
struct PagePocket {
    std::string name;  ///< "1", or the place that it is at
    Colour colour;
    bool cavity = false;
    double score = 0.0;
    double volume = 0.0;     ///< Å³
    double depth = 0.0;      ///< Å
    double wall_area = 0.0;  ///< Å²
    std::size_t mouths = 0;
    double mouth_area = 0.0;  ///< of all of them, Å²
    std::size_t openings = 0;
    double opening_area = 0.0;  ///< of all of them, Å²
    Vec3 centre;                ///< Å
    std::string lining{};       ///< residues, as text
    std::string ligand{};       ///< how the ligand at its place sits there, as text
};

/// A tunnel or a pore in the list of a page, with its radii for a plot.
struct PageWay {
    /// A place on it.
    struct Place {
        double distance = 0.0;  ///< from the beginning, Å
        double radius = 0.0;    ///< Å
    };
    std::string name{};              ///< "tunnel 1.2"
    std::string from{};              ///< where it begins: "pocket 1"
    std::size_t rank = 0;            ///< among those that begin there, from 1; 0 for the only one
    std::optional<Colour> colour{};  ///< of the pocket where it begins
    double radius = 0.0;             ///< of the bottleneck, Å
    double distance = 0.0;           ///< of the bottleneck, Å
    Vec3 bottleneck{};               ///< Å
    std::string atoms{};             ///< at the bottleneck, as text
    Vec3 begin{};                    ///< Å
    Vec3 end{};                      ///< Å
    double length = 0.0;             ///< Å
    double curvature = 1.0;
    std::vector<Place> profile{};  ///< from the beginning to the end
};

/// What a page shows.
struct PageOptions {
    ColourOptions colours{};               ///< the scheme shown first; its range holds for that scheme throughout
    std::optional<Viewpoint> viewpoint{};  ///< shown first; nothing: that of PictureOptions
    Projection projection = Projection::Orthographic;
    bool ligands = true;  ///< show Structure::ligands, as sticks and balls, and those of the surface where it is clear
    std::vector<PageRow> rows{};  ///< the numbers beside the surface, in the order shown
    /// Exact pieces of the same surface, for the list of cavities with their areas and volumes. Empty: the pieces of
    /// the mesh, with plain sums over the triangles.
    std::span<const SurfaceComponent> components{};
    std::vector<PagePocket> pockets{};  ///< the list of pockets, in the order shown
    const Mesh* bodies = nullptr;       ///< of pockets, with normals; `components` index `pockets`; shown clear, and
                                        ///< the surface around them at first
    std::vector<PageWay> ways{};        ///< the list of tunnels and pores, in the order shown
    const Bodies* tubes = nullptr;      ///< their tubes, solid; the surface around them is clear at first
    ExactSurface exact{};  ///< an exact surface of the structure's atoms, if there is one, to save building it again
    int threads = 0;       ///< 0: all cores; the page does not depend on it
};

/// The list of pockets that a page shows.
std::vector<PagePocket> page_pockets(std::span<const DescribedPocket> described);

/// True unless the library was built without three.js (CMake's MENISCUS_PAGE=OFF), zlib or nettle.
bool pages_supported();

/// All that a page shows, for programs that show it themselves: viewer/decode.js reads it. Any build can make it.
struct PageContent {
    std::string title;  ///< plain text
    std::string data;   ///< bytes: mesh, atoms, colours, cavities, PageOptions::rows
};

/// throws, cost   as make_page(), less what the file and its picture take
PageContent page_content(const Mesh& mesh, const Structure& structure, const PageOptions& options = {});

/// Makes a page, as HTML.
///
/// The page holds the mesh, rounded to 1/512 Å, the atoms, the colours of every scheme for which the structure has
/// data, and a picture for browsers without WebGL 2 (docs/conventions.md; none if the library draws no pictures). Names
/// in the structure are escaped: they cannot become markup.
///
/// mesh     needs normals, atoms and patches; curvatures are optional; without triangles the page shows only atoms
/// throws   UsageError for arrays that are missing or whose sizes do not match, an atom that the structure does not
///          have, and options that draw_picture() or colour_vertices() refuses; LimitError for more than 2^24 atoms;
///          std::runtime_error unless pages_supported()
/// cost     O(n log n), most of it for depth_values() and for the light that reaches each vertex
std::string make_page(const Mesh& mesh, const Structure& structure, const PageOptions& options = {});

/// Writes a page, as write_mesh() writes meshes: whole or not at all.
/// throws   OutputError for a file that cannot be written, and whatever make_page() throws
void write_page(const std::string& path, const Mesh& mesh, const Structure& structure, const PageOptions& options = {});

}  // namespace meniscus
