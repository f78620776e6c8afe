// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Turns a level-set function into a signed distance near its zero set by iterating an eikonal equation.
#pragma once

#include "grid/block_grid.h"
#include "meniscus/node_field.h"

namespace meniscus {

/// Φ_v = -S G with S = Φ/sqrt(Φ² + |∇Φ|² h²) and upwind differences over `stride` nodes in G.
struct UpwindScheme {
    int stride = 2;        ///< in eq. 3.6 the differences span two nodes: odd and even ones do not see each other
    bool repaired = true;  ///< false: eq. 3.6 as printed, whose forward differences have the wrong sign
    int most_iterations = 8;
    double pseudo_step = 0.5;    ///< η, in spacings
    double least_change = 0.01;  ///< stop when the sum of |ΔΦ| falls below so many spacings (eq. 3.7)
};

/// Iterates on all nodes; values are clamped to ±width.
///
/// returns  the iterations done
/// source   Pan & Tai 2009, eqs. 3.6 and 3.7
int reinitialise_upwind(const BlockGrid& grid, double width, const UpwindScheme& scheme, NodeField& values);

}  // namespace meniscus
