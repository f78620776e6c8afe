// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// A line of a file of blank-separated words that know their columns, and the numbers and names in it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "meniscus/vec3.h"

namespace meniscus::reading {

struct Word {
    std::string_view text;
    std::size_t column = 1;  ///< of its first character
};

/// The words of a line; what follows a '#' is a comment.
std::vector<Word> words_of(std::string_view line);

class WordLine {
public:
    /// The file's name must outlive the line.
    WordLine(const std::string& file, std::size_t number, std::vector<Word> words)
        : file_(file), number_(number), words_(std::move(words)) {}

    std::size_t size() const { return words_.size(); }
    std::string_view operator[](std::size_t i) const { return words_[i].text; }

    /// Word i as a name, as it may go into messages, tables and pages.
    /// throws   InputError for bytes that are no printable characters
    std::string_view name(std::size_t i) const;

    /// throws   InputError with the place of word i, or of the end of the line if it has no such word
    [[noreturn]] void fail(std::size_t i, const std::string& message) const;

    /// Word i as a finite number.
    /// what     named in messages: "charge"
    /// throws   InputError if it is none or is missing
    double number(std::size_t i, const char* what) const;

    /// The same of a length in Å, which is refused where nothing could be computed with it.
    double length(std::size_t i, const char* what) const;

    /// The same of a length that is not negative.
    double radius(std::size_t i) const;

    /// The coordinates in word i and the two after it.
    Vec3 centre(std::size_t i) const;

private:
    const std::string& file_;
    std::size_t number_;
    std::vector<Word> words_;
};

}  // namespace meniscus::reading
