// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <set>
#include <span>

#include "meniscus/vertex_values.h"
#include "reading/csv.h"
#include "reading/lower_case.h"
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

/// The column by which tables of interfaces tell which one a row is about.
constexpr const char* kInterface = "interface";
constexpr std::size_t kMostInterfaces = 1000;

/// Which columns of a file are what.
struct Columns {
    std::map<std::string, std::size_t> identity;
    std::vector<std::size_t> values;
    std::optional<std::size_t> interface;  ///< only where a table is about several
};

bool is_no_value(std::string_view text) { return text.empty() || text == "NA" || text == "nan" || text == "NaN"; }

std::optional<bool> truth_in(std::string_view text) {
    if (text == "true" || text == "True" || text == "TRUE") return true;
    if (text == "false" || text == "False" || text == "FALSE") return false;
    return std::nullopt;
}

/// "0,9", as spreadsheets write 0.9 in some languages.
bool has_decimal_comma(std::string_view text) {
    std::string number(text);
    const std::size_t comma = number.find(',');
    if (comma == std::string::npos) return false;
    number[comma] = '.';
    return reading::finite_number(number).has_value();
}

/// Whether a column is text: it has cells, and none of them is a value, or was meant as one.
bool is_text(std::span<const CsvRow> rows, std::size_t column) {
    bool has_text = false;
    bool are_numbers = true;
    for (const CsvRow& row : rows) {
        if (column >= row.size()) continue;
        const std::string_view cell = reading::trimmed(row[column].text);
        if (is_no_value(cell)) continue;
        if (truth_in(cell) || reading::whole_number<double>(cell)) return false;
        has_text = true;
        are_numbers = are_numbers && has_decimal_comma(cell);
    }
    return has_text && !are_numbers;
}

/// What is left of the name of an interface where only letters, digits and '_' may stand: A_C_B of "A,C:B".
std::string as_word(const std::string& name) {
    std::string word;
    for (const char c : name) {
        const bool may_stay = std::isalnum(static_cast<unsigned char>(c)) != 0;
        if (may_stay || (!word.empty() && word.back() != '_')) word += may_stay ? c : '_';
    }
    while (!word.empty() && word.back() == '_') word.pop_back();
    return word;
}

double value_in(const CsvCell& cell, const std::string& column, const std::string& file) {
    const std::string_view text = reading::trimmed(cell.text);
    if (is_no_value(text)) return kNone;
    if (const auto truth = truth_in(text)) return *truth ? 1.0 : 0.0;
    const auto number = reading::finite_number(text);
    if (number && std::abs(*number) <= double{std::numeric_limits<float>::max()}) return *number;
    fail_at(file, cell.place,
            "column " + shown(column) + " holds " + shown(text) +
                (has_decimal_comma(text)
                     ? "; write decimals with a point"
                     : ", which is not a number within single precision; leave the column out, or the cell empty"));
}

/// Whether these are the names of a table of cavities, which `measure --per cavity` writes.
bool is_of_cavities(const CsvRow& names) {
    return std::any_of(names.begin(), names.end(), [](const CsvCell& cell) { return cell.text == "inscribed_radius"; });
}

bool is_json(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \n\t");
    return first != std::string_view::npos && (text[first] == '{' || text[first] == '[');
}

/// For columns that are named as vertex arrays of the surface are, but were meant to say what a row is about.
std::string hint_for(const std::string& name) {
    const std::string word = lower_case(name);
    return word == "residue" || word == "atom" ? "; columns that say what a row is about are " +
                                                     IdentityIndex::identity_columns() + ", in small letters"
                                               : "";
}

/// The arrays of one interface, or of a table that is about none.
struct Block {
    std::string ending;                ///< of the names of its arrays
    std::size_t first = 0;             ///< of its arrays among all
    std::vector<std::size_t> line_of;  ///< of each atom; 0 where no row is about it
};

class TableReader {
public:
    TableReader(const std::string& path, const Structure& structure)
        : file_(path), structure_(structure), index_(structure) {}

    ValueTable read() {
        std::string text = reading::read_unzipped(file_, "table of values");
        reading::normalise_line_ends(text);
        if (is_json(text)) refuse_kind("JSON");
        const std::vector<CsvRow> rows = reading::read_csv(text, file_);
        if (rows.empty()) throw InputError(file_ + ": is empty; write a header line and one line per residue or atom");
        if (is_of_cavities(rows.front())) refuse_kind("a table of cavities");
        read_names(rows);
        for (const CsvRow& row : std::span(rows).subspan(1)) read_row(row);
        if (blocks_.empty()) add_block("");
        for (const auto& [name, block] : blocks_) copy_to_assembly(block);
        return std::move(table_);
    }

private:
    [[noreturn]] void refuse_kind(const std::string& kind) const {
        throw InputError(file_ + ": is " + kind +
                         "; values are read from comma-separated tables (.csv) with a row for each atom, residue or "
                         "chain");
    }

    void read_names(std::span<const CsvRow> rows) {
        const CsvRow& first = rows.front();
        std::set<std::string> seen;
        for (std::size_t c = 0; c < first.size(); ++c) {
            names_.emplace_back(reading::trimmed(first[c].text));
            if (names_.back().empty()) continue;  // pandas' index, or a separator at the end of the line
            if (!seen.insert(names_.back()).second)
                fail_at(file_, first[c].place, "a second column " + shown(names_.back()) + "; rename one of them");
            sort_in(rows, c);
        }
        if (seen.contains("side")) find_interfaces(rows);
        if (columns_.values.empty()) refuse_table_without_values(first.front());
        if (const std::string missing = index_.missing_columns(columns_.identity); !missing.empty())
            fail_at(file_, first.front().place, missing);
    }

    void sort_in(std::span<const CsvRow> rows, std::size_t column) {
        const std::string& name = names_[column];
        if (IdentityIndex::is_identity(name))
            columns_.identity[name] = column;
        else if (std::find(kPassedOver.begin(), kPassedOver.end(), name) != kPassedOver.end())
            return;
        else if (is_text(rows.subspan(1), column))
            table_.texts.push_back(name);
        else
            add_values(rows.front()[column], column);
    }

    void add_values(const CsvCell& cell, std::size_t column) {
        if (!is_value_name(names_[column]))
            fail_at(file_, cell.place,
                    shown(names_[column]) +
                        " cannot be the name of values; write letters, digits and '_', not the name of "
                        "another vertex array" +
                        hint_for(names_[column]));
        columns_.values.push_back(column);
    }

    /// Where there is one interface only, its name tells nothing.
    void find_interfaces(std::span<const CsvRow> rows) {
        const auto text = std::find(table_.texts.begin(), table_.texts.end(), kInterface);
        if (text == table_.texts.end()) return;
        const auto column =
            static_cast<std::size_t>(std::find(names_.begin(), names_.end(), kInterface) - names_.begin());
        std::set<std::string> interfaces;
        for (const CsvRow& row : rows.subspan(1))
            if (column < row.size()) interfaces.insert(row[column].text);
        if (interfaces.size() < 2) return;
        if (interfaces.size() > kMostInterfaces)
            fail_at(file_, rows.front()[column].place,
                    "names " + std::to_string(interfaces.size()) +
                        " interfaces, each of which would have arrays of its "
                        "own; leave at most " +
                        std::to_string(kMostInterfaces));
        columns_.interface = column;
        table_.texts.erase(text);
    }

    [[noreturn]] void refuse_table_without_values(const CsvCell& cell) const {
        if (table_.texts.empty()) fail_at(file_, cell.place, "no column of values; add one beside chain, resnum, ...");
        fail_at(file_, cell.place,
                "no column of values: no cell of column " + shown(table_.texts.front()) + " is a number");
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
        Block& block = block_of(columns_.interface ? row[*columns_.interface].text : "");
        claim(block, atoms, row);
        for (std::size_t i = 0; i < columns_.values.size(); ++i) {
            const std::size_t c = columns_.values[i];
            const double value = value_in(row[c], names_[c], file_);
            for (const std::uint32_t atom : atoms) table_.columns[block.first + i].of_atom[atom] = value;
        }
    }

    Block& block_of(const std::string& interface) {
        const auto found = blocks_.find(interface);
        return found != blocks_.end() ? found->second : add_block(interface);
    }

    Block& add_block(const std::string& interface) {
        Block block{.ending = columns_.interface ? free_ending(as_word(interface)) : "",
                    .first = table_.columns.size(),
                    .line_of = std::vector<std::size_t>(structure_.labels.size())};
        for (const std::size_t column : columns_.values)
            table_.columns.push_back(
                {names_[column] + block.ending, std::vector<double>(structure_.labels.size(), kNone)});
        return blocks_.emplace(interface, std::move(block)).first->second;
    }

    /// "A:b" and "a:B", or "A,B:C" and "A:B,C", would be the same word, and "mean" of "curvature" another array's name.
    std::string free_ending(const std::string& word) const {
        std::string ending = "_" + word;
        for (int n = 2; !is_free(ending); ++n) ending = "_" + word + "_" + std::to_string(n);
        return ending;
    }

    bool is_free(const std::string& ending) const {
        return std::all_of(columns_.values.begin(), columns_.values.end(), [&](std::size_t column) {
            const std::string name = names_[column] + ending;
            return is_value_name(name) &&
                   std::none_of(table_.columns.begin(), table_.columns.end(),
                                [&](const auto& c) { return lower_case(c.name) == lower_case(name); });
        });
    }

    /// A table of what was deposited is about its copies, too, unless it has rows of theirs.
    void copy_to_assembly(const Block& block) {
        for (std::uint32_t atom = 0; atom < block.line_of.size(); ++atom) {
            const auto original = block.line_of[atom] == 0 ? index_.original_of(atom) : std::nullopt;
            if (!original) continue;
            for (std::size_t i = 0; i < columns_.values.size(); ++i) {
                std::vector<double>& values = table_.columns[block.first + i].of_atom;
                values[atom] = values[*original];
            }
        }
    }

    /// No two rows may be about the same atom, but in different interfaces.
    void claim(Block& block, const std::vector<std::uint32_t>& atoms, const CsvRow& row) {
        for (const std::uint32_t atom : atoms) {
            if (block.line_of[atom] != 0)
                fail_at(file_, row.front().place,
                        "repeats the atoms or residue of line " + std::to_string(block.line_of[atom]) +
                            "; leave one of them out");
            block.line_of[atom] = row.front().place.line;
        }
    }

    const std::string& file_;
    const Structure& structure_;
    IdentityIndex index_;
    Columns columns_;
    std::vector<std::string> names_;
    std::map<std::string, Block> blocks_;  // by the names of interfaces
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
