// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The parts of the extension module meniscus._core, one per file; what users see of them is in python/meniscus/.
#pragma once

#include <pybind11/pybind11.h>

#include <string>
#include <string_view>

namespace meniscus::python {

/// `hetero="ligands"`, `waters=True`: an option of reading as a keyword of read(), see OptionSpelling.
std::string spell_as_keyword(std::string_view option, std::string_view value);

void bind_errors(pybind11::module_& module);
void bind_structure(pybind11::module_& module);
void bind_measures(pybind11::module_& module);
void bind_interfaces(pybind11::module_& module);
void bind_exact_surface(pybind11::module_& module);
void bind_surface(pybind11::module_& module);
void bind_compare(pybind11::module_& module);
void bind_pockets(pybind11::module_& module);
void bind_tunnels(pybind11::module_& module);
void bind_words(pybind11::module_& module);
void bind_writers(pybind11::module_& module);

}  // namespace meniscus::python
