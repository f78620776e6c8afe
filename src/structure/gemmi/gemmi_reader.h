// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The parsers of PDB and mmCIF, and the selection syntax. gemmi_reader.cpp is the only file that includes gemmi,
// which compiles slowly.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "structure/pdb_screen.h"
#include "structure/raw_model.h"

namespace meniscus::reading {

/// Parses a screened PDB model.
/// throws   InputError
RawModel parse_pdb(const CleanPdb& clean, const std::string& file);

/// An mmCIF file, parsed; its atoms are checked when a model is asked for.
class CifFile {
public:
    /// throws   InputError with the place of a syntax error; if there are no coordinates
    CifFile(const std::string& text, const std::string& file);
    ~CifFile();
    CifFile(const CifFile&) = delete;
    CifFile& operator=(const CifFile&) = delete;

    /// Models in the file, told apart by pdbx_PDB_model_num.
    int model_count() const;

    /// The model at a position, from 1. Precondition: 1 <= position <= model_count().
    /// throws   InputError with the line and column of a value that is no finite number
    RawModel model(int position) const;

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

/// For each atom, whether it is in the selection (gemmi's syntax: /model/chain/10-50/CA[C]:A;q>0.5).
///
/// model_position  what a model number in the expression is compared with
/// option          named in messages
/// throws          UsageError if the expression is not valid
std::vector<bool> selected_atoms(const RawModel& model, const std::string& expression, int model_position,
                                 const std::string& option = "--select");

}  // namespace meniscus::reading
