// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/pqr_layout.h"

#include <algorithm>

#include "reading/numbers.h"
#include "reading/text.h"
#include "structure/pqr_words.h"
#include "structure/residue_number.h"

namespace meniscus::reading {
namespace {

constexpr const char* kAdvice =
    "; put blanks between them (PDB2PQR does with its option --whitespace), or write PDB2PQR's columns";

bool is_residue_number(std::string_view word) {
    RawResidue ignored;
    return set_number(word, ignored);
}

bool is_alphanumeric(char c) { return is_digit(c) || is_letter(c); }

// Where five columns are too few for a serial number, programs write stars, hexadecimal digits or hybrid-36.
bool is_serial_word(std::string_view word) {
    constexpr std::size_t kColumns = 5;
    if (integer(word) || word.find_first_not_of('*') == std::string_view::npos) return true;
    return word.size() == kColumns && std::all_of(word.begin(), word.end(), is_alphanumeric);
}

bool fits(const WordLine& line, const PqrLayout& layout) {
    if (line.size() <= layout.radius()) return false;
    const std::string_view number = line[layout.number()];
    if (!is_residue_number(number) && (layout.has_chain || !is_chain_and_number(number))) return false;
    for (std::size_t i = layout.centre(); i <= layout.radius(); ++i)
        if (!finite_number(line[i])) return false;
    return is_serial_word(line[1]);
}

[[noreturn]] void fail_grown(const WordLine& line, std::size_t i) {
    line.fail(i, shown(line[i]) + " is several words grown together" + kAdvice);
}

void check_serial(const WordLine& line) {
    if (line.size() < 2 || is_serial_word(line[1])) return;
    line.fail(1,
              "serial number " + shown(line[1]) +
                  " is not an integer; the words of a PQR atom are ATOM, serial number, name, residue, chain (may be "
                  "left out), residue number, x, y, z, charge, radius");
}

// A chain and a residue number are there, and then a word too few.
bool lacks_a_word(const WordLine& line) {
    constexpr std::size_t kWithoutChain = 10;
    return line.size() == kWithoutChain && !is_residue_number(line[4]) && !is_chain_and_number(line[4]) &&
           is_residue_number(line[5]);
}

void check_size(const WordLine& line) {
    if (line.size() >= 10 && !lacks_a_word(line)) return;
    const std::string chain = lacks_a_word(line) ? " (here " + shown(line[4]) + ")" : "";
    line.fail(line.size(), "a PQR atom has 10 words, or 11 with a chain" + chain + "; this line has " +
                               std::to_string(line.size()) + ": words are missing, or have grown together" + kAdvice);
}

// The layout that a line with an error is meant to have: a word behind the radius is an element, no number.
PqrLayout likely_layout(const WordLine& line) {
    const bool has_element = line.size() == 11 && is_residue_number(line[4]) && !finite_number(line[10]);
    return {line.size() >= 11 && !has_element};
}

}  // namespace

bool is_chain_and_number(std::string_view word) {
    return word.size() > 1 && word[0] > '9' && is_residue_number(word.substr(1));
}

std::optional<PqrLayout> fitting_layout(const WordLine& line) {
    for (const PqrLayout layout : {PqrLayout{true}, PqrLayout{false}})
        if (fits(line, layout)) return layout;
    return std::nullopt;
}

PqrLayout layout_of(const WordLine& line, const std::vector<Word>& words) {
    check_serial(line);
    if (has_grown_name(words)) fail_grown(line, 2);
    if (const auto layout = fitting_layout(line)) return *layout;
    if (const Word* grown = find_grown_numbers(words)) fail_grown(line, static_cast<std::size_t>(grown - words.data()));
    check_size(line);
    return likely_layout(line);
}

}  // namespace meniscus::reading
