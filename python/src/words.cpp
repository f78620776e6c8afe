// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The words of choices, with which the tests compare the types that Python knows.
#include <cstddef>

#include "bindings.h"
#include "meniscus/describe_pockets.h"
#include "meniscus/file_words.h"

namespace meniscus::python {

namespace py = pybind11;

namespace {

template <class T, std::size_t N>
py::tuple words_of(const Words<T, N>& words) {
    py::tuple all(N);
    for (std::size_t i = 0; i < N; ++i) all[i] = words[i].first;
    return all;
}

}  // namespace

void bind_words(py::module_& module) {
    py::dict words;
    words["hydrogens"] = words_of(kHydrogenWords);
    words["hetero"] = words_of(kHeteroWords);
    words["field"] = words_of(kFieldWords);
    words["per"] = words_of(kRowsPerWords);
    words["interpolation"] = words_of(kInterpolationWords);
    words["rank"] = words_of(kPocketRankWords);
    words["pocket_field"] = words_of(kPocketFieldWords);
    words["color"] = words_of(kColourSchemeWords);
    module.attr("words") = words;
}

}  // namespace meniscus::python
