// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pqr_words.h"

#include <algorithm>
#include <array>

#include "radii/aliases.h"
#include "reading/numbers.h"
#include "structure/element.h"
#include "structure/pdb_records.h"

namespace meniscus::reading {
namespace {

constexpr std::size_t kLongestName = 4;
constexpr std::size_t kNameWord = 2;    // position of the atom's name among the words
constexpr std::size_t kNumberWord = 4;  // the first word of an atom that may be a number

std::size_t length_of_record(std::string_view word) { return word.starts_with("HETATM") ? 6 : 4; }

bool is_one_decimal(std::string_view text) {
    return std::count(text.begin(), text.end(), '.') == 1 && finite_number(text).has_value();
}

// Cuts word i behind so many characters.
void cut(std::vector<Word>& words, std::size_t i, std::size_t length) {
    const Word rest{words[i].text.substr(length), words[i].column + length};
    words[i].text = words[i].text.substr(0, length);
    words.insert(words.begin() + static_cast<std::ptrdiff_t>(i) + 1, rest);
}

// Fields of one number each in columns 31-38, 39-46 and 47-54 leave no doubt: numbers that are separated by blanks do
// not stand so by chance, because a field that cuts one of them has no point, or a blank inside.
bool has_fixed_columns(std::string_view line) {
    constexpr std::size_t kEndOfZ = 54;
    if (line.size() < kEndOfZ || !trimmed(line.substr(27, 3)).empty()) return false;
    const bool reaches_over = line.size() > kEndOfZ && !is_blank(line[kEndOfZ - 1]) && !is_blank(line[kEndOfZ]);
    return is_one_decimal(line.substr(30, 8)) && is_one_decimal(line.substr(38, 8)) &&
           is_one_decimal(line.substr(46, 8)) && (!reaches_over || is_one_decimal(line.substr(kEndOfZ, 8)));
}

// Whether a word of a line in fixed columns is to be cut behind a column, over which it reaches.
bool ends_field(const Word& word, std::size_t column) {
    const std::string_view left = word.text.substr(0, column - word.column + 1);
    switch (column) {
        case 12:  // serial number | name
            return integer(left).has_value();
        case 16:  // name | residue of four letters
            return word.column >= 13 && word.column <= 14 && word.text.size() > kLongestName + 1;
        case 21:  // residue of four letters | chain
            return word.column == 18;
        case 62:  // charge | radius
            return is_one_decimal(left) && is_one_decimal(word.text.substr(left.size()));
        default:  // coordinates
            return true;
    }
}

void cut_at_columns(std::vector<Word>& words) {
    constexpr std::array<std::size_t, 7> kLastColumns{12, 16, 21, 38, 46, 54, 62};
    for (std::size_t i = 0; i < words.size(); ++i) {
        const Word word = words[i];
        const auto reaches_over = [&](std::size_t column) {
            return word.column <= column && word.column + word.text.size() > column + 1;
        };
        const auto* last = std::find_if(kLastColumns.begin(), kLastColumns.end(), [&](std::size_t column) {
            return reaches_over(column) && ends_field(word, column);
        });
        if (last != kLastColumns.end()) cut(words, i, *last - word.column + 1);
    }
}

// The columns of `gmx editconf -mead`: the chain follows the residue, and its number the chain, without a blank.
struct PqrField {
    std::size_t first;  // offset
    std::size_t width;
};

constexpr auto kGromacsNames = std::to_array<PqrField>({{0, 6}, {6, 5}, {12, 4}, {16, 4}, {20, 1}, {21, 4}});
constexpr auto kGromacsNumbers = std::to_array<PqrField>({{26, 8}, {35, 8}, {44, 8}, {53, 6}, {60, 6}});

// A blank in front of every number, and one number in every field.
bool has_gromacs_columns(std::string_view line) {
    constexpr std::size_t kEndOfRadius = 66;
    if (line.size() < kEndOfRadius || !integer(line.substr(21, 4)) || trimmed(line.substr(16, 4)).empty()) return false;
    return std::all_of(kGromacsNumbers.begin(), kGromacsNumbers.end(), [&](const PqrField& field) {
        return is_blank(line[field.first - 1]) && is_one_decimal(line.substr(field.first, field.width));
    });
}

std::vector<Word> gromacs_words(std::string_view line) {
    std::vector<Word> words;
    const auto take = [&](const PqrField& field) {
        const std::string_view text = line.substr(field.first, field.width);
        const std::size_t begin = text.find_first_not_of(" \t");
        if (begin != std::string_view::npos) words.push_back({trimmed(text), field.first + begin + 1});
    };
    for (const PqrField& field : kGromacsNames) take(field);
    for (const PqrField& field : kGromacsNumbers) take(field);
    return words;
}

// "HD21ASN": no name is so long, and none ends with a residue.
void cut_name(std::vector<Word>& words) {
    if (words.size() <= kNameWord || words[kNameWord].text.size() <= kLongestName) return;
    const std::string word = upper_case(words[kNameWord].text);
    for (std::size_t length = kLongestName; length > 0; --length) {
        const std::string residue = word.substr(length);
        const bool is_known = is_amino_acid(residue) || is_nucleotide(residue) || is_water(residue);
        if (residue.size() < 3 || !is_known) continue;
        cut(words, kNameWord, length);
        return;
    }
}

}  // namespace

PqrLine kind_of_pqr_line(std::string_view line) {
    const std::string_view text = trimmed(line);
    if (text.empty() || text[0] == '#') return PqrLine::Known;
    const std::string word = upper_case(text.substr(0, text.find_first_of(" \t")));
    if (word.starts_with("HETATM")) return PqrLine::Atom;
    const std::string letters(word.begin(), std::find_if_not(word.begin(), word.end(), is_capital));
    if (letters == "ATOM") return PqrLine::Atom;
    return is_record_name(letters) || letters == "BOX" ? PqrLine::Known : PqrLine::Unknown;
}

std::vector<Word> pqr_words(std::string_view line) {
    if (has_gromacs_columns(line)) return gromacs_words(line);
    std::vector<Word> words = words_of(line);
    if (words.empty()) return words;
    const std::size_t record = length_of_record(upper_case(words[0].text));
    if (words[0].text.size() > record) cut(words, 0, record);
    if (has_fixed_columns(line)) cut_at_columns(words);
    cut_name(words);
    return words;
}

const Word* find_grown_numbers(const std::vector<Word>& words) {
    const auto has_two_points = [](const Word& word) {
        return std::count(word.text.begin(), word.text.end(), '.') > 1;
    };
    const std::size_t first = std::min(kNumberWord, words.size());
    const auto found = std::find_if(words.begin() + static_cast<std::ptrdiff_t>(first), words.end(), has_two_points);
    return found == words.end() ? nullptr : &*found;
}

bool has_grown_name(const std::vector<Word>& words) {
    constexpr std::size_t kWords = 10;  // of an atom without a chain
    if (words.size() <= kNameWord + 1 || words[kNameWord].text.size() <= kLongestName) return false;
    return words.size() < kWords || (words.size() == kWords && words[kNameWord + 1].text.size() == 1);
}

bool may_be_atom(std::string_view line) {
    const std::vector<Word> words = words_of(line);
    const auto numbers =
        std::count_if(words.begin(), words.end(), [](const Word& word) { return is_one_decimal(word.text); });
    return (words.size() >= 9 && words.size() <= 12) || numbers >= 3;
}

}  // namespace meniscus::reading
