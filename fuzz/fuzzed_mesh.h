// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Meshes from fuzzed files.
#pragma once

#include "fuzzed_file.h"

namespace meniscus::fuzz {

/// Reads a mesh; the corners of its triangles must name vertices, and its coordinates be finite.
///
/// named    what messages begin with: the path, or what the paths of a pair have in common
void read_mesh_or_refuse(const std::string& path, const std::string& named);

/// Writes the bytes and reads them.
inline int run_mesh(const FuzzedFile& file, const std::uint8_t* data, std::size_t size) {
    file.write(text_of(data, size));
    read_mesh_or_refuse(file.path(), file.path());
    return 0;
}

}  // namespace meniscus::fuzz
