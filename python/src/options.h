// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Options that come from Python as a dict: only those that were given are in it, and None is as good as not given.
#pragma once

#include <pybind11/pybind11.h>
#include <pybind11/stl.h>

#include <cstddef>
#include <string>
#include <vector>

#include "meniscus/describe_options.h"

namespace meniscus::python {

namespace py = pybind11;

class Options {
public:
    explicit Options(const py::dict& given) : given_(given) {}

    bool has(const char* name) const { return given_.contains(name) && !given_[name].is_none(); }

    template <class T>
    void read(const char* name, T& target) const {
        if (has(name)) target = given_[name].cast<T>();
    }

    template <class Target, class T, std::size_t N>
    void read_word(const char* name, Target& target, const Words<T, N>& words) const {
        if (has(name)) target = parse_word(name, text(name), words);
    }

    py::object operator[](const char* name) const { return given_[name]; }

    /// throws   TypeError for what is not text
    std::string text(const char* name) const;

private:
    const py::dict& given_;
};

/// Reads those that were given of the options that a description of describe_options.h visits.
///
/// throws   TypeError for values of another type, UsageError for numbers out of range and unknown words
class OptionReader {
public:
    explicit OptionReader(const py::dict& given) : given_(given) {}

    void operator()(const Option& option, bool& target);
    void operator()(const Option& option, double& target);
    void operator()(const Option& option, int& target);
    void operator()(const Option& option, std::size_t& target);
    void operator()(const Option& option, double& target, double (*of)(double));
    void operator()(const Option& option, FlowOptions& flow, const Words<FlowName, 3>& words) {
        FlowName name = flow.name;
        (*this)(option, name, words);
        flow = flow_of(name);
    }
    template <class T, std::size_t N>
    void operator()(const Option& option, T& target, const Words<T, N>& words) {
        const T before = target;
        given_.read_word(option.name, target, words);
        if (target != before) changed_.push_back(option);
    }

    /// Options that do not have their default values.
    const std::vector<Option>& changed() const { return changed_; }

private:
    double number(const Option& option) const;
    template <class T>
    void set(const Option& option, T& target, T value) {
        if (target != value) changed_.push_back(option);
        target = value;
    }

    Options given_;
    std::vector<Option> changed_;
};

}  // namespace meniscus::python
