// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// VTP: VTK's XML files of polygons, which ParaView, PyVista and VTK's own programs read.
#pragma once

#include "meniscus/write.h"
#include "platform/files/atomic_file.h"

namespace meniscus {

/// Writes a mesh as VTK XML PolyData 1.0 with raw appended data (little-endian, 64-bit headers and indices, not
/// compressed).
///
/// Points are Float32, or Float64 where io/precision.h says so. Point data, those that the mesh has: Normals (Float32,
/// the active normals), atom, component (UInt32), patch (UInt8), the measured ones (Float32), options.extra, colors
/// (four UInt8, the active scalars). Field data: probe, if options.probe is given; open, the
/// number 1, for a mesh that is.
void write_vtp(AtomicFile& file, const Mesh& mesh, const WriteOptions& options);

}  // namespace meniscus
