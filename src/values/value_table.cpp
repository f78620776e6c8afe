// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "meniscus/vertex_values.h"
#include "reading/csv.h"
#include "reading/numbers.h"
#include "reading/read_bytes.h"
#include "values/identity_index.h"

namespace meniscus {
namespace {

using reading::CsvCell;
using reading::CsvRow;
using reading::fail_at;
using reading::shown;

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// Columns that are neither identity nor values: tables of atoms have them.
constexpr std::array kPassedOver{"x", "y", "z", "radius", "element"};

/// Which columns of a file are what.
struct Columns {
    std::map<std::string, std::size_t> identity;
    std::vector<std::size_t> values;
};

double value_in(const CsvCell& cell, const std::string& column, const std::string& file) {
    const std::string_view text = reading::trimmed(cell.text);
    if (text.empty() || text == "NA" || text == "nan" || text == "NaN") return kNone;
    if (text == "true" || text == "True" || text == "TRUE") return 1.0;
    if (text == "false" || text == "False" || text == "FALSE") return 0.0;
    const auto number = reading::finite_number(text);
    if (number && std::abs(*number) <= double{std::numeric_limits<float>::max()}) return *number;
    fail_at(file, cell.place,
            "column " + shown(column) + " holds " + shown(text) +
                ", which is not a number within single precision; leave the column out, or the cell empty");
}

class TableReader {
public:
    TableReader(const std::string& path, const Structure& structure)
        : file_(path), structure_(structure), index_(structure) {}

    ValueTable read() {
        std::string text = reading::read_unzipped(file_, "table of values");
        reading::normalise_line_ends(text);
        const std::vector<CsvRow> rows = reading::read_csv(text, file_);
        if (rows.empty()) throw InputError(file_ + ": is empty; write a header line and one line per residue or atom");
        read_names(rows.front());
        for (const CsvRow& row : std::span(rows).subspan(1)) read_row(row);
        copy_to_assembly();
        return std::move(table_);
    }

private:
    void read_names(const CsvRow& row) {
        std::set<std::string> seen;
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string name(reading::trimmed(row[c].text));
            names_.push_back(name);
            if (!seen.insert(name).second)
                fail_at(file_, row[c].place, "a second column " + shown(name) + "; rename one of them");
            if (IdentityIndex::is_identity(name))
                columns_.identity[name] = c;
            else if (std::find(kPassedOver.begin(), kPassedOver.end(), name) == kPassedOver.end())
                add_values(name, row[c], c);
        }
        if (columns_.values.empty())
            fail_at(file_, row.front().place, "no column of values; add one beside chain, resnum, ...");
        if (const std::string missing = index_.missing_columns(columns_.identity); !missing.empty())
            fail_at(file_, row.front().place, missing);
    }

    void add_values(const std::string& name, const CsvCell& cell, std::size_t column) {
        if (!is_value_name(name))
            fail_at(file_, cell.place,
                    shown(name) +
                        " cannot be the name of values; write letters, digits and '_', not the name of "
                        "another vertex array");
        columns_.values.push_back(column);
        table_.columns.push_back({name, std::vector<double>(structure_.labels.size(), kNone)});
    }

    void read_row(const CsvRow& row) {
        if (row.size() != names_.size())
            fail_at(file_, row.front().place,
                    "has " + std::to_string(row.size()) + " cells under " + std::to_string(names_.size()) + " names");
        ++table_.rows;
        const auto cell = [&](const std::string& column) -> const CsvCell* {
            const auto found = columns_.identity.find(column);
            return found == columns_.identity.end() ? nullptr : &row[found->second];
        };
        const std::vector<std::uint32_t> atoms = index_.atoms_of(cell, file_);
        if (atoms.empty()) ++table_.strange_rows;
        claim(atoms, row);
        for (std::size_t i = 0; i < columns_.values.size(); ++i) {
            const std::size_t c = columns_.values[i];
            const double value = value_in(row[c], names_[c], file_);
            for (const std::uint32_t atom : atoms) table_.columns[i].of_atom[atom] = value;
        }
    }

    /// A table of what was deposited is about its copies, too, unless it has rows of theirs.
    void copy_to_assembly() {
        for (std::uint32_t atom = 0; atom < line_of_.size(); ++atom) {
            const auto original = line_of_[atom] == 0 ? index_.original_of(atom) : std::nullopt;
            if (!original) continue;
            for (AtomValues& column : table_.columns) column.of_atom[atom] = column.of_atom[*original];
        }
    }

    /// No two rows may be about the same atom.
    void claim(const std::vector<std::uint32_t>& atoms, const CsvRow& row) {
        line_of_.resize(structure_.labels.size());
        for (const std::uint32_t atom : atoms) {
            if (line_of_[atom] != 0)
                fail_at(file_, row.front().place,
                        "repeats the atoms or residue of line " + std::to_string(line_of_[atom]) +
                            "; leave one of them out");
            line_of_[atom] = row.front().place.line;
        }
    }

    const std::string& file_;
    const Structure& structure_;
    IdentityIndex index_;
    Columns columns_;
    std::vector<std::string> names_;
    std::vector<std::size_t> line_of_;
    ValueTable table_;
};

}  // namespace

ValueTable read_value_table(const std::string& path, const Structure& structure) {
    return TableReader(path, structure).read();
}

void refuse_strange_table(const ValueTable& table, const std::string& path, const Structure& structure) {
    if (table.rows == table.strange_rows)
        throw InputError(path + ": no row matches anything of " + structure.file +
                         "; does the table belong to another structure?");
}

}  // namespace meniscus
