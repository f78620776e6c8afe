// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What a page needs to know of a surface, checked and worked out.
#pragma once

#include "meniscus/page.h"
#include "page/mesh_streams.h"

namespace meniscus::page {

/// The light and the depth of every vertex.
/// throws   as page_content()
VertexExtras checked_extras(const Mesh& mesh, const Structure& structure, const PageOptions& options);

/// The colours of a scheme, each once: those of its legend.
std::vector<Colour> colours_shown(const Mesh& mesh, const Structure& structure, const ColourOptions& options);

/// The content by light and depth that are known.
PageContent content_by(const VertexExtras& extras, const Mesh& mesh, const Structure& structure,
                       const PageOptions& options);

}  // namespace meniscus::page
