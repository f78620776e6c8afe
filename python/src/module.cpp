// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// The extension module meniscus._core.
#include "bindings.h"
#include "meniscus/version.h"

PYBIND11_MODULE(_core, module) {
    module.doc() = "Meniscus in C++; use it through the package meniscus.";
    module.attr("version") = meniscus::kVersion;
    meniscus::python::bind_errors(module);
    meniscus::python::bind_structure(module);
    meniscus::python::bind_measures(module);
    meniscus::python::bind_interfaces(module);
    meniscus::python::bind_exact_surface(module);
    meniscus::python::bind_surface(module);
    meniscus::python::bind_compare(module);
    meniscus::python::bind_pockets(module);
    meniscus::python::bind_tunnels(module);
    meniscus::python::bind_words(module);
    meniscus::python::bind_writers(module);
}
