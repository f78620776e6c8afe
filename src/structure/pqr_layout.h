// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Which word of a PQR atom is what: the format has no columns, and a chain may be there or not.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "structure/word_line.h"

namespace meniscus::reading {

/// Where the words of an atom are: a chain moves those behind it by one.
struct PqrLayout {
    bool has_chain = false;

    std::size_t number() const { return has_chain ? 5 : 4; }
    std::size_t centre() const { return number() + 1; }
    std::size_t charge() const { return number() + 4; }
    std::size_t radius() const { return number() + 5; }
};

/// "A1000": a chain and the number behind it.
bool is_chain_and_number(std::string_view word);

/// The layout in which every word of the line is what it should be; none if there is no such layout.
std::optional<PqrLayout> fitting_layout(const WordLine& line);

/// The layout of an atom's line, also of one with an error that reading its words will tell.
/// words    of the same line, from pqr_words()
/// throws   InputError if words are missing or have grown together
PqrLayout layout_of(const WordLine& line, const std::vector<Word>& words);

}  // namespace meniscus::reading
