// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// STL: triangles without shared vertices, binary or text.
#pragma once

#include "meniscus/write.h"
#include "platform/files/atomic_file.h"

namespace meniscus {

/// Writes triangles as STL with the normals of the flat facets (zero for a facet without area).
/// Binary STL has single precision only: far off the origin corners may come to coincide; text has all digits.
/// throws   LimitError for more than 2^32 - 1 triangles in binary
void write_stl(AtomicFile& file, const Mesh& mesh, Encoding encoding);

}  // namespace meniscus
