// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// mmCIF and BinaryCIF files. cif_file.cpp is the only file that includes gemmi's parser of CIF, which compiles slowly.
#pragma once

#include <cstddef>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "structure/raw_model.h"

namespace meniscus::reading {

enum class CifForm { Text, Binary };

/// An mmCIF or BinaryCIF file, parsed; its atoms are checked when a model is asked for.
class CifFile {
public:
    /// bytes    have to outlive the CifFile; the lines of a text end with '\n' alone, as load_bytes leaves them
    /// throws   InputError with the place of a syntax error or of a model number that is none; if there are no
    ///          coordinates
    CifFile(const std::string& bytes, const std::string& file, CifForm form = CifForm::Text);
    ~CifFile();
    CifFile(const CifFile&) = delete;
    CifFile& operator=(const CifFile&) = delete;

    /// Models in the file, told apart by the integers of pdbx_PDB_model_num.
    int model_count() const;

    /// Names of the chains of every model, author's names where there are such.
    std::vector<std::set<std::string>> chains_of_models() const;

    /// How many rows each model has.
    std::vector<std::size_t> atoms_of_models() const;

    /// Where the model at a position begins: "line 69", or "row 21" in BinaryCIF.
    std::string place_of_model(int position) const;

    /// The model at a position, from 1. Precondition: 1 <= position <= model_count().
    /// throws   InputError with the line and column, or the row, of a value that cannot be what it is to be
    RawModel model(int position) const;

private:
    struct Content;
    std::unique_ptr<Content> content_;
};

}  // namespace meniscus::reading
