// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: Apache-2.0
// Colours of a surface: what a vertex lies on, told by the palettes that docs/conventions.md names.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meniscus/colour.h"
#include "meniscus/exact_surface.h"
#include "meniscus/level_set.h"
#include "meniscus/mesh.h"
#include "meniscus/structure.h"

namespace meniscus {

struct ColourOptions {
    ColourScheme scheme = ColourScheme::Automatic;
    std::optional<ValueRange> range{};  ///< Curvature, BFactor, Depth and Value only; nothing: default_range()
    std::string value{};                ///< Value only
    std::optional<Colour> colour{};     ///< Single only; nothing: light blue

    bool operator==(const ColourOptions&) const = default;
};

/// Radius of the probe that cannot enter what ColourScheme::Depth calls deep, Å.
inline constexpr double kDepthProbe = 10.0;

/// The colour that people write as one of the names of CSS ("tomato", in any case) or as "#rrggbb"; nothing for any
/// other text. source   CSS Color Module Level 4, W3C 2022, section 6.1; without its words for transparency
std::optional<Colour> colour_of_text(std::string_view text);

/// How deep in pockets and cavities every vertex lies, Å: its distance within the SES of a probe of kDepthProbe, 0
/// outside. The array has the name "depth".
///
/// exact    of the atoms, with any probe
/// cost     that of asking ExactSurface::of_same_atoms() for every vertex
VertexValues depth_values(const Mesh& mesh, const ExactSurface& exact);

/// The scheme that Automatic stands for; any other stands for itself.
ColourScheme scheme_in_force(ColourScheme scheme, const Structure& structure);

/// True for schemes of numbers: curvature, depth, B factor and values.
bool takes_range(ColourScheme scheme);

/// The range of a scheme of values unless another is given: curvature -0.7 to 0.7, depth 0 to 10, B factors the
/// smallest to the largest of the kept atoms.
ValueRange default_range(ColourScheme scheme, const Structure& structure);

/// What is asked for, or the scheme's own; of values, what range_of() says.
/// throws   UsageError for values that the mesh does not have
ValueRange range_in_force(const ColourOptions& options, const Mesh& mesh, const Structure& structure);

/// One colour per vertex, opaque.
///
/// mesh     with `atoms`, which index the structure's atoms, and the array that the scheme shows
/// throws   UsageError for an array that is missing, an atom that the structure does not have, a range that is empty
///          or not finite, and one for a scheme that takes none
/// cost     O(n); Depth also that of depth_values(), unless the mesh has values of this name: then these are shown
std::vector<Colour> colour_vertices(const Mesh& mesh, const Structure& structure, const ColourOptions& options = {});

/// Colours of values that have a middle: blue, white, red; those that are no numbers are grey.
/// throws   UsageError for a range that is empty or not finite
std::vector<Colour> colour_values(std::span<const float> values, const ValueRange& range);

/// The colours of colour_vertices() at any point, by the point's nearest feature: sharp borders between patches and
/// between atoms. Curvature is that of the exact surface.
///
/// surface  of the structure's atoms
/// returns  nothing for Component, Depth and Value
/// throws   as colour_vertices
/// cost     of a call: O(log n) per point, and a tenth of that for points next to each other
ColourField colour_by_feature(const ExactSurface& surface, const Structure& structure,
                              const ColourOptions& options = {});

/// Colours by the curvature of the level set through a point.
///
/// level_set  must outlive the field; points outside its band get the colour of the lowest curvature
/// returns    nothing for schemes other than Curvature
/// throws     as colour_vertices
ColourField colour_by_level_set(const LevelSet& level_set, const ColourOptions& options);

}  // namespace meniscus
