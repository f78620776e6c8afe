// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// How pictures and pages are drawn, from the dicts of python/meniscus/_writing.py.
#pragma once

#include <pybind11/pybind11.h>

#include <array>
#include <optional>

#include "meniscus/picture.h"
#include "meniscus/vec3.h"

namespace meniscus::python {

namespace py = pybind11;

inline Vec3 vector_of(const std::array<double, 3>& v) { return {v[0], v[1], v[2]}; }

/// Whether ligands are drawn.
bool with_ligands(const py::dict& given);

std::optional<Viewpoint> viewpoint_of(const py::dict& given);
Projection projection_of(const py::dict& given);
PictureOptions picture_options(const py::dict& given);

}  // namespace meniscus::python
