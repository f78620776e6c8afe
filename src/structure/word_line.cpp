// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "structure/word_line.h"

#include <cmath>

#include "core/largest_length.h"
#include "reading/numbers.h"
#include "reading/text.h"

namespace meniscus::reading {

std::vector<Word> words_of(std::string_view line) {
    std::vector<Word> found;
    Words words(line.substr(0, line.find('#')));
    for (std::string_view word = words.next(); !word.empty(); word = words.next())
        found.push_back({word, words.column()});
    return found;
}

std::string_view WordLine::name(std::size_t i) const {
    if (find_unprintable(words_[i].text) != std::string_view::npos)
        fail(i, "a byte that is not a printable character in the name " + shown(words_[i].text) + "; correct it");
    return words_[i].text;
}

void WordLine::fail(std::size_t i, const std::string& message) const {
    std::size_t column = 1;
    if (i < words_.size())
        column = words_[i].column;
    else if (!words_.empty())
        column = words_.back().column + words_.back().text.size();
    fail_at(file_, {number_, column}, message);
}

double WordLine::number(std::size_t i, const char* what) const {
    if (i >= words_.size()) fail(i, std::string("the ") + what + " is missing; the line ends too early");
    const auto value = finite_number(words_[i].text);
    if (!value) fail(i, std::string(what) + " " + shown(words_[i].text) + " is not a finite number; correct it");
    return *value;
}

double WordLine::length(std::size_t i, const char* what) const {
    const double value = number(i, what);
    if (std::abs(value) > kLargestLength)
        fail(i, std::string(what) + " " + shown(words_[i].text) + " is more than 1e12 Å; correct it");
    return value;
}

double WordLine::radius(std::size_t i) const {
    const double value = length(i, "radius");
    if (value < 0.0) fail(i, "radius " + shown(words_[i].text) + " is negative; 0 leaves an atom out");
    return value;
}

Vec3 WordLine::centre(std::size_t i) const {
    return {length(i, "x coordinate"), length(i + 1, "y coordinate"), length(i + 2, "z coordinate")};
}

}  // namespace meniscus::reading
