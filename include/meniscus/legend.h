// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Legends: what the colours of a surface mean, for whoever draws them.
#pragma once

#include <string>
#include <vector>

#include "meniscus/colour.h"
#include "meniscus/colours.h"
#include "meniscus/mesh.h"
#include "meniscus/structure.h"

namespace meniscus {

/// A class and its colour: a chain, a kind of residue, a patch.
struct LegendEntry {
    std::string label;
    Colour colour;

    bool operator==(const LegendEntry&) const = default;
};

/// Classes with a colour each, or a ramp over a range of values; a ramp can have classes beside it.
struct Legend {
    std::string title;                   ///< "Patch", "Mean curvature, 1/Å"; empty for ColourScheme::Single
    std::vector<LegendEntry> entries{};  ///< those that occur in the mesh, in the order to be shown
    std::vector<Colour> ramp{};          ///< evenly from range.min to range.max; empty for schemes of classes
    ValueRange range{};                  ///< of the ramp
};

/// The legend of what colour_vertices() gives with the same arguments.
///
/// Labels that come from the structure (chains, elements) are as they stand in the file; "-" for a chain without name.
/// throws   UsageError for a mesh without the arrays that classes are told from: atom, patch, component
/// cost     O(n)
Legend make_legend(const Mesh& mesh, const Structure& structure, const ColourOptions& options = {});

}  // namespace meniscus
