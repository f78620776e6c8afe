// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Options that come from Python as a dict: only those that were given are in it.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <array>
#include <string>
#include <utility>

#include "meniscus/errors.h"

namespace meniscus::python {

namespace py = pybind11;

/// Words and what they stand for, as on the command line.
template <class T, std::size_t N>
using Words = std::array<std::pair<const char*, T>, N>;

template <class T, std::size_t N>
const char* word_for(const Words<T, N>& words, T value) {
    for (const auto& [word, meaning] : words)
        if (meaning == value) return word;
    return "";
}

/// throws   UsageError for a text that is none of the words
template <class T, std::size_t N>
T parse_word(const std::string& option, const std::string& text, const Words<T, N>& words) {
    std::string known;
    for (const auto& [word, meaning] : words) {
        if (text == word) return meaning;
        known.append(known.empty() ? "" : ", ").append(word);
    }
    throw UsageError(option + ": unknown value '" + text + "'; one of " + known);
}

class Options {
public:
    explicit Options(const py::dict& given) : given_(given) {}

    template <class T>
    void read(const char* name, T& target) const {
        if (given_.contains(name)) target = given_[name].cast<T>();
    }

    template <class T, std::size_t N>
    void read_word(const char* name, T& target, const Words<T, N>& words) const {
        if (given_.contains(name)) target = parse_word(name, given_[name].cast<std::string>(), words);
    }

private:
    const py::dict& given_;
};

}  // namespace meniscus::python
