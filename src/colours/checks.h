// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// What colours and legends ask of a mesh and of options before they begin.
#pragma once

#include <string>
#include <vector>

#include "meniscus/colours.h"
#include "meniscus/errors.h"

namespace meniscus {

/// throws   UsageError for a range that is empty or not finite, and one for a scheme that takes none
void check_options(const ColourOptions& options);

/// throws   UsageError for a mesh without atoms, or with one that the structure does not have
void check_atoms(const Mesh& mesh, const Structure& structure);

/// throws   UsageError for an array that does not have one value per vertex
template <class T>
void check_values(const std::vector<T>& values, const Mesh& mesh, const char* name) {
    if (values.size() != mesh.vertices.size())
        throw UsageError(std::string("these colours need one value of '") + name + "' per vertex");
}

}  // namespace meniscus
