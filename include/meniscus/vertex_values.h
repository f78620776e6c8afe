// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Values from elsewhere at the vertices of a mesh: of atoms, residues and chains, and of maps.
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

/// One value for each of a structure's atoms, NaN where there is none.
struct AtomValues {
    std::string name;
    std::vector<double> of_atom;
};

/// A table of values, as read_value_table() found it.
struct ValueTable {
    std::vector<AtomValues> columns;
    std::size_t rows = 0;
    std::size_t strange_rows = 0;      ///< that name nothing of the structure
    std::vector<std::string> texts{};  ///< columns left alone, since no cell of theirs is a number
};

/// Reads values by atom, residue or chain from comma-separated text with one line of names (.csv, also .csv.gz); cells
/// may also be separated by semicolons or tabs.
///
/// What a row is about is told by columns named as in tables of measures: index, or chain, resnum, icode, name, altloc,
/// or serial; chain is not needed where the structure has one only. What of these, and of resname, stands beside an
/// index, or beside a residue's number, must agree with the structure. All other columns are values, one array each;
/// an empty cell, NA or nan is no value, true and false are 1 and 0. Columns of which no cell is a number are left
/// alone. In tables of several interfaces, which have a column `interface` and name a residue once for each of them,
/// every interface has arrays of its own: buried_sas_A_B for A:B. throws   InputError "FILE:LINE:COLUMN: what; what to
/// do" cost     O(n log n)
ValueTable read_value_table(const std::string& path, const Structure& structure);

/// throws   InputError for a table whose rows all name something that the structure does not have
void refuse_strange_table(const ValueTable& table, const std::string& path, const Structure& structure);

/// Whether values may have this name: a letter or '_', then letters, digits and '_'; no vertex array of the surface
/// itself has it.
bool is_value_name(const std::string& name);

/// At each vertex the value of its nearest atom.
/// throws   UsageError for a mesh without atoms, or with one that has no value here
VertexValues values_at_vertices(const Mesh& mesh, const AtomValues& values);

/// The values that a scheme brings along: B factors, named bfactor or plddt, for the schemes of these names; nothing
/// for all others.
std::optional<AtomValues> values_of_scheme(ColourScheme scheme, const Structure& structure);

struct SampleVolumeOptions {
    Interpolation interpolation = Interpolation::Linear;
    double offset = 0.0;  ///< Å along the normal, into the solvent; negative: into the molecule
};

/// The values of a map at the vertices, NaN at those beyond its ends.
///
/// throws   UsageError for an offset that is not finite, or one other than zero for a mesh without normals
VertexValues sample_volume(const Mesh& mesh, const std::string& name, const Volume& volume,
                           const SampleVolumeOptions& options = {});

/// The values of that name.
/// throws   UsageError for a mesh without them
const VertexValues& values_named(const Mesh& mesh, const std::string& name);

/// From the smallest value to the largest; if they have both signs, as far to either side of zero.
/// returns  0 to 1 where there is none
ValueRange range_of(const VertexValues& values);

}  // namespace meniscus
