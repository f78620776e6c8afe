// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Writers: meshes, kept atoms and tables of measures, as files that other programs read.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "meniscus/colour.h"
#include "meniscus/mesh.h"
#include "meniscus/picture.h"
#include "meniscus/structure.h"
#include "meniscus/surface.h"
#include "meniscus/tables.h"

namespace meniscus {

enum class Encoding { Binary, Text };

/// One more value per vertex; the name must be a word that the format can hold.
struct VertexArray {
    std::string name;
    std::variant<std::span<const std::uint32_t>, std::span<const float>> values;
};

struct WriteOptions {
    Encoding encoding = Encoding::Binary;  ///< of PLY and STL; OBJ and OFF are text
    /// Written by formats with named vertex values (PLY, GLB, VTP, NPZ), after the mesh's own.
    std::vector<VertexArray> extra{};
    std::span<const Colour> colours{};     ///< one per vertex, or none; written by PLY, GLB, VTP and NPZ
    const Structure* structure = nullptr;  ///< whose atoms the mesh's `atoms` index; adds the vertex array `residue`
    const SurfaceOptions* computed_with = nullptr;  ///< written by NPZ, beside the structure
    std::optional<double> probe{};                  ///< probe radius, Å; written by GLB, VTP and MSMS pairs
    /// No side of a triangle is known to be shorter, Å, as MeshMeasures tells: spares a look at all of them.
    double shortest_edge = 0.0;
    bool open = false;  ///< a part of a surface: formats with a place for it say so
    int threads = 0;    ///< 0: all cores
};

/// Writes a mesh; the suffix of `path` chooses the format: .ply .obj .stl .off .glb .vtp .npz .vert (and .face beside
/// it, see write_msms()).
///
/// Written to a temporary name in the same folder and renamed: a failed run leaves no half file and an older file as it
/// was. Devices and pipes (/dev/stdout) are written to directly. Coordinates are rounded to single precision unless
/// that would move them by 1e-4 Å or make two corners of a triangle coincide; then they are written in full. (Binary
/// STL and GLB have single precision only.)
/// throws   UsageError for an unknown suffix or arrays whose sizes do not match; LimitError for more triangles than the
///          format can count and for numbers beyond its reach (GLB: whole numbers above 2^24, files above 4 GiB);
///          OutputError when the file cannot be written
void write_mesh(const std::string& path, const Mesh& mesh, const WriteOptions& options = {});

/// What stands above the vertices and the faces of an MSMS pair.
enum class MsmsHeader {
    Full,       ///< three lines, as MSMS writes them: of what, heads, numbers
    CountOnly,  ///< three lines, as NanoShaper writes them: the third has the count alone
    None,
};

/// What a pair of MSMS files tells beside the mesh.
struct MsmsOptions {
    std::string title{};                      ///< name of the input, for the first line
    std::size_t spheres = 0;                  ///< in the input
    double density = 0.0;                     ///< vertices per Å²
    double probe = 0.0;                       ///< probe radius, Å
    std::span<const std::string> names = {};  ///< of the spheres, words; none: vertices have nine fields instead of ten
    MsmsHeader header = MsmsHeader::Full;
};

/// Writes STEM.vert and STEM.face as MSMS 2.6.1 does: per vertex position and normal with three decimals, 0, the
/// nearest sphere from 1 on, 1, 2 or 3 for toroidal, reentrant or contact, and its name; per triangle the corners from
/// 1 on, the same kind, and 1. (Numbers of analytical faces, for which the 0 and the last 1 stand, are not kept.)
///
/// Both files appear whole or not at all. Vertices that would coincide when rounded are moved by 0.001 Å.
/// throws   UsageError for a mesh without normals, atoms or patches, and for names that are no words or too few;
///          LimitError for coordinates wider than their nine columns and more than 2^31 - 1 items; OutputError
void write_msms(const std::string& stem, const Mesh& mesh, const MsmsOptions& options);

/// Writes a picture as PNG, with eight bits per channel in sRGB and an alpha channel if a pixel is not opaque.
/// throws   UsageError for a number of pixels that is zero or does not match the size; OutputError
void write_picture(const std::string& path, const Picture& picture);

/// Writes the kept atoms as "x y z radius" (.xyzr) or "x y z radius 1 ATOM_RESIDUE_NUMBER_CHAIN" (.xyzrn), Å, with
/// enough digits to read the same numbers back.
/// throws   as write_mesh
void write_spheres(const std::string& path, const Structure& structure);

/// Writes the table of kept atoms that a mesh's `atoms` indexes (NAME.atoms.csv), comma-separated as RFC 4180 says.
/// throws   OutputError
void write_atom_table(const std::string& path, const Structure& structure);

/// Writes a table as comma-separated text (.csv, RFC 4180; empty cells are empty fields) or as a JSON list with one
/// object per row (.json; empty cells and numbers that are not finite are null). Numbers have all their digits.
/// throws   UsageError for another suffix or a row with too few or too many cells; OutputError
void write_table(const std::string& path, const Table& table);

/// Writes the kept atoms as PDB (.pdb) or mmCIF (.cif) with one value per atom in the place of the B factor.
///
/// PDB holds values from -99.99 to 999.99 with two digits after the point, mmCIF any with six significant digits.
/// Serial numbers are given anew, from 1; charges that are no whole numbers are left out.
/// throws   UsageError for another suffix or a number of values that does not match; OutputError where PDB has no room:
///          a chain name of more than one letter, an atom name of more than four, a residue name of more than three,
///          more than 87,440,031 atoms, a coordinate, residue number or value too large (the message suggests .cif)
void write_structure_copy(const std::string& path, const Structure& structure, std::span<const double> values);

}  // namespace meniscus
