// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Writers of meshes, kept atoms, pictures and tables of measures, as files that other programs read.
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
#include "meniscus/pockets.h"
#include "meniscus/structure.h"
#include "meniscus/surface.h"
#include "meniscus/tables.h"
#include "meniscus/tunnels.h"

namespace meniscus {

/// How numbers are stored in a file.
enum class Encoding { Binary, Text };

/// A further vertex array. Its name must be a single word that no other vertex array has.
struct VertexArray {
    std::string name;
    std::variant<std::span<const std::uint32_t>, std::span<const float>> values;
};

/// A mesh beside another one, under a name, in one colour, whose alpha is its opacity, or with colours of its vertices.
struct NamedMesh {
    std::string name;
    Mesh mesh;  ///< with normals
    Colour colour{};
    std::vector<Colour> colours{};  ///< one per vertex instead, or none
};

/// What is written beside the mesh, and how.
struct WriteOptions {
    Encoding encoding = Encoding::Binary;  ///< for PLY and STL; OBJ and OFF are always text
    /// Vertex arrays written after those of the mesh, by formats that name them (PLY, GLB, VTP, NPZ).
    std::vector<VertexArray> extra{};
    std::span<const Colour> colours{};     ///< one per vertex, or none; written by PLY, GLB, VTP and NPZ
    const Structure* structure = nullptr;  ///< the structure that Mesh::atoms index; adds the vertex array `residue`
    const Bodies* beside = nullptr;        ///< ligands; written by GLB as a node of that name beside the surface
    std::span<const NamedMesh> named{};    ///< pockets and tunnels; written by GLB as a node each
    const SurfaceOptions* computed_with = nullptr;  ///< written by NPZ together with the structure
    std::optional<double> probe{};                  ///< probe radius, Å; written by GLB, VTP and MSMS pairs
    /// A lower bound of the length of all edges, Å, such as MeshMeasures::shortest_edge, to save a search; 0: unknown.
    double shortest_edge = 0.0;
    bool open = false;  ///< the mesh is an open part of a surface; formats that can say so do
    int threads = 0;    ///< 0: all cores
};

/// Writes a mesh; the suffix of `path` chooses the format: .ply .obj .stl .off .glb .vtp .npz .vert (and .face beside
/// it, see write_msms()).
///
/// The file appears whole or not at all: it is written under a temporary name in the same folder and then renamed.
/// Devices and pipes (/dev/stdout) are written to directly. Coordinates (Å) are rounded to single precision unless that
/// would move them by 1e-4 Å or make two corners of a triangle coincide; then they are written in full. (Binary STL and
/// GLB have single precision only.)
///
/// throws   UsageError for an unknown suffix, an array name that is not a word or is taken, or arrays whose sizes do
///          not match; LimitError for more triangles than the format can count and for numbers beyond its range (GLB:
///          whole numbers above 2^24, files above 4 GiB); OutputError for a file that cannot be written
void write_mesh(const std::string& path, const Mesh& mesh, const WriteOptions& options = {});

/// The header of both files of an MSMS pair.
enum class MsmsHeader {
    Full,       ///< three lines, as MSMS writes them: title, column heads, numbers
    CountOnly,  ///< three lines, as NanoShaper writes them: the third holds only the number of vertices or faces
    None,       ///< no line
};

/// What a pair of MSMS files holds beside the mesh.
struct MsmsOptions {
    std::string title{};                      ///< name of the input, for the first line
    std::size_t spheres = 0;                  ///< number of spheres in the input
    double density = 0.0;                     ///< vertices per Å²
    double probe = 0.0;                       ///< probe radius, Å
    std::span<const std::string> names = {};  ///< one word per sphere; none: vertices have nine fields instead of ten
    MsmsHeader header = MsmsHeader::Full;
};

/// Writes STEM.vert and STEM.face as MSMS 2.6.1 does. Each vertex has position (Å) and normal with three decimals, 0,
/// the number of the nearest sphere from 1, the kind of patch (1 toroidal, 2 reentrant, 3 contact) and the name of the
/// sphere; each triangle has its corners from 1, the kind of patch, and 1. The 0 and the last 1 replace the numbers of
/// analytical faces, which are not kept.
///
/// Both files appear whole or not at all. Vertices that would coincide when rounded are moved by 0.001 Å.
///
/// throws   UsageError for a mesh without normals, atoms or patches, and for names that are not words or too few;
///          LimitError for coordinates too wide for nine columns and for more than 2^31 - 1 items; OutputError for a
///          file that cannot be written
void write_msms(const std::string& stem, const Mesh& mesh, const MsmsOptions& options);

/// Writes a picture as PNG, with eight bits per channel in sRGB and an alpha channel if a pixel is not opaque.
/// throws   UsageError for a number of pixels that is zero or does not match the size; OutputError as write_mesh()
void write_picture(const std::string& path, const Picture& picture);

/// Writes the kept atoms as "x y z radius" (.xyzr) or "x y z radius 1 ATOM_RESIDUE_NUMBER_CHAIN" (.xyzrn), Å, with
/// enough digits to read the same numbers back.
/// throws   UsageError for another suffix; OutputError as write_mesh()
void write_spheres(const std::string& path, const Structure& structure);

/// Writes the table of the kept atoms, which Mesh::atoms index (NAME.atoms.csv), as comma-separated text (RFC 4180).
/// throws   OutputError as write_mesh()
void write_atom_table(const std::string& path, const Structure& structure);

/// Writes a table as comma-separated text (.csv, RFC 4180; empty cells are empty fields) or as a JSON list with one
/// object per row (.json; empty cells and numbers that are not finite are null). Numbers have all their digits.
/// throws   UsageError for another suffix or a row with too few or too many cells; OutputError as write_mesh()
void write_table(const std::string& path, const Table& table);

/// Writes the kept atoms as PDB (.pdb) or mmCIF (.cif) with one value per atom instead of the B factor.
///
/// PDB holds values from -99.99 to 999.99 with two digits after the point, mmCIF any with six significant digits.
/// Atoms are numbered anew from 1; charges that are not whole numbers are left out.
///
/// throws   UsageError for another suffix or a number of values that does not match; OutputError where PDB has no room:
///          a chain name of more than one letter, an atom name of more than four, a residue name of more than three,
///          more than 87,440,031 atoms, a coordinate, residue number or value too large (the message suggests .cif)
void write_structure_copy(const std::string& path, const Structure& structure, std::span<const double> values);

/// The ways that are written beside pockets.
struct PathsOfPockets {
    std::vector<TunnelPath> tunnels;
    std::optional<TunnelPath> pore;
};

/// Writes the kept atoms and pockets as PDB (.pdb) or mmCIF (.cif).
///
/// The B factor of an atom is the rank of the pocket whose wall has most of it, 0 for none. The grid points of each
/// pocket are atoms APOL of a residue STP, as fpocket calls them, whose number is the pocket's rank.
/// The points of tunnels are atoms PATH of residues TUN, numbered from 1, those of the pore of a residue POR; their B
/// factors are radii, Å.
///
/// throws   as write_structure_copy()
void write_pocket_atoms(const std::string& path, const Structure& structure, const Pockets& pockets,
                        const PathsOfPockets& paths = {});

/// Writes pockets, their voxels, and what the ranking knows of its points, as arrays for numpy.load (.npz).
///
/// Their names and types are in docs/reference/pockets.md; indices are int32, -1 for none.
/// throws   UsageError in a build without zlib; OutputError as write_mesh()
void write_pocket_arrays(const std::string& path, const Pockets& pockets);

}  // namespace meniscus
