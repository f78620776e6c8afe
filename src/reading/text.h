// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Lines, words and places in the text of a file, and the errors that name them.
#pragma once

#include <algorithm>
#include <string>
#include <string_view>

#include "meniscus/errors.h"

namespace meniscus::reading {

/// A place in a file; line and column count from 1.
struct Place {
    std::size_t line = 1;
    std::size_t column = 1;
};

/// throws   InputError "FILE:LINE:COLUMN: message"
[[noreturn]] void fail_at(const std::string& file, Place place, const std::string& message);

/// Where the first byte stands that is no printable character of ASCII; npos if there is none.
std::size_t find_unprintable(std::string_view text);

/// The text with '?' for every such byte, as it may stand in a message; what is longer than `at_most` is cut.
std::string printable(std::string_view text, std::size_t at_most = std::string_view::npos);

/// Of a word that is shown, bytes.
inline constexpr std::size_t kOfWord = 40;

/// A word as it may stand in a message: printable, in quotes, cut short.
std::string shown(std::string_view word);

/// "1 atom", "5 atoms".
inline std::string counted(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

/// Walks through a text whose lines end with '\n'.
class Lines {
public:
    explicit Lines(std::string_view text) : text_(text) {}

    /// Moves to the next line; false at the end. A last line without '\n' counts, an empty rest does not.
    bool next() {
        if (start_ >= text_.size()) return false;
        begin_ = start_;
        const std::size_t end = std::min(text_.find('\n', start_), text_.size());
        line_ = text_.substr(start_, end - start_);
        start_ = end + 1;
        ++number_;
        return true;
    }

    std::string_view line() const { return line_; }
    std::size_t number() const { return number_; }  ///< of the line, from 1
    std::size_t begin() const { return begin_; }    ///< offset of the line in the text
    std::size_t end() const { return start_; }      ///< offset of the line after it

private:
    std::string_view text_;
    std::string_view line_;
    std::size_t start_ = 0;
    std::size_t begin_ = 0;
    std::size_t number_ = 0;
};

/// Walks through the blank-separated words of a line.
class Words {
public:
    explicit Words(std::string_view line) : line_(line) {}

    /// The next word; empty at the end of the line.
    std::string_view next();

    /// Column of the last word, from 1; at the end of the line, the column after it.
    std::size_t column() const { return column_; }

private:
    std::string_view line_;
    std::size_t position_ = 0;
    std::size_t column_ = 1;
};

/// Every '\r\n' and lone '\r' becomes '\n', in place; a UTF-8 byte order mark is removed.
void normalise_line_ends(std::string& text);

}  // namespace meniscus::reading
