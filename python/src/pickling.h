// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Pickles of the extension's classes.
#pragma once

#include <pybind11/pybind11.h>

#include <algorithm>
#include <memory>
#include <string>

#include "archive.h"

namespace meniscus::python {

namespace py = pybind11;

/// A result as a bytes object. Other Python threads keep running meanwhile.
template <class T>
py::bytes to_bytes(const T& value) {
    std::string bytes;
    {
        const py::gil_scoped_release release;
        bytes = archived(value);
    }
    return py::bytes(bytes);
}

template <class T>
T from_bytes(const py::bytes& bytes) {
    const std::string_view view = bytes;
    const py::gil_scoped_release release;
    return from_archive<T>(view);
}

/// Lets objects of a class that is nothing but a value be pickled and copied. The two oldest protocols make objects
/// without their class's help, which pybind11 answers by ending the process: those after them are taken instead.
template <class T, class Class>
void def_pickle(Class& type) {
    type.def(py::pickle([](const T& value) { return to_bytes(value); },
                        [](const py::bytes& bytes) { return std::make_shared<T>(from_bytes<T>(bytes)); }));
    type.def("__reduce_ex__", [](const py::object& self, int protocol) {
        return py::module_::import("builtins").attr("object").attr("__reduce_ex__")(self, std::max(protocol, 2));
    });
}

}  // namespace meniscus::python
