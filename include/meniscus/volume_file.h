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
/// byte orders, any order of the axes; the frame is that of ORIGIN, and where that is zero, of NSTART. Lengths are Å.
/// throws   UsageError for another suffix; InputError in one line, "FILE:LINE:COLUMN: what is wrong; what to do" (MRC:
///          "FILE:byte N (FIELD): ..."), for everything that is not such a file, for skew axes and cells, and for
///          values that are not finite. Nothing is allocated that the file is too short to hold
/// cost     DX 0.1 µs per value
Volume read_volume(const std::string& path);

/// The grid alone, which is in the first lines of the file; the values are not looked at.
VolumeGrid read_volume_grid(const std::string& path);

/// Writes a volume; the suffix of `path` chooses the format: .dx (OpenDX text), .mrc (MRC2014, mode 2), and in builds
/// with OpenVDB .vdb.
///
/// What the values are, with the sign convention, stands in the comments (DX), the labels (MRC) or the metadata (VDB).
/// VDB has distances by its own convention, negative inside, as a level set of class "level set": kept within three
/// voxels of the surface, beyond that only their sign. The others are kept where they differ from the value outside.
/// DX and MRC are streamed; every format has the file appear whole or not at all, as with write_mesh().
/// throws   UsageError for an unknown suffix, for a number of values that is not that of the nodes, for .vdb in builds
///          without OpenVDB and for spacings that differ by axis there; LimitError for a count that the format cannot
///          hold (MRC and VDB: 2^31 - 1 per axis); OutputError
void write_volume(const std::string& path, const Volume& volume, VolumeContent content);

/// Whether this build writes .vdb.
bool vdb_supported();

}  // namespace meniscus
