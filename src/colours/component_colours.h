// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Colours of the closed pieces of a mesh.
#pragma once

#include <vector>

#include "meniscus/colour.h"
#include "meniscus/mesh.h"

namespace meniscus {

/// One per component: kPlain for outer pieces, another for every cavity, known by the volume it encloses.
/// throws   UsageError for a mesh without components
/// cost     O(n)
std::vector<Colour> component_colours(const Mesh& mesh);

}  // namespace meniscus
