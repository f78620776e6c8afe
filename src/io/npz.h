// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// NPZ: arrays by name, which numpy.load reads.
#pragma once

#include "meniscus/write.h"
#include "platform/files/atomic_file.h"

namespace meniscus {

/// Writes a mesh, and the atoms and options that it was made of where they are given, as a ZIP archive of .npy files
/// (version 1.0) without pickled objects.
///
/// vertices, normals (n, 3) float64; triangles (m, 3) uint32; atom, component uint32; patch uint8; the measured ones
/// float32; options.extra; colors (n, 4) uint8. Of options.structure: atom_xyz (k, 3), atom_radius, atom_b_factor,
/// atom_occupancy, atom_charge float64; atom_residue uint32; atom_serial, atom_resnum int32; atom_chain, atom_resname,
/// atom_icode, atom_name, atom_element, atom_altloc text. Of options.computed_with: options, text (options_json.h).
/// open is the number 1 for a mesh that is; otherwise it is absent.
/// layout is the number 1, which changes when one of these does.
/// throws   UsageError for two arrays of one name and for names with / or other letters than ASCII
/// cost     25 ns per byte and core; memory for the compressed bytes of the largest array
void write_npz(AtomicFile& file, const Mesh& mesh, const WriteOptions& options);

}  // namespace meniscus
