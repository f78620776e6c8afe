// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Values from other sources at the vertices of a mesh: values of atoms, residues and chains, and of maps.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "meniscus/colour.h"
#include "meniscus/mesh.h"
#include "meniscus/structure.h"
#include "meniscus/volume.h"

namespace meniscus {

/// One value for each atom of a structure.
struct AtomValues {
    std::string name;
    std::vector<double> of_atom;  ///< in the order of the atoms; NaN where there is none
};

/// What read_value_table() finds in a table.
struct ValueTable {
    std::vector<AtomValues> columns;
    std::size_t rows = 0;
    std::size_t strange_rows = 0;      ///< number of rows that match nothing in the structure
    std::vector<std::string> texts{};  ///< names of the columns skipped because none of their cells is a number
};

/// Reads values by atom, residue or chain from a table (.csv, also .csv.gz) with one line of column names; cells are
/// separated by commas, semicolons or tabs.
///
/// The columns that say what a row is about are named as in tables of measures: index; or serial; or chain, resnum,
/// icode, name and altloc, of which chain may be missing if the structure has only one. If several are given, or
/// resname, they must agree with the structure. All other columns are values, one array each. An empty cell, NA or nan
/// is no value; true and false are 1 and 0. Columns without any number are skipped. In a table of several interfaces,
/// with a column `interface` and a row per residue for each, every interface gets its own arrays: buried_sas_A_B for
/// A:B.
///
/// throws   InputError "FILE:LINE:COLUMN: what; what to do"
/// cost     O(n log n)
ValueTable read_value_table(const std::string& path, const Structure& structure);

/// Refuses a table that belongs to another structure.
/// throws   InputError for a table of which no row matches anything in the structure
void refuse_strange_table(const ValueTable& table, const std::string& path, const Structure& structure);

/// Whether values may have a name: a letter or '_', then letters, digits and '_', but not the name of a vertex array
/// that surfaces have anyway, in upper or lower case.
bool is_value_name(const std::string& name);

/// Gives each vertex the value of its nearest atom.
/// throws   UsageError for a mesh without `atoms`, or with an atom beyond AtomValues::of_atom
VertexValues values_at_vertices(const Mesh& mesh, const AtomValues& values);

/// The values of atoms that a scheme shows: the B factors, called bfactor or plddt, for BFactor and Plddt; nothing for
/// other schemes.
std::optional<AtomValues> values_of_scheme(ColourScheme scheme, const Structure& structure);

/// How the values of a map are taken at the vertices.
struct SampleVolumeOptions {
    Interpolation interpolation = Interpolation::Linear;
    double offset = 0.0;  ///< Å along the normal: positive into the solvent, negative into the molecule
};

/// The values of a map at the vertices; NaN at vertices outside the map.
///
/// name     of the array returned
/// throws   UsageError for an offset that is not finite, or not zero for a mesh without normals
VertexValues sample_volume(const Mesh& mesh, const std::string& name, const Volume& volume,
                           const SampleVolumeOptions& options = {});

/// The array of Mesh::values that has a name.
/// throws   UsageError for a mesh without such an array
const VertexValues& values_named(const Mesh& mesh, const std::string& name);

/// The range from the smallest to the largest finite value, extended to be symmetric about zero if both signs occur; 0
/// to 1 if no value is finite.
ValueRange range_of(const VertexValues& values);

}  // namespace meniscus
