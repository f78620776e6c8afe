// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The rows of _atom_site as atoms and residues, from mmCIF and BinaryCIF alike.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "structure/odd_lines.h"
#include "structure/raw_model.h"

namespace meniscus::reading {

/// Columns of _atom_site in the order of atom_tags().
// clang-format off
struct AtomColumn {
    enum Index {
        X, Y, Z, Group, Id, Symbol, LabelAtom, AuthAtom, AltId, LabelComp, AuthComp, LabelAsym, AuthAsym, Entity,
        LabelSeq, AuthSeq, Insertion, Occupancy, B, Charge, ModelNumber
    };
    static constexpr std::size_t kCount = ModelNumber + 1;
};
// clang-format on

/// As gemmi wants them: those with '?' may be missing.
const std::vector<std::string>& atom_tags();

/// A parsed file and what messages about it need.
struct CifSource {
    const std::string& file;
    const std::string* text;  ///< null for BinaryCIF, which has no lines

    /// throws   InputError "PLACE: TAG 'value' MESSAGE"
    [[noreturn]] void fail(AtomColumn::Index column, std::size_t row, std::string_view value,
                           const std::string& message) const;

    /// What numbers of places count: "line", or "row" for BinaryCIF.
    std::string unit() const { return text != nullptr ? "line" : "row"; }

    /// Number of the line or the row, from 1.
    std::size_t place_of(AtomColumn::Index column, std::size_t row) const;

    static std::string tag_of(AtomColumn::Index column);
};

/// The values of _atom_site, as they are written.
class AtomTable {
public:
    static constexpr std::size_t kNone = ~std::size_t{0};
    using FirstRow = std::array<std::size_t, AtomColumn::kCount>;

    /// first    places of the first row's values; kNone for a column that the file has not
    /// stride   from a row to the next; 0 for an atom that is given in pairs and has no other row
    AtomTable(std::vector<std::string_view> values, const FirstRow& first, std::size_t stride)
        : values_(std::move(values)), first_(first), stride_(stride) {}

    std::size_t rows() const { return stride_ == 0 ? 1 : values_.size() / stride_; }

    /// Null for a column that the file has not.
    const std::string_view* at(AtomColumn::Index column, std::size_t row) const {
        const std::size_t first = first_[column];
        return first == kNone ? nullptr : &values_[first + row * stride_];
    }

    /// The same where the file says that there is no value, as '?' or '.'.
    const std::string_view* value(AtomColumn::Index column, std::size_t row) const {
        const std::string_view* const text = at(column, row);
        return text == nullptr || *text == "?" || *text == "." ? nullptr : text;
    }

private:
    std::vector<std::string_view> values_;
    FirstRow first_;
    std::size_t stride_;
};

/// Which model every row belongs to. Models are told apart by the integers of pdbx_PDB_model_num, and come in the order
/// in which the file brings them; if no row has such a number, there is one model.
class RowModels {
public:
    /// throws   InputError with the place of what is no integer where other rows have numbers
    RowModels(const CifSource& source, const AtomTable& table);

    std::size_t count() const { return models_.size(); }
    std::size_t of(std::size_t row) const { return of_row_.empty() ? 0 : of_row_[row]; }
    std::size_t first_row(std::size_t model) const { return models_[model].first_row; }
    std::size_t atoms(std::size_t model) const { return models_[model].atoms; }

private:
    struct Model {
        std::size_t first_row = 0;
        std::size_t atoms = 0;
    };

    std::vector<Model> models_;
    std::vector<std::uint32_t> of_row_;  // empty for one model
};

/// Values that are read otherwise than they are written.
struct OddValues {
    OddLines uncertain;
    OddLines charged;      ///< type_symbol with a charge
    OddLines no_elements;  ///< type_symbol that is none
    bool without_symbol = false;
    std::map<AtomColumn::Index, OddLines> no_numbers;  ///< of columns that no result needs

    void tell(const CifSource& source, RawModel& model) const;
};

/// One row of _atom_site.
class AtomRow {
public:
    AtomRow(const CifSource& source, const AtomTable& table, std::size_t index)
        : source_(source), table_(table), index_(index) {}

    bool has(AtomColumn::Index column) const { return table_.value(column, index_) != nullptr; }

    /// Empty where there is no value.
    std::string_view text(AtomColumn::Index column) const;

    /// The first of two columns that has a value: author's names before label names.
    std::string_view text(AtomColumn::Index first, AtomColumn::Index second) const {
        return text(has(first) ? first : second);
    }

    /// ' ' where there is none.
    char letter(AtomColumn::Index column, const char* remedy) const;

    double coordinate(AtomColumn::Index column, OddValues& odd) const;

    /// Of a column that no result needs.
    double number_or(AtomColumn::Index column, double otherwise, OddValues& odd) const;

    /// Sets a residue's number; old files write the insertion code behind it ("15A").
    void set_number(RawResidue& residue) const;

    /// Sets an atom's element, from its name if the file does not tell it.
    void set_element(RawAtom& atom, const std::string& residue, OddValues& odd) const;

    /// Whether all that a residue is made of is the same text.
    bool is_of_residue_of(const AtomRow& other) const;

private:
    std::optional<double> number(AtomColumn::Index column, OddValues& odd) const;
    void note(OddLines& odd, AtomColumn::Index column) const;
    [[noreturn]] void fail(AtomColumn::Index column, const std::string& message) const;

    const CifSource& source_;
    const AtomTable& table_;
    std::size_t index_;
};

using EntityIds = std::set<std::string, std::less<>>;

/// As gemmi::cif::as_string, without a copy.
std::string_view unquoted(std::string_view text);

RawResidue residue_of_row(const AtomRow& row, const EntityIds& polymers);

RawAtom atom_of_row(const AtomRow& row, const std::string& residue, OddValues& odd);

}  // namespace meniscus::reading
