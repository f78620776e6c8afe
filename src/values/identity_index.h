// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Which atoms of a structure a row of a table is about.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "meniscus/structure.h"
#include "reading/csv.h"

namespace meniscus {

/// The columns that are there, by name.
using IdentityColumns = std::map<std::string, std::size_t>;

/// The cell of a column, or nothing where the table has no such column.
using CellOf = std::function<const reading::CsvCell*(const std::string& column)>;

/// Atoms by index, by serial number, and by chain and residue.
///
/// structure   must outlive the index
class IdentityIndex {
public:
    explicit IdentityIndex(const Structure& structure);

    static bool is_identity(const std::string& column);
    /// The names of all such columns, for messages: "index, chain, ...".
    static std::string identity_columns();

    /// What is wrong with these columns, and what to do; empty if they tell atoms apart.
    std::string missing_columns(const IdentityColumns& columns) const;

    /// The atoms of a row; none if the structure does not have them.
    /// throws   InputError for a cell that is no number where one is needed, and for one that does not agree with the
    ///          structure
    std::vector<std::uint32_t> atoms_of(const CellOf& cell, const std::string& file) const;

    /// The atom that this one is a copy of, in an assembly.
    std::optional<std::uint32_t> original_of(std::uint32_t atom) const;

private:
    using ResidueKey = std::tuple<std::string, int, char>;  // chain, number, insertion code

    std::vector<std::uint32_t> by_index(const CellOf& cell, const std::string& file) const;
    std::vector<std::uint32_t> by_serial(const CellOf& cell, const std::string& file) const;
    std::vector<std::uint32_t> by_residue(const CellOf& cell, const std::string& file) const;
    std::vector<std::uint32_t> by_chain(const CellOf& cell) const;
    bool is_named(std::uint32_t atom, const CellOf& cell) const;
    void check_agreement(std::uint32_t atom, const CellOf& cell, const std::string& file) const;

    const Structure& structure_;
    std::map<std::string, std::vector<std::uint32_t>> of_chain_;
    std::map<ResidueKey, std::vector<std::uint32_t>> of_residue_;
    std::multimap<int, std::uint32_t> of_serial_;
};

}  // namespace meniscus
