// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// All that a page knows of its surface, as one block of bytes for viewer/decode.js.
#pragma once

#include <string>
#include <vector>

#include "meniscus/page.h"
#include "page/mesh_streams.h"

namespace meniscus::page {

/// Four bytes with the length of a JSON text, lowest first, that text, then the streams it names.
/// Precondition: everything has passed the checks of write_page().
std::string page_data(const Mesh& mesh, const Structure& structure, const PageOptions& options,
                      const VertexExtras& extras);

}  // namespace meniscus::page
