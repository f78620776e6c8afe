// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// OBJ: positions and normals, as text.
#pragma once

#include "meniscus/mesh.h"
#include "platform/files/atomic_file.h"

namespace meniscus {

/// Writes a mesh as Wavefront OBJ: v, vn if the mesh has normals, and f a//a b//b c//c (or f a b c), counted from 1.
/// open   a comment says that the mesh is part of a surface
void write_obj(AtomicFile& file, const Mesh& mesh, bool open);

}  // namespace meniscus
