// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Atoms as a surface needs them: balls with a centre and a radius.
#pragma once

#include <cstddef>
#include <vector>

#include "meniscus/vec3.h"

namespace meniscus {

/// Centres (Å) and radii (Å, > 0) of the atoms, in the caller's order; both arrays have the same size.
struct Atoms {
    std::vector<Vec3> centres;
    std::vector<double> radii;

    std::size_t size() const { return centres.size(); }
    bool empty() const { return centres.empty(); }
};

}  // namespace meniscus
