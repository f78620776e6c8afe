// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Legends: what the colours of a surface mean.
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

/// A title, and classes with a colour each, a colour ramp for a range of values, or both.
struct Legend {
    std::string title;                   ///< such as "Mean curvature, 1/Å"; empty for ColourScheme::Single
    std::vector<LegendEntry> entries{};  ///< classes that occur in the mesh, in the order to be shown
    std::vector<Colour> ramp{};          ///< colours evenly spaced from range.min to range.max; may be empty
    ValueRange range{};                  ///< values at the ends of the ramp
};

/// The legend of the colours that colour_vertices() gives with the same arguments.
///
/// Labels from the structure (chains, elements) are as in the file; "-" stands for a chain without a name.
///
/// throws   UsageError for a mesh without the arrays by which vertices are classified: atoms, patches, components
/// cost     O(n)
Legend make_legend(const Mesh& mesh, const Structure& structure, const ColourOptions& options = {});

}  // namespace meniscus
