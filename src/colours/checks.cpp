// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
#include "colours/checks.h"

#include <cmath>

#include "core/parallel.h"

namespace meniscus {

void check_options(const ColourOptions& options) {
    if ((options.scheme == ColourScheme::Value) == options.value.empty())
        throw UsageError("a name of values is for the scheme of values, and for no other");
    if (options.colour && options.scheme != ColourScheme::Single)
        throw UsageError("one colour is for the scheme of one colour, and for no other");
    if (!options.range) return;
    if (!takes_range(options.scheme))
        throw UsageError("only curvature, depth, bfactor and values take a range of values");
    if (!std::isfinite(options.range->min) || !std::isfinite(options.range->max) ||
        !(options.range->min < options.range->max))
        throw UsageError("a range of values needs two finite numbers, the smaller one first");
}

void check_atoms(const Mesh& mesh, const Structure& structure) {
    check_values(mesh.atoms, mesh, "atom");
    const std::size_t n = structure.labels.size();
    if (n != structure.atoms.size() || parallel_any_of(mesh.atoms, [n](std::uint32_t a) { return a >= n; }))
        throw UsageError("the mesh names an atom that the structure does not have");
}

}  // namespace meniscus
