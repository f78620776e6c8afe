// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The strict screen in front of the PDB parser: finds the models, checks every field that counts, reads what atoms say
// of themselves, and writes a clean text of residues, in which each record is complete, so that a parser can do nothing
// wrong with it.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "structure/pdb_line.h"
#include "structure/pdb_records.h"
#include "structure/raw_model.h"

namespace meniscus::reading {

/// A part of the text that holds the atoms of one model.
struct PdbModelSpan {
    std::size_t begin = 0;       ///< offset of its first line
    std::size_t end = 0;         ///< offset behind its last line
    std::size_t first_line = 1;  ///< number of its first line
    std::size_t atoms = 0;       ///< how many records it has of them
    std::size_t end_record = 0;  ///< number of the line with END that ends it, 0 if something else does
    ChainWidth chain_width = ChainWidth::Unknown;  ///< of the file's chains
};

/// The models of a file, in file order; ENDMDL, END and a new MODEL all end one.
struct PdbModels {
    std::vector<PdbModelSpan> spans;
    std::vector<std::string> warnings;  ///< irregular MODEL records, one line per kind
};

PdbModels find_pdb_models(std::string_view text);

/// What a line means to the models of a file.
enum class ModelLine { Atom, Model, Endmdl, End, Other };

/// The models of another format with such records, whose lines are told by a function. MODEL may stand behind blanks.
PdbModels find_models(std::string_view text, ModelLine (*kind_of)(std::string_view line));

/// Names of the chains of a model, whatever else is in its records.
std::set<std::string> chains_of(std::string_view text, const PdbModelSpan& model);

/// Chains of another model with names of the first one's that are no copies of these in the same place: less than half
/// of their residues are in the first, or less than half of their atoms lie near those of the first.
std::set<std::string> namesakes_of(std::string_view text, const PdbModelSpan& first, const PdbModelSpan& other);

/// Atoms that follow each other with the same columns of their residue and segment.
struct PdbRun {
    std::string residue;  ///< name, up to four letters
    std::string segment;
    ResidueNumber number;
};

/// A model ready for the parser.
struct CleanPdb {
    std::string text;                   ///< of run i the record of its first atom, with serial number i + 1
    std::vector<PdbRun> runs;           ///< what the text has no room for
    std::vector<RawAtom> atoms;         ///< their `residue` is the number of their run
    std::vector<std::string> warnings;  ///< fields without which results can be found; see RawModel::warnings
};

/// Checks one model and writes it clean, with the SEQRES and REMARK 350 (assembly) records of the whole text.
/// Occupancy, B factor and charge may hold anything: what is no number is missing, with a warning.
/// throws   InputError with line and column
CleanPdb screen_pdb(std::string_view text, const PdbModelSpan& model, const std::string& file, bool with_assemblies);

/// Serial number n as the PDB's five columns hold it, hybrid-36 above 99,999.
/// Precondition: 0 <= n < 87,440,032.
std::string hybrid36_serial(std::size_t n);

}  // namespace meniscus::reading
