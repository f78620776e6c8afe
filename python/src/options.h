// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Options that come from Python as a dict: only those that were given are in it.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <string>

#include "meniscus/words.h"

namespace meniscus::python {

namespace py = pybind11;

class Options {
public:
    explicit Options(const py::dict& given) : given_(given) {}

    template <class T>
    void read(const char* name, T& target) const {
        if (given_.contains(name)) target = given_[name].cast<T>();
    }

    template <class Target, class T, std::size_t N>
    void read_word(const char* name, Target& target, const Words<T, N>& words) const {
        if (given_.contains(name)) target = parse_word(name, given_[name].cast<std::string>(), words);
    }

private:
    const py::dict& given_;
};

}  // namespace meniscus::python
