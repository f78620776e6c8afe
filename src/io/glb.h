// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// GLB: binary glTF 2.0, which viewers of 3D models, web pages and presentation programs read.
#pragma once

#include "meniscus/write.h"
#include "platform/files/atomic_file.h"

namespace meniscus {

/// Writes a mesh as binary glTF 2.0: one node without a transformation, one primitive with 32-bit indices.
///
/// Coordinates are those of the mesh in single precision, one unit per Å (glTF itself speaks of metres), not turned.
/// Vertex attributes, those that the mesh has: POSITION, NORMAL (float), COLOR_0 (linear, not sRGB; four normalised
/// 16-bit numbers) if options.colours are given, and, all float, _ATOM, _PATCH, _COMPONENT, _AREA, _MEAN_CURVATURE,
/// _GAUSSIAN_CURVATURE, _SHAPE_INDEX, then options.extra in its order: "residue" is _RESIDUE. The asset's extras tell
/// the unit and, if options.probe is given, the probe radius. A mesh that is open is
/// drawn from both sides, and the extras say "open": true. options.named are further nodes, each with a material of its
/// own, which is blended unless it is opaque. An empty mesh gives a file with an empty scene.
/// throws   LimitError for a file of more than 4 GiB and for whole numbers above 2^24, which float does not hold;
///          UsageError for numbers that are not finite and for names with other letters than A-Z, a-z, 0-9 and _
void write_glb(AtomicFile& file, const Mesh& mesh, const WriteOptions& options);

}  // namespace meniscus
