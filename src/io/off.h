// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// OFF: positions and triangles, as text.
#pragma once

#include "meniscus/mesh.h"
#include "platform/files/atomic_file.h"

namespace meniscus {

/// Writes positions and triangles as OFF.
/// open   a comment says that the mesh is part of a surface
void write_off(AtomicFile& file, const Mesh& mesh, bool open);

}  // namespace meniscus
