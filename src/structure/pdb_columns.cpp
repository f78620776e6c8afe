// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pdb_columns.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "reading/numbers.h"
#include "reading/text.h"

namespace meniscus::reading {
namespace {

constexpr std::size_t kX = 30;     // offset of the columns of x; y and z follow
constexpr std::size_t kWidth = 8;  // of a coordinate
constexpr std::size_t kEnd = 54;   // offset behind z
constexpr std::size_t kPoint = 4;  // offset of the decimal point in its columns, of three decimals

constexpr std::string_view kWhere = "the PDB format has x, y and z in columns 31-38, 39-46 and 47-54";

bool is_of_number(char c) { return is_digit(c) || c == '.'; }

char at(std::string_view line, std::size_t offset) { return offset < line.size() ? line[offset] : ' '; }

// Decimal points of the first three numbers behind the names.
struct Points {
    std::array<std::size_t, 3> offsets{};
    std::size_t count = 0;

    explicit Points(std::string_view line) {
        constexpr std::size_t kBehindNames = 16;
        for (std::size_t i = kBehindNames; i < line.size() && count < offsets.size(); ++i) {
            if (line[i] == '.' && (is_digit(at(line, i - 1)) || is_digit(at(line, i + 1)))) offsets[count++] = i;
        }
    }

    // From the first'th on.
    bool are_evenly_spaced(std::size_t first = 0) const {
        if (count < offsets.size()) return false;
        for (std::size_t i = first + 1; i < offsets.size(); ++i)
            if (offsets[i] != offsets[i - 1] + kWidth) return false;
        return true;
    }

    bool are_usual_before(std::size_t end) const {
        for (std::size_t i = 0; i < end; ++i)
            if (offsets[i] != kX + i * kWidth + kPoint) return false;
        return true;
    }
};

int decimals_behind(std::string_view line, std::size_t point) {
    int count = 0;
    while (is_digit(at(line, ++point))) ++count;
    return count;
}

// How many columns too far to the right all coordinates end from the first'th on; 0 if not all alike. Numbers without a
// blank between them seem to have more decimals than they have.
int common_shift(std::string_view line, const Points& points, std::size_t first = 0) {
    if (!points.are_evenly_spaced(first)) return 0;
    int decimals = decimals_behind(line, points.offsets[first]);
    for (std::size_t i = first; i < points.count; ++i)
        decimals = std::min(decimals, decimals_behind(line, points.offsets[i]));
    const std::size_t last_column = kX + (first + 1) * kWidth - 1;
    return static_cast<int>(points.offsets[first]) + decimals - static_cast<int>(last_column);
}

struct Field {
    const char* what;
    std::size_t first;  // offset
    std::size_t last;
};

// The fields in front of x that an overlong entry may outgrow.
constexpr auto kFields = std::to_array<Field>({
    {"serial number", 6, 10},
    {"atom name", 12, 15},
    {"residue name", 17, 19},
    {"chain name", 21, 21},
    {"residue number", 22, 25},
    {"chain and residue number", 21, 25},
});

bool outgrows(const Field& field, std::size_t begin, std::size_t end, int shift) {
    const bool is_serial = field.last == kFields[0].last;  // it stands at the right end of its columns
    return (is_serial ? begin <= field.last : begin == field.first) &&
           end == field.last + 1 + static_cast<std::size_t>(shift);
}

// The entry whose width explains a shift, if one does.
std::optional<ColumnFault> find_cause(std::string_view line, int shift) {
    Words words(line);
    for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
        const std::size_t begin = words.column() - 1;
        for (const Field& field : kFields) {
            if (shift > 0 && outgrows(field, begin, begin + word.size(), shift))
                return ColumnFault{begin + 1, std::string(" from the ") + field.what + " " + shown(word) +
                                                  " on, which is too wide for its columns"};
        }
    }
    return std::nullopt;
}

std::string by_columns(int shift) {
    return "columns are shifted by " + std::to_string(std::abs(shift)) + (shift > 0 ? " to the right" : " to the left");
}

constexpr const char* kWayOut = "; put each entry into its own columns, or write mmCIF";

bool has_names_in_place(std::string_view line) {
    return is_digit(at(line, 25)) && line.substr(std::min<std::size_t>(27, line.size()), 3) == "   ";
}

// What follows the coordinates may be missing.
bool has_occupancy_in_place(std::string_view line) {
    constexpr std::size_t kOccupancyPoint = 57;
    return trimmed(line.substr(std::min(kEnd, line.size()), 12)).empty() || at(line, kOccupancyPoint) == '.' ||
           std::count(line.begin() + static_cast<std::ptrdiff_t>(kEnd), line.end(), '.') == 0;
}

std::optional<ColumnFault> find_common_shift(std::string_view line, const Points& points) {
    const int shift = common_shift(line, points);
    // Coordinates alone may be written to the left of their columns.
    const bool are_left =
        shift < 0 && has_names_in_place(line) && points.offsets[0] >= kX && has_occupancy_in_place(line);
    if (shift == 0 || are_left) return std::nullopt;
    const std::optional<ColumnFault> cause = find_cause(line, shift);
    if (cause) return ColumnFault{cause->column, by_columns(shift) + cause->message + kWayOut};
    const bool is_x = shift > 0 && has_names_in_place(line);
    return ColumnFault{kX + 1,
                       by_columns(shift) + (is_x ? " from the x coordinate on" : "") + "; " + std::string(kWhere)};
}

// A number too wide for y's or z's columns leaves the ones before it where they are.
std::optional<ColumnFault> find_later_shift(std::string_view line, const Points& points) {
    for (const std::size_t first : {1, 2}) {
        const int shift = common_shift(line, points, first);
        if (shift <= 0 || shift > static_cast<int>(kPoint) || !points.are_usual_before(first)) continue;
        return ColumnFault{kX + first * kWidth + 1, by_columns(shift) + " from the " + (first == 1 ? "y" : "z") +
                                                        " coordinate on; " + std::string(kWhere)};
    }
    return std::nullopt;
}

// Whether a number goes on behind an offset. Numbers of three decimals may fill their columns without a blank between.
bool is_split(std::string_view line, std::size_t begin) {
    const char before = at(line, begin - 1);
    const char behind = at(line, begin);
    const bool usual_before = begin == kX || at(line, begin - kWidth + kPoint) == '.';
    const bool usual_behind = begin == kEnd || at(line, begin + kPoint) == '.';
    if (begin > kX && usual_before && usual_behind) return has_fourth_decimals(line);
    const bool is_cut_off_sign = (before == '-' || before == '+') && is_of_number(behind);
    return is_cut_off_sign || (is_of_number(before) && is_of_number(behind));
}

// What is no number in x's, y's or z's columns has an error of its own.
bool are_numbers(std::string_view line) {
    for (std::size_t begin = kX; begin < kEnd; begin += kWidth)
        if (!finite_number(line.substr(std::min(begin, line.size()), kWidth))) return false;
    return true;
}

std::optional<ColumnFault> find_split(std::string_view line) {
    for (std::size_t begin = kX; begin <= kEnd; begin += kWidth) {
        if (!is_split(line, begin)) continue;
        return ColumnFault{begin + 1, "a number runs across columns " + std::to_string(begin) + " and " +
                                          std::to_string(begin + 1) + "; " + std::string(kWhere)};
    }
    return std::nullopt;
}

bool is_at_each(std::string_view line, std::size_t column_of_field) {
    return at(line, kX + column_of_field) != ' ' && at(line, kX + kWidth + column_of_field) != ' ' &&
           at(line, kX + 2 * kWidth + column_of_field) != ' ';
}

// Programs write x, y and z alike: to the right of their columns, to the left, or with points at equal distances. Of
// other numbers one may be a residue number or an occupancy that was moved here.
std::optional<ColumnFault> find_unlike(std::string_view line, const Points& points) {
    if (points.are_evenly_spaced() || is_at_each(line, kWidth - 1) || is_at_each(line, 0)) return std::nullopt;
    return ColumnFault{kX + 1,
                       "the numbers in the columns of x, y and z are not aligned alike, columns may be shifted; " +
                           std::string(kWhere)};
}

std::optional<ColumnFault> find_tab(std::string_view line) {
    const std::size_t tab = line.find('\t');
    if (tab >= kEnd) return std::nullopt;
    return ColumnFault{tab + 1, "a tab in an atom record; the PDB format has fixed columns"};
}

// Words between blanks, as many programs of one's own write them.
std::optional<ColumnFault> find_short_words(std::string_view line) {
    if (line.size() >= kEnd || !has_coordinates(line)) return std::nullopt;
    return ColumnFault{line.size() + 1,
                       "the record has its words between blanks instead of in columns; " + std::string(kWhere)};
}

bool is_decimal(std::string_view word) {
    return word.find('.') != std::string_view::npos && finite_number(word).has_value();
}

}  // namespace

std::optional<ColumnFault> find_column_fault(std::string_view line) {
    const Points points(line);
    if (auto fault = find_tab(line)) return fault;
    if (auto fault = find_common_shift(line, points)) return fault;
    if (auto fault = find_later_shift(line, points)) return fault;
    if (auto fault = find_short_words(line)) return fault;
    if (!are_numbers(line)) return std::nullopt;
    if (auto fault = find_split(line)) return fault;
    return find_unlike(line, points);
}

bool has_coordinates(std::string_view line) {
    constexpr int kWanted = 3;
    if (Points(line).are_evenly_spaced()) return true;
    Words words(line);
    int in_a_row = 0;
    for (std::string_view word = words.next(); !word.empty() && in_a_row < kWanted; word = words.next())
        in_a_row = is_decimal(word) ? in_a_row + 1 : 0;
    return in_a_row == kWanted;
}

}  // namespace meniscus::reading
