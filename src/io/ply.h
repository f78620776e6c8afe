// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// PLY: the only format here that carries every array of a mesh.
#pragma once

#include "meniscus/write.h"
#include "platform/files/atomic_file.h"

namespace meniscus {

/// Writes a mesh as PLY 1.0, little-endian binary or text.
///
/// Vertex properties, those that the mesh has: x y z (float, or double where io/precision.h says so), nx ny nz (float),
/// atom (uint), patch (uchar), component (int), area, mean_curvature, gaussian_curvature, shape_index (float), then
/// options.extra in its order (uint or float), red green blue alpha (uchar) if options.colours are given. Faces:
/// vertex_indices (list uchar int; uint from 2^31 vertices on).
void write_ply(AtomicFile& file, const Mesh& mesh, const WriteOptions& options);

}  // namespace meniscus
