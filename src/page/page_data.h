// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// All that a page knows of its surface, as one block of bytes for viewer/decode.js.
#pragma once

#include <string>
#include <vector>

#include "meniscus/page.h"
#include "page/mesh_streams.h"

namespace meniscus::page {

/// A cavity as a page lists it.
struct ListedCavity {
    double area = 0.0;    ///< Å²
    double volume = 0.0;  ///< Å³, positive
    Vec3 centre;
    double radius = 0.0;          ///< of what one wants to see of it, Å
    std::uint32_t component = 0;  ///< of the mesh; kNone if it has no such piece
    std::string lining{};         ///< the residues around it
};

/// By falling volume; from options.components if there are any, else from the mesh.
std::vector<ListedCavity> list_cavities(const Mesh& mesh, const Structure& structure, const PageOptions& options);

/// Four bytes with the length of a JSON text, lowest first, that text, then the streams it names.
/// Precondition: everything has passed the checks of write_page().
std::string page_data(const Mesh& mesh, const Structure& structure, const PageOptions& options,
                      const VertexExtras& extras);

}  // namespace meniscus::page
