// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Files of values on a regular grid: OpenDX, MRC and CCP4, OpenVDB.
#pragma once

#include <string>

#include "meniscus/volume.h"

namespace meniscus {

/// Reads OpenDX (.dx) as APBS writes it, or MRC and CCP4 maps (.mrc .map .ccp4), each also gzipped (.gz).
///
/// OpenDX: regular positions whose steps lie along the axes, one value per node as text. MRC: modes 0, 1, 2 and 6, both
/// byte orders, any order of the axes; the origin is that of ORIGIN or, if ORIGIN is zero, of NSTART. Lengths are Å.
///
/// throws   UsageError for another suffix; InputError in one line, "FILE:LINE:COLUMN: what is wrong; what to do" (MRC:
///          "FILE:byte N (FIELD): ..."), for any other file, for skew axes and cells, and for values that are not
///          finite. Memory is allocated only after sizes are checked against the length of the file
/// cost     DX 0.1 µs per value
Volume read_volume(const std::string& path);

/// Reads only the grid, from the head of the file; values are not checked.
/// throws   as read_volume()
VolumeGrid read_volume_grid(const std::string& path);

/// Writes a volume; the suffix of `path` chooses the format: .dx (OpenDX text), .mrc (MRC2014, mode 2), and in builds
/// with OpenVDB .vdb.
///
/// Comments (DX), labels (MRC) or metadata (VDB) say what the values mean, with the sign convention. VDB holds
/// distances by its own convention, negative inside, as a level set: beyond three voxels from the surface only the sign
/// is kept. Other values are stored in VDB only where they differ from the value outside. DX and MRC are streamed. The
/// file appears whole or not at all, as with write_mesh().
///
/// throws   UsageError for an unknown suffix, for a number of values that is not that of the nodes, for .vdb in builds
///          without OpenVDB, and for .vdb with spacings that differ by axis; LimitError for a count that the format
///          cannot hold (MRC and VDB: 2^31 - 1 per axis); OutputError for a file that cannot be written
void write_volume(const std::string& path, const Volume& volume, VolumeContent content);

/// Whether this build writes .vdb.
bool vdb_supported();

}  // namespace meniscus
