// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Structure files -> atoms with radii, with a full account of what was kept, dropped and assumed.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meniscus/atoms.h"
#include "meniscus/option.h"

namespace meniscus {

enum class HydrogenPolicy {
    Auto,  ///< kept if the structure has them (docs/conventions.md) and the radius set is not of united atoms
    Keep,
    Drop,
};

/// Hetero groups beside the polymer, to which modified residues linked into it belong; waters are separate.
enum class HeteroPolicy {
    None,
    Ligands,  ///< groups of two or more atoms in the file: cofactors, sugars, lipids, buffer molecules
    All,      ///< also groups of one atom: ions, metals
};

/// "hetero = ligands".
std::string spell_as_member(std::string_view option, std::string_view value);

/// What to read and keep. The defaults are those of the command line (docs/conventions.md).
struct ReadOptions {
    std::string radii = "auto";  ///< auto, bondi, united, protor, naccess, parse, or the path of a file of rules
    HydrogenPolicy hydrogens = HydrogenPolicy::Auto;
    int model = 1;                         ///< position of the model in the file, from 1
    bool join_models = false;              ///< all models together as one structure; `model` is then not used
    std::string assembly = {};             ///< biological assembly; empty: as deposited
    std::string altloc = {};               ///< one letter; empty: highest summed occupancy per residue
    std::vector<std::string> chains = {};  ///< author names, "label:X" for mmCIF label names; empty: all
    /// Of the file before any copying; in gemmi's syntax, or as PyMOL and VMD have it ("chain A and resi 10-50") where
    /// that can be put exactly into gemmi's. Empty: all.
    std::string select = {};
    std::optional<HeteroPolicy> hetero = {};    ///< empty: None, but All of files with radii, and without a polymer
    std::optional<bool> keep_waters = {};       ///< empty: no, but those of files with radii, with a warning
    bool strict_radii = false;                  ///< an unknown atom type is an InputError
    bool checksum = true;                       ///< Structure::sha256 is found, in a millisecond per 1.5 MB
    OptionSpelling spelling = spell_as_member;  ///< of options in Structure::notes and Structure::warnings
};

/// A residue that has at least one kept atom.
struct Residue {
    std::string chain;  ///< author name; copies made by an assembly or found in joined models are A-2, A-3 ...
    std::string name;
    int number = 0;
    char insertion_code = ' ';
};

/// What is known of a kept atom beside its centre and radius.
struct AtomLabel {
    std::uint32_t residue = 0;  ///< index into Structure::residues
    std::string name;
    std::string element;  ///< "C", "FE"; empty where the format does not tell
    char altloc = ' ';
    int serial = 0;
    double b_factor = 0.0;
    double occupancy = 1.0;
    double charge = 0.0;  ///< e; from PQR or PDBQT, else the formal charge
};

/// A structure ready for the surface. atoms and labels are in file order and have the same size.
struct Structure {
    std::string file;       ///< as given; "-" for standard input
    std::string name;       ///< stem for output files: "1ubq" for "dir/1ubq.pdb.gz", "stdin" for "-"
    std::string sha256;     ///< of the bytes of the file as found, hexadecimal; empty without ReadOptions::checksum
    std::string radii_set;  ///< the set in use: bondi, united, ..., "file" for radii from PQR or xyzr, or a path
    Atoms atoms;
    std::vector<AtomLabel> labels;
    std::vector<Residue> residues;
    /// Atoms left out, by reason: chains, unselected, altlocs, waters, hetero, hydrogens, zero_radius, assembly.
    std::map<std::string, std::size_t> dropped;
    /// Ligands left out: names of residues, and how many there were of each. They may fill cavities.
    std::map<std::string, std::size_t> left_out_ligands;
    std::vector<std::string> notes;  ///< what ordinary files bring with them, such as waters left out: a line per kind
    std::vector<std::string> warnings;  ///< assumptions that may make a number wrong: a line per kind
};

/// Reads PDB, mmCIF, BinaryCIF, GROMACS, PDBQT, PQR, xyzr or xyzrn, each possibly gzipped; "-" reads standard input,
/// told by content.
///
/// Every coordinate, radius and charge must be a finite number in full. Where models after the first have chains that
/// the first one lacks, they are partners and not copies; a warning names them then.
/// throws   InputError "FILE:LINE:COLUMN: what; what to do"; UsageError for an unknown option value
/// cost     O(size of the file)
Structure read_structure(const std::string& path, const ReadOptions& options = {});

/// "1UBQ is not a file; Meniscus does not download: get 1ubq.cif from the PDB (...)" for a path that is no file but an
/// identifier of the PDB, of UniProt or of AlphaFold DB, as read_structure() says it; else empty.
std::string explain_identifier(const std::string& path);

/// For each atom whether a selection names it, in the syntax of ReadOptions::select, by the structure's own names:
/// copies of an assembly are chains of their own.
///
/// option   named in messages
/// throws   UsageError for an expression that is not valid or selects nothing
std::vector<bool> select_atoms(const Structure& structure, const std::string& expression,
                               const std::string& option = "selection");

/// How select_atoms() understands an expression that is not in gemmi's syntax: "//A/10-50" for "chain A and resi
/// 10-50",
/// "(HEM)" for "HEM" where no chain and no atom has that name. Empty for what is taken as it stands.
/// throws   UsageError for an expression that is not valid
std::string restate_selection(const Structure& structure, const std::string& expression,
                              const std::string& option = "selection");

/// The chains of a structure, each a structure of its own with the same radii, in the order of their first atoms.
std::vector<Structure> split_chains(const Structure& structure);

/// All models of a file as structures of their own, in file order (options.model and options.join_models are ignored).
/// Their names are those of the file with _m01, _m02 ... behind.
/// throws   as read_structure, for the first model that cannot be read
std::vector<Structure> read_all_models(const std::string& path, const ReadOptions& options = {});

}  // namespace meniscus
