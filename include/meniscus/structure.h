// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Reads structure files into atoms with radii, with a full account of what was kept, dropped and assumed.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "meniscus/atoms.h"
#include "meniscus/option.h"

namespace meniscus {

/// Which hydrogen atoms are kept.
enum class HydrogenPolicy {
    Auto,  ///< kept if the structure has them (docs/conventions.md), unless the radii are of united atoms
    Keep,
    Drop,
};

/// Which hetero groups are kept. Modified residues linked into a polymer belong to the polymer; waters are separate.
enum class HeteroPolicy {
    None,
    Ligands,  ///< groups of two or more atoms in the file: cofactors, sugars, lipids, buffer molecules
    All,      ///< also groups of one atom: ions, metals
};

/// Names an option and its value as a member of ReadOptions: "hetero = ligands".
std::string spell_as_member(std::string_view option, std::string_view value);

/// What to read and keep. The defaults are those of the command line (docs/conventions.md).
struct ReadOptions {
    std::string radii = "auto";  ///< auto, bondi, united, protor, naccess, parse, or the path of a file of rules
    HydrogenPolicy hydrogens = HydrogenPolicy::Auto;
    int model = 1;                         ///< position of the model in the file, from 1
    bool join_models = false;              ///< all models together as one structure; `model` is then not used
    std::string assembly = {};             ///< name of a biological assembly in the file, "1"; empty: as deposited
    std::string altloc = {};               ///< one letter; empty: highest summed occupancy per residue
    std::vector<std::string> chains = {};  ///< author names, "label:X" for mmCIF label names; empty: all
    /// The atoms to keep, chosen before an assembly copies them, in gemmi's syntax or in the words of PyMOL and VMD
    /// ("chain A and resi 10-50") where gemmi's can say exactly the same; or several with " + " between them. Empty:
    /// all.
    std::string select = {};
    std::optional<HeteroPolicy> hetero = {};    ///< empty: None, but All for files with radii or without a polymer
    std::optional<bool> keep_waters = {};       ///< empty: no, but yes, with a warning, for files with radii
    bool strict_radii = false;                  ///< an unknown atom type is an InputError
    bool checksum = true;                       ///< compute Structure::sha256, which takes a millisecond per 1.5 MB
    OptionSpelling spelling = spell_as_member;  ///< how notes, warnings and errors name options
};

/// A residue that has at least one kept atom.
struct Residue {
    std::string chain;  ///< author name; copies made by an assembly or found in joined models are A-2, A-3 ...
    std::string name;   ///< "ALA"
    int number = 0;     ///< author number
    char insertion_code = ' ';
};

/// What is known of a kept atom beside its centre and radius.
struct AtomLabel {
    std::uint32_t residue = 0;  ///< index into Structure::residues
    std::string name;           ///< "CA"
    std::string element;        ///< "C", "FE"; empty where the format does not tell
    char altloc = ' ';          ///< alternate location; ' ' for none
    int serial = 0;             ///< as in the file
    double b_factor = 0.0;      ///< Å², or the pLDDT of a predicted model
    double occupancy = 1.0;     ///< as in the file
    double charge = 0.0;        ///< e; from PQR or PDBQT, else the formal charge
};

/// Groups beside the polymer that pictures and pages show as sticks and balls: cofactors, inhibitors, sugars, lipids;
/// neither waters nor ions nor what crystals are grown from (docs/conventions.md).
struct Ligands {
    std::vector<Vec3> centres;                        ///< Å
    std::vector<AtomLabel> labels;                    ///< of the same size; their residues are those below
    std::vector<Residue> residues;                    ///< in the order of their first atoms
    std::vector<std::array<std::uint32_t, 2>> bonds;  ///< pairs of atoms, the smaller index first, sorted
    bool in_surface = false;                          ///< the same atoms are among Structure::atoms
};

/// How many of the ligands have each name.
std::map<std::string, std::size_t> count_ligands(const Ligands& ligands);

/// A structure ready for the surface. `atoms` and `labels` have the same size, in file order for each copy or model.
struct Structure {
    std::string file;       ///< as given; "-" for standard input
    std::string name;       ///< stem for output files: "1ubq" for "dir/1ubq.pdb.gz", "stdin" for "-"
    std::string sha256;     ///< SHA-256 of the file's bytes, hexadecimal; empty without ReadOptions::checksum
    std::string radii_set;  ///< the set in use: bondi, united, ..., "file" for radii from PQR or xyzr, or a path
    Atoms atoms;
    std::vector<AtomLabel> labels;
    std::vector<Residue> residues;  ///< in the order of their first atoms
    /// Numbers of atoms left out, by reason: chains, unselected, altlocs, waters, hetero, hydrogens, zero_radius,
    /// assembly.
    std::map<std::string, std::size_t> dropped;
    /// Numbers of ligands left out, by residue name. A cavity may be the place of one of these ligands.
    std::map<std::string, std::size_t> left_out_ligands;
    Ligands ligands;  ///< of the chosen chains, atoms and alternatives; none without a polymer beside them
    std::vector<std::string> notes;     ///< expected findings, such as waters left out: a line per kind
    std::vector<std::string> warnings;  ///< assumptions that may make a number wrong: a line per kind
};

/// Reads PDB, mmCIF, BinaryCIF, GROMACS, PDBQT, PQR, xyzr or xyzrn, each possibly gzipped; "-" is standard input, whose
/// format is recognised by its content.
///
/// Every coordinate, radius and charge must be a finite number and nothing else. A warning names chains of later models
/// that are partners of the first model, such as a docked ligand, and not copies of it.
///
/// throws   InputError "FILE:LINE:COLUMN: what; what to do"; UsageError for an unknown option value
/// cost     O(size of the file)
Structure read_structure(const std::string& path, const ReadOptions& options = {});

/// The same from the bytes of a file in memory.
///
/// name     tells the format, as a path would: "1abc.cif.gz"; in angle brackets ("<data>") it does not, and the content
///          tells. Messages and Structure::file have it
Structure parse_structure(std::string bytes, const std::string& name, const ReadOptions& options = {});

/// The advice that read_structure() gives where a path is not a file but an identifier of the PDB, of UniProt or of
/// AlphaFold DB: "1UBQ is not a file; Meniscus does not download: get 1ubq.cif from the PDB (...)". Else empty.
std::string explain_identifier(const std::string& path);

/// Whether each atom is selected, in the order of the atoms. The syntax is that of ReadOptions::select; names are those
/// of the structure, in which copies made by an assembly are chains of their own.
///
/// option   what messages call the option that holds the expression
/// throws   UsageError for an expression that is not valid or selects nothing
std::vector<bool> select_atoms(const Structure& structure, const std::string& expression,
                               const std::string& option = "selection");

/// How select_atoms() reads an expression that is not in gemmi's syntax, rewritten in it: "//A/10-50" for "chain A and
/// resi 10-50", "(HEM)" for "HEM" where no chain and no atom has that name. Empty for an expression taken as written.
///
/// throws   UsageError for an expression that is not valid
std::string restate_selection(const Structure& structure, const std::string& expression,
                              const std::string& option = "selection");

/// The chains of a structure, each a structure of its own with the same radii, in the order of their first atoms.
std::vector<Structure> split_chains(const Structure& structure);

/// All models of a file as structures of their own, in file order (options.model and options.join_models are ignored).
/// Structure::name ends in _m01, _m02 ...
///
/// throws   as read_structure(), for the first model that cannot be read
std::vector<Structure> read_all_models(const std::string& path, const ReadOptions& options = {});

/// The same from the bytes of a file in memory, as parse_structure() takes them.
std::vector<Structure> parse_all_models(std::string bytes, const std::string& name, const ReadOptions& options = {});

}  // namespace meniscus
